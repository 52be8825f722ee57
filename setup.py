"""Builds the C++ side of the Python package with CMake; pyproject.toml has the rest.

The objects are those of the program: the build folder is `build` beside this file, the one of the script
`parapet`, so nothing is compiled twice. PARAPET_BUILD_DIR names another one, PARAPET_BUILD_JOBS says how
many files are compiled at a time.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

root = Path(__file__).resolve().parent


def project_version() -> str:
    found = re.search(r"project\(parapet VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text())
    if found is None:
        raise RuntimeError("CMakeLists.txt does not say the version")
    return found.group(1)


def pybind11_place() -> list[str]:
    """Where pybind11 is, when it came with pip."""
    try:
        import pybind11
    except ImportError:
        return []
    return [f"-Dpybind11_ROOT={pybind11.get_cmake_dir()}"]


class CMakeBuild(build_ext):
    """Lets CMake build parapet._native and puts it where setuptools expects it."""

    def build_extension(self, ext: Extension) -> None:
        build = Path(os.environ.get("PARAPET_BUILD_DIR", root / "build"))
        target = Path(self.get_ext_fullpath(ext.name)).resolve()
        # Not the one of a virtual environment, which may go away: its base has the headers.
        python = getattr(sys, "_base_executable", sys.executable)
        options = ["-DPARAPET_PYTHON=ON", f"-DPython_EXECUTABLE={python}", *pybind11_place()]
        if not (build / "build.ninja").exists():
            options += ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DPARAPET_UNITY=ON"]
        try:
            subprocess.run(["cmake", "-S", str(root), "-B", str(build), *options], check=True)
        except (OSError, subprocess.CalledProcessError):
            raise SystemExit(
                "CMake could not configure the build. On Debian these are needed: "
                + " ".join(
                    line.split()[0]
                    for line in (root / "cmake/debian-packages.txt").read_text().splitlines()
                    if line.split()[1:2] in (["build"], ["python"])
                )
            ) from None
        jobs = os.environ.get("PARAPET_BUILD_JOBS", str(len(os.sched_getaffinity(0))))
        command = ["cmake", "--build", str(build), "--target", "parapet_python", "-j", jobs]
        subprocess.run(command, check=True)
        modules = list((build / "python/parapet").glob("_native*.so"))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(max(modules, key=lambda file: file.stat().st_mtime), target)
        target.chmod(0o755)


setup(
    version=project_version(),
    ext_modules=[Extension("parapet._native", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    options={"build": {"build_base": "build/pip"}, "egg_info": {"egg_base": "build"}},
)
