# SPDX-License-Identifier: MIT
"""Builds the module and the program with CMake: pip install --no-build-isolation . (cmake, ninja and the packages of docs/building.md
must be there). CSGCAST_BUILD=FOLDER takes both from a build tree that has them, for this Python, instead."""
import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


class CMakeBuild(build_ext):
    def build_tree(self):
        if given := os.environ.get("CSGCAST_BUILD"):
            return Path(given).resolve()
        tree = Path(self.build_temp).resolve()
        subprocess.run(["cmake", "-S", ROOT, "-B", tree, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCSGCAST_BUILD_PYTHON=ON",
                        "-DCSGCAST_BUILD_TESTS=OFF", "-DCSGCAST_BUILD_EXAMPLES=OFF", f"-DPython_EXECUTABLE={sys.executable}"], check=True)
        subprocess.run(["ninja", "-C", tree, "csgcast_python", "csgcast"], check=True)
        return tree

    def build_extension(self, ext):
        tree = self.build_tree()
        modules = list((tree / "bindings" / "python" / "csgcast").glob("_core*"))
        program = tree / "cli" / "csgcast"
        if not modules or not program.exists():
            sys.exit(f"error: {tree} has no module or no program: build csgcast_python and csgcast there")
        target = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        (target / "bin").mkdir(parents=True, exist_ok=True)
        for built in modules:
            self.copy_file(str(built), str(target / built.name))
        self.copy_file(str(program), str(target / "bin" / "csgcast"))
        for built in (tree / "modules").glob("*.so"):  # what both load for pictures; none without OpenImageIO
            self.copy_file(str(built), str(target / built.name))


setup(
    version=re.search(r"project\(csgcast VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1],
    packages=["csgcast"],
    package_dir={"csgcast": "bindings/python/csgcast"},
    package_data={"csgcast": ["*.pyi", "py.typed"]},
    ext_modules=[Extension("csgcast._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
