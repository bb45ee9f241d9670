#!/usr/bin/env bash
# pip builds and installs the package from a checkout, downloading nothing, and it works far from the source:
# check_pip_install.sh PYTHON SOURCE
set -euo pipefail
python=$1 source=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$python" -m venv --without-pip --system-site-packages "$work/venv"
"$python" -m pip --python "$work/venv/bin/python" install --quiet --no-index "$source"
cd "$work"
# Without a trace of the build folder.
env -u PYTHONPATH "$work/venv/bin/python" - <<'PROGRAM'
import numpy as np
import runmark
assert "/venv/" in runmark.__file__, runmark.__file__
image = np.pad(runmark.Dictionary("DICT_4X4_50").draw(7), 20, constant_values=255)
assert runmark.Detector(dictionaries=["DICT_4X4_50"]).detect(image).ids.tolist() == [7]
print("installed by pip:", runmark.__version__)
PROGRAM

# The source distribution holds what it takes to build it.
"$python" - "$source" "$work" <<'PROGRAM'
import sys
import tarfile
sys.path.insert(0, sys.argv[1] + "/bindings/python/build_backend")
import runmark_build
with tarfile.open(f"{sys.argv[2]}/{runmark_build.build_sdist(sys.argv[2])}") as archive:
    names = {name.split("/", 1)[1] for name in archive.getnames()}
assert {"PKG-INFO", "pyproject.toml", "CMakeLists.txt", "bindings/python/src/module.cpp"} <= names, names
PROGRAM
