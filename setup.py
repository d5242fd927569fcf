# SPDX-License-Identifier: MIT
"""Builds the module with CMake: pip install --no-build-isolation . (cmake, ninja and the packages of docs/building.md must be there)."""
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        target = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        tree = Path(self.build_temp).resolve()
        subprocess.run(["cmake", "-S", ROOT, "-B", tree, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCSGCAST_BUILD_PYTHON=ON",
                        "-DCSGCAST_BUILD_TESTS=OFF", "-DCSGCAST_BUILD_EXAMPLES=OFF", f"-DPython_EXECUTABLE={sys.executable}"], check=True)
        subprocess.run(["ninja", "-C", tree, "csgcast_python"], check=True)
        target.mkdir(parents=True, exist_ok=True)
        for built in (tree / "bindings" / "python" / "csgcast").glob("_core*"):
            self.copy_file(str(built), str(target / built.name))


setup(
    version=re.search(r"project\(csgcast VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1],
    packages=["csgcast"],
    package_dir={"csgcast": "bindings/python/csgcast"},
    package_data={"csgcast": ["*.pyi", "py.typed"]},
    ext_modules=[Extension("csgcast._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
