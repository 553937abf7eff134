"""Builds the package `hawser`: one extension for every Python 3 (abi3), and the modules around it.

In hawser's own build CMake runs it in a folder of its own (python/CMakeLists.txt); elsewhere `pip install ./python` links an
installed hawser, found by pkg-config.
"""
import pathlib
import sys

import setuptools

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import native  # noqa: E402

native.write_declared(HERE / "hawser" / "_declared.py")
setuptools.setup(version=native.link()["version"], cffi_modules=["native.py:builder"],
                 packages=setuptools.find_namespace_packages(include=["hawser*"]),
                 package_data={"": ["py.typed", "*.pyi", "*.yaml", "*.html", "fmu.so", "bin/hawser", "licences.txt"]},
                 entry_points={"console_scripts": ["hawser = hawser.__main__:main"]},
                 options={"bdist_wheel": {"py_limited_api": "cp39"}})
