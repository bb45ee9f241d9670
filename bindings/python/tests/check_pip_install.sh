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
