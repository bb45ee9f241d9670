"""The type stubs: mypy checks a program by them, and that they are those of the package as built."""

import os
import pathlib
import shutil
import subprocess
import sys

import pytest

import runmark

HERE = pathlib.Path(__file__).parent
CONFIG = HERE.parents[2] / "pyproject.toml"
BUILT = str(pathlib.Path(runmark.__file__).parents[1])
ENVIRONMENT = {**os.environ, "MYPYPATH": BUILT, "PYTHONPATH": BUILT}
pytestmark = pytest.mark.skipif(shutil.which("mypy") is None, reason="mypy is not installed")


def mypy(*arguments, folder):
    return subprocess.run([sys.executable, "-m", *arguments], env=ENVIRONMENT, capture_output=True, text=True, cwd=folder)


def test_a_program_in_strict_mode(tmp_path):
    good = mypy("mypy", "--config-file", CONFIG, HERE / "typed_program.py", folder=tmp_path)
    assert good.returncode == 0, good.stdout
    wrong = tmp_path / "wrong.py"
    wrong.write_text("import runmark\nx: str = runmark.Detector(3).memory\n")
    bad = mypy("mypy", "--config-file", CONFIG, wrong, folder=tmp_path)
    assert "arg-type" in bad.stdout and "assignment" in bad.stdout


def test_the_stubs_are_those_of_the_module(tmp_path):
    allowed = HERE / "stubtest_allowed.txt"
    result = mypy("mypy.stubtest", "runmark", "--mypy-config-file", CONFIG, "--allowlist", allowed, folder=tmp_path)
    assert result.returncode == 0, result.stdout


def test_every_public_name_has_a_docstring():
    for name in runmark.__all__:
        thing = getattr(runmark, name)
        if isinstance(thing, str):
            continue
        assert thing.__doc__, name
        for member, value in vars(thing).items() if isinstance(thing, type) else ():
            if not member.startswith("_"):
                assert value.__doc__, f"{name}.{member}"
