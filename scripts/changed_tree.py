"""A copy of the tree in which one thing at a time is changed, built and run: for scripts/mutate and scripts/write-accuracy."""

import contextlib
import os
import pathlib
import shutil
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parents[1]


def blocks(path):
    """The paragraphs of a list of changes, each as its lines; the first paragraph is about the list."""
    return [block.strip("\n").split("\n") for block in (SOURCE / path).read_text().split("\n\n")[1:]]


class ChangedTree:
    def __init__(self, work, *options):
        """Copies the tree into the folder `work` and configures a release build of it."""
        self.tree = work / "tree"
        self.build_folder = work / "build"
        names = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=SOURCE, check=True,
                               capture_output=True, text=True).stdout.split("\0")
        for name in filter(lambda name: name and (SOURCE / name).is_file(), names):
            target = self.tree / name
            target.parent.mkdir(parents=True, exist_ok=True)
            if not target.exists() or target.read_bytes() != (SOURCE / name).read_bytes():
                shutil.copy(SOURCE / name, target)
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        subprocess.run(["cmake", "-S", self.tree, "-B", self.build_folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DRUNMARK_WERROR=OFF", "--log-level=WARNING", *launcher, *options], check=True,
                       stdout=subprocess.DEVNULL)

    def build(self, target):
        """The output of a build that failed, or None."""
        result = subprocess.run(["cmake", "--build", self.build_folder, "-j", str(os.cpu_count()), "--target", target],
                                capture_output=True, text=True)
        return None if result.returncode == 0 else result.stdout[-2000:]

    def program(self, name):
        return self.build_folder / "bin" / name

    @contextlib.contextmanager
    def changed(self, file, old, new):
        """Inside, `new` stands where `old` stands once."""
        path = self.tree / file
        text = path.read_text()
        if text.count(old) != 1:
            sys.exit(f"{file}: '{old}' is not there once: write the change anew")
        path.write_text(text.replace(old, new))
        try:
            yield
        finally:
            path.write_text(text)
