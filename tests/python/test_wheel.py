# SPDX-License-Identifier: MIT
"""pip makes a wheel that holds the module, the program and the licence, and what it installs works."""
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import csgcast
import pytest

ROOT = Path(__file__).resolve().parents[2]
TREE = Path(csgcast.__file__).resolve().parents[3]  # where module and program were built


def pip(*arguments, **variables):
    command = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--no-cache-dir", *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True, env=os.environ | variables)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    work = tmp_path_factory.mktemp("wheel")
    source = work / "source"
    source.mkdir()
    for name in ("setup.py", "pyproject.toml", "README.md", "LICENSE", "CMakeLists.txt"):
        shutil.copy(ROOT / name, source / name)
    shutil.copytree(ROOT / "bindings" / "python" / "csgcast", source / "bindings" / "python" / "csgcast")
    pip("wheel", "--no-build-isolation", "--no-deps", "--wheel-dir", work, source, CSGCAST_BUILD=str(TREE))
    (made,) = work.glob("*.whl")
    return made


def test_the_wheel_holds_module_program_and_licence(wheel):
    names = {name.split("-")[0] + name[name.index(".dist-info"):] if ".dist-info" in name else name for name in zipfile.ZipFile(wheel).namelist()}
    own = {"__init__.py", "__init__.pyi", "__main__.py", "py.typed", "bin/csgcast"}
    assert {f"csgcast/{name}" for name in own} <= names
    assert any(name.startswith("csgcast/_core") for name in names)
    assert "csgcast.dist-info/LICENSE" in names and "csgcast.dist-info/entry_points.txt" in names
    assert not any(name.endswith((".cpp", ".h")) for name in names)


def test_what_it_installs_runs(wheel, tmp_path):
    place = tmp_path / "site"
    pip("install", "--no-deps", "--no-index", "--target", place, wheel)
    environment = os.environ | {"PYTHONPATH": str(place)}
    run = lambda *command: subprocess.run(command, capture_output=True, text=True, env=environment, cwd=tmp_path, check=True).stdout
    assert run(place / "bin" / "csgcast", "--version") == f"csgcast {csgcast.__version__}\n"
    assert run(sys.executable, "-m", "csgcast", "--version") == f"csgcast {csgcast.__version__}\n"
    code = "import csgcast; print(csgcast.__file__); print(csgcast.box(2).compile().locate([1, 1, 1])[0])"
    assert run(sys.executable, "-c", code).splitlines() == [str(place / "csgcast" / "__init__.py"), "1"]
