# SPDX-License-Identifier: MIT
"""Builds the wheel for `pip install .` (PEP 517) with CMake and the standard library only, without a network."""
import base64, hashlib, pathlib, re, subprocess, sys, sysconfig, tempfile, zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
VERSION = re.search(r"project\(dsc VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]
INFO = f"dsc-{VERSION}.dist-info"
PYTHON = f"cp{sys.version_info[0]}{sys.version_info[1]}"
TAG = f"{PYTHON}-{PYTHON}-" + re.sub("[-.]", "_", sysconfig.get_platform())
METADATA = f"""Metadata-Version: 2.1
Name: dsc
Version: {VERSION}
Summary: Deformable simplicial complexes in the plane and in space: interfaces that move, in a mesh that stays valid
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy
Provides-Extra: drawing
Requires-Dist: matplotlib; extra == "drawing"
Description-Content-Type: text/markdown

"""
NEEDED = """dsc was not built; see CMake's errors above. It needs a C++20 compiler, CMake 3.25, Eigen, Boost, zlib,
pybind11 and Python's headers (Debian: cmake g++ libeigen3-dev libboost-dev zlib1g-dev pybind11-dev python3-dev)"""

def run(*command):
    if subprocess.run(command, stdout=sys.stderr).returncode != 0:
        raise SystemExit(NEEDED)

def compiled(build):
    """The package in this build tree of CMake, which is configured first if it is new."""
    if not (build / "CMakeCache.txt").exists():
        options = ("CMAKE_BUILD_TYPE=Release", "DSC_BUILD_HARNESS=OFF", "DSC_INSTALL=OFF", "DSC_BUILD_PYTHON=ON",
                   "DSC_UNITY=ON", "DSC_PRECOMPILE=ON", f"DSC_MODULE_PYTHON={sys.executable}")
        run("cmake", "-S", ROOT, "-B", build, *(f"-D{option}" for option in options))
    run("cmake", "--build", build, "--target", "dsc_python", "--parallel")
    return build / "lib/python/dsc"

def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    folder = pathlib.Path(metadata_directory) / INFO
    folder.mkdir()
    (folder / "METADATA").write_text(METADATA + (ROOT / "lib/python/README.md").read_text())
    (folder / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: dsc\nRoot-Is-Purelib: false\nTag: {TAG}\n")
    (folder / "LICENSE").write_text((ROOT / "LICENSE").read_text())
    return INFO

def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """The build tree: `config_settings["build-dir"]`, which can be reused, or else a temporary one."""
    with tempfile.TemporaryDirectory() as temporary, tempfile.TemporaryDirectory() as described:
        package = compiled(pathlib.Path((config_settings or {}).get("build-dir", temporary)))
        info = pathlib.Path(described) / prepare_metadata_for_build_wheel(described)
        files = {f"{folder.name}/{file.name}": file.read_bytes()
                 for folder in (package, info) for file in sorted(folder.iterdir()) if file.is_file()}
    digests = {name: base64.urlsafe_b64encode(hashlib.sha256(data).digest()).decode() for name, data in files.items()}
    record = "".join(f"{name},sha256={digests[name].rstrip('=')},{len(files[name])}\n" for name in files)
    wheel = pathlib.Path(wheel_directory) / f"dsc-{VERSION}-{TAG}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in (files | {f"{INFO}/RECORD": record + f"{INFO}/RECORD,,\n"}).items():
            archive.writestr(name, data)
    return wheel.name
