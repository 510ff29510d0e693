#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""engines_test.py GLOAM [NAME...]: the examples in engines (all, or those named), built as their READMEs say. Each is
run off screen by examples/compare.py. Prints one table of all, and fails where that fails."""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
PROGRAMS = {"vtk": "gloam_vtk", "openscenegraph": "gloam_osg"}
PAGES = ("threejs", "babylon", "playcanvas")


def run(*words, folder):
    subprocess.run(words, cwd=folder, stdout=sys.stderr, check=True)


def built(gloam, name, folder):
    """What compare.py takes."""
    if name in PROGRAMS:
        run("cmake", "-S", EXAMPLES / name, "-B", folder, "-D", f"GLOAM={gloam}", "-D", "CMAKE_BUILD_TYPE=Release",
            folder=folder)
        run("cmake", "--build", folder, "--parallel", folder=folder)
        return folder / PROGRAMS[name]
    for file in ("page.js", "page.html"):
        shutil.copy(EXAMPLES / file, folder)
    folder = shutil.copytree(EXAMPLES / name, folder / name, ignore=shutil.ignore_patterns("node_modules", "gloam"))
    run(gloam, "pack", "--npm", "gloam", folder=folder)
    run("npm", "install", "--no-audit", "--no-fund", "--no-package-lock", folder=folder)
    return folder


def main():
    gloam, *names = sys.argv[1:] or sys.exit(__doc__)
    gloam = Path(gloam).resolve()
    failed = []
    print("| engine | pass | RMSE (G) | ms |\n| --- | --- | --: | --: |")
    for name in names or (*PROGRAMS, *PAGES):
        with tempfile.TemporaryDirectory() as folder:
            example = built(gloam, name, Path(folder))
            done = subprocess.run((sys.executable, "-B", EXAMPLES / "compare.py", example, "--gloam", gloam),
                                  stdout=subprocess.PIPE, text=True, check=False)
        for row in [line for line in done.stdout.splitlines() if line.startswith("| ")][2:]:
            print(f"| {name} {row}", flush=True)
        failed += [name] if done.returncode else []
    sys.exit(f"failed: {', '.join(failed)}" if failed else 0)


if __name__ == "__main__":
    main()
