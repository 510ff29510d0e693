# SPDX-License-Identifier: MIT
"""The build backend of pyproject.toml (PEP 517): makes a wheel of the Python package gloam.

Configures and builds in build/python. The environment variable GLOAM_BUILD names a build folder that has the module
already, which is taken as it is.
"""
import base64
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def version():
    return re.search(r"project\(gloam VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


def built():
    """The folder of the package."""
    if "GLOAM_BUILD" in os.environ:
        return Path(os.environ["GLOAM_BUILD"]) / "python" / "gloam"
    build = ROOT / "build" / "python"
    subprocess.run(["cmake", "-S", ROOT, "-B", build, "-DGLOAM_FRAMEWORK_ONLY=ON", "-DGLOAM_PYTHON=ON",
                    f"-DPython_EXECUTABLE={sys.executable}"], check=True)
    subprocess.run(["cmake", "--build", build, "--target", "gloam_python", "--parallel"], check=True)
    return build / "python" / "gloam"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    tag = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    name = f"gloam-{version()}-{tag}-{tag}-{platform}.whl"
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    package = built()
    files = {f"gloam/{one.name}": one.read_bytes() for one in (package / "__init__.py", package / f"_gloam{suffix}")}
    info = f"gloam-{version()}.dist-info"
    files[f"{info}/METADATA"] = (f"Metadata-Version: 2.1\nName: gloam\nVersion: {version()}\n"
                                 "Summary: GLSL functions, run on a driver and judged\nLicense: MIT\n"
                                 "Requires-Dist: numpy\n").encode()
    files[f"{info}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: gloam\nRoot-Is-Purelib: false\n"
                              f"Tag: {tag}-{tag}-{platform}\n").encode()
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    lines = []
    for path, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        lines.append(f"{path},sha256={digest},{len(content)}")
    files[f"{info}/RECORD"] = "\n".join([*lines, f"{info}/RECORD,,"]).encode() + b"\n"
    with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in files.items():
            wheel.writestr(path, content)
    return name
