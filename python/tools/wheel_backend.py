"""What pip calls to make a wheel (PEP 517): CMake builds the package, and it is packed.

Takes nothing from the network, and no package of Python's but pip itself. PLASTICA_CMAKE_ARGS in the
environment holds further arguments of CMake; build/wheel is its folder.
"""

import base64
import hashlib
import io
import os
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import tomllib
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "wheel"


def version():
    """That of the project's CMake file."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    words = text[text.index("project(plastica VERSION "):].split()
    return words[2]


def metadata():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {version()}",
             f"Summary: {project['description']}", "License: MIT", f"Requires-Python: {project['requires-python']}"]
    lines += [f"Requires-Dist: {each}" for each in project["dependencies"]]
    for extra, needs in project["optional-dependencies"].items():
        lines.append(f"Provides-Extra: {extra}")
        lines += [f'Requires-Dist: {each}; extra == "{extra}"' for each in needs]
    lines.append("Description-Content-Type: text/markdown")
    return "\n".join(lines) + "\n\n" + (ROOT / project["readme"]).read_text(encoding="utf-8")


def tag():
    """Interpreter, its binary interface and the machine."""
    interpreter = f"cp{sys.version_info.major}{sys.version_info.minor}"
    machine = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{interpreter}-{interpreter}-{machine}"


def build_package():
    """Builds the package. @return its folder"""
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    subprocess.run(
        ["cmake", "-S", ROOT, "-B", BUILD, *generator, "-DCMAKE_BUILD_TYPE=Release",
         "-DPLASTICA_PYTHON=ON", "-DPLASTICA_BUILD_TESTS=OFF", "-DPLASTICA_MPI=OFF",
         "-DCMAKE_UNITY_BUILD=ON", f"-DPython_EXECUTABLE={sys.executable}",
         *shlex.split(os.environ.get("PLASTICA_CMAKE_ARGS", ""))], check=True)
    subprocess.run(
        ["cmake", "--build", BUILD, "--target", "plastica_python_package", "--parallel",
         str(os.cpu_count() or 1)], check=True)
    return BUILD / "python" / "plastica"


def record_line(name, content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(content)}\n"


def stripped(path):
    """The bytes of an extension without symbols for a debugger, where the machine can take them off."""
    if path.suffix != ".so" or not shutil.which("strip"):
        return path.read_bytes()
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / path.name
        subprocess.run(["strip", "--strip-unneeded", "-o", copy, path], check=True)
        return copy.read_bytes()


def info_files():
    """What stands beside the package in a wheel, by path: but for the list of all files."""
    info = f"plastica-{version()}.dist-info"
    wheel = (f"Wheel-Version: 1.0\nGenerator: plastica\nRoot-Is-Purelib: false\nTag: {tag()}\n")
    return info, {f"{info}/METADATA": metadata().encode(), f"{info}/WHEEL": wheel.encode(),
                  f"{info}/LICENSE": (ROOT / "LICENSE").read_bytes()}


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Else pip would build a wheel to read it."""
    info, files = info_files()
    for path, content in files.items():
        target = Path(metadata_directory) / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(content)
    return info


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    package = build_package()
    info, beside = info_files()
    # What an earlier build has left there, of modules that are gone or for another Python, stays there.
    sources = ROOT / "python" / "plastica"
    names = {path.name for path in sources.iterdir() if path.suffix in (".py", ".pyi", ".typed")}
    names |= {"fields.py", "_core" + sysconfig.get_config_var("EXT_SUFFIX")}
    files = {f"plastica/{name}": stripped(package / name) for name in sorted(names)}
    files.update(beside)
    record = "".join(record_line(*each) for each in files.items()) + f"{info}/RECORD,,\n"
    wheel = f"plastica-{version()}-{tag()}.whl"
    with zipfile.ZipFile(Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in {**files, f"{info}/RECORD": record.encode()}.items():
            entry = zipfile.ZipInfo(path)  # of 1980: the same sources give the same wheel
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o100644 << 16
            archive.writestr(entry, content)
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    """Part of PEP 517: the files of the folder that git has, with what pip reads beside them."""
    name = f"plastica-{version()}"
    made = Path(sdist_directory) / f"{name}.tar.gz"
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, check=True, capture_output=True)
    with tarfile.open(made, "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for path in filter(None, listed.stdout.decode().split("\0")):
            archive.add(ROOT / path, f"{name}/{path}")
        content = metadata().encode()
        entry = tarfile.TarInfo(f"{name}/PKG-INFO")
        entry.size = len(content)
        archive.addfile(entry, io.BytesIO(content))
    return made.name
