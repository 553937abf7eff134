"""Builds extension and wheel in a folder of their own: setuptools writes beside its sources, and they stay as they are.

Usage: build_wheel.py SOURCE_DIR BUILD_DIR PROGRAM FMU_LIBRARY FMU_PLACE      (CMake runs it; BUILD_DIR/native.json says what to link: native.py)
BUILD_DIR/package is then importable, BUILD_DIR/dist has the wheel, BUILD_DIR/build.log what was said.
"""
import pathlib
import shutil
import subprocess
import sys


# Libraries of which the library for mock-up units has the code in it, where Debian's static ones can be moved (fmi/CMakeLists.txt).
INSIDE = ("libsundials-dev", "libsuitesparse-dev", "libexpat1-dev", "libyaml-dev", "libjansson-dev", "libzip-dev", "zlib1g-dev", "libshp-dev")


def copy_licences(source: pathlib.Path, package: pathlib.Path) -> None:
    """hawser's own, and those of what is inside, as Debian keeps them. setup.py puts LICENSE* and NOTICE into the wheel."""
    for name in ("LICENSE", "NOTICE"):
        shutil.copy(source / name, package)
    for library in INSIDE:
        text = pathlib.Path("/usr/share/doc") / library / "copyright"
        if text.is_file():
            shutil.copy(text, package / f"LICENSE.{library.removesuffix('-dev')}")


def copy_sources(source: pathlib.Path, package: pathlib.Path, program: pathlib.Path, fmu: pathlib.Path, place: str) -> None:
    """The package's files and the program; the catalogue, the desk, the converter and the library for mock-up units where libhawser looks for them:
    beside the module that it is linked into, and above the program."""
    shutil.rmtree(package, ignore_errors=True)
    shutil.copytree(source / "python" / "hawser", package / "hawser", ignore=shutil.ignore_patterns("__pycache__"))
    for file in (source / "python").glob("*.*"):
        if file.suffix in (".py", ".toml"):
            shutil.copy(file, package)
    catalogue = package / "hawser" / "share" / "hawser" / "library"
    catalogue.mkdir(parents=True)
    for file in (source / "library").glob("*.yaml"):
        shutil.copy(file, catalogue)
    for name in ("desk.html", "convert.cjs"):
        shutil.copy(source / "web" / "dist" / name, catalogue.parent)
    (package / "hawser" / "bin").mkdir()
    shutil.copy(program, package / "hawser" / "bin" / "hawser")
    copy_licences(source, package)
    (package / "hawser" / place).parent.mkdir(parents=True)
    shutil.copy(fmu, package / "hawser" / place)
    shutil.copy(fmu.parent / "licences.txt", (package / "hawser" / place).parent)  # of what both libraries have inside


def main(source: pathlib.Path, build: pathlib.Path, program: pathlib.Path, fmu: pathlib.Path, place: str) -> int:
    package, wheels, log = build / "package", build / "dist", build / "build.log"
    copy_sources(source, package, program, fmu, place)
    shutil.copy(build / "native.json", package)
    shutil.rmtree(wheels, ignore_errors=True)
    command = [sys.executable, "-B", "setup.py", "-q", "build_ext", "--inplace", "bdist_wheel", "--dist-dir", str(wheels)]
    with log.open("w", encoding="utf-8") as said:
        failed = subprocess.run(command, cwd=package, stdout=said, stderr=subprocess.STDOUT).returncode
    if failed:
        print(log.read_text(encoding="utf-8"), file=sys.stderr)
    return failed


if __name__ == "__main__":
    sys.exit(main(*(pathlib.Path(word) for word in sys.argv[1:5]), sys.argv[5]))
