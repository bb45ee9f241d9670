"""PEP 517 backend of the Python package: CMake builds it, this packs it. Needs nothing but the standard library, so
pip installs nothing to build with; CMake, a C++20 compiler, Highway, pybind11 and nlohmann-json are the system's."""

import base64
import hashlib
import os
import pathlib
import re
import shlex
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[3]


def version():
    return re.search(r"project\(runmark VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


def metadata():
    return (f"Metadata-Version: 2.1\nName: runmark\nVersion: {version()}\n"
            "Summary: Finds square fiducial markers (ArUco, AprilTag) in one scan of the image\n"
            "License: Apache-2.0\nRequires-Python: >=3.9\nRequires-Dist: numpy\n")


def tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-" + re.sub(r"[.-]", "_", sysconfig.get_platform())


def get_requires_for_build_wheel(config_settings=None):
    return []


def get_requires_for_build_sdist(config_settings=None):
    return []


def build_package(prefix):
    """Puts the package's folder under `prefix`."""
    build = ROOT / "build" / f"python-{tag()}"
    configure = ["cmake", "-S", str(ROOT), "-B", str(build), "-DCMAKE_BUILD_TYPE=Release", "-DRUNMARK_PYTHON=ON",
                 "-DRUNMARK_TOOLS=OFF", "-DRUNMARK_TESTS=OFF", "-DRUNMARK_PRINT=OFF", "-DRUNMARK_WERROR=OFF",
                 f"-DPython_EXECUTABLE={sys.executable}", *shlex.split(os.environ.get("CMAKE_ARGS", ""))]
    subprocess.run(configure, check=True)
    subprocess.run(["cmake", "--build", str(build), "--parallel", str(os.cpu_count() or 1), "--target",
                    "runmark_python"], check=True)
    subprocess.run(["cmake", "--install", str(build), "--component", "python", "--prefix", str(prefix), "--strip"],
                   check=True)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    info = f"runmark-{version()}.dist-info"
    with tempfile.TemporaryDirectory() as folder:
        build_package(folder)
        files = {path.relative_to(folder).as_posix(): path.read_bytes()
                 for path in sorted(pathlib.Path(folder).rglob("*")) if path.is_file()}
    files[f"{info}/METADATA"] = metadata().encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: runmark\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode()
    for name in ("LICENSE", "NOTICE"):
        files[f"{info}/{name}"] = (ROOT / name).read_bytes()
    record = ""
    for name, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(data)}\n"
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    wheel = f"runmark-{version()}-{tag()}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in files.items():
            archive.writestr(name, data)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    """What is under version control, and PKG-INFO."""
    base = f"runmark-{version()}"
    listed = subprocess.run(["git", "-C", str(ROOT), "ls-files", "-z"], check=True, capture_output=True).stdout
    with tempfile.TemporaryDirectory() as folder, \
            tarfile.open(pathlib.Path(sdist_directory) / f"{base}.tar.gz", "w:gz") as archive:
        info = pathlib.Path(folder) / "PKG-INFO"
        info.write_text(metadata())
        archive.add(info, f"{base}/PKG-INFO")
        for name in listed.decode().split("\0")[:-1]:
            archive.add(ROOT / name, f"{base}/{name}", recursive=False)
    return f"{base}.tar.gz"
