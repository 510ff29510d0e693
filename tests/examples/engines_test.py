#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""engines_test.py GLOAM [NAME...]: the examples in engines (all, or those named), built as their READMEs say, and run off
screen. Each draws a mesh with the engine's own pass, where it has one, and with gloam's, and compares both with what rays
give for the same triangles. Prints one table of all.

Fails where a program fails (another size, an orthographic camera, errors of OpenGL), where gloam's error is above 1.1 of
what `gloam render` has on the same view, and where it is not below the engine's own."""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
CMAKE = {"vtk": "gloam_vtk", "openscenegraph": "gloam_osg"}
PAGES = ("babylon", "playcanvas")
MOST = 1.1  # of the error of gloam render


def run(*words, folder):
    """What a program prints. Its errors are seen."""
    done = subprocess.run(words, cwd=folder, stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{done.stdout}{' '.join(map(str, words))}: exit status {done.returncode}")
    return done.stdout


def compiled(gloam, name, folder):
    """The tables of an example that CMake builds."""
    run("cmake", "-S", EXAMPLES / name, "-B", folder, "-D", f"GLOAM={gloam}", "-D", "CMAKE_BUILD_TYPE=Release", folder=folder)
    run("cmake", "--build", folder, "--parallel", folder=folder)
    program = ("xvfb-run", "-a", folder / CMAKE[name])
    run(*program, "--check", folder=folder)
    return run(*program, "--compare", folder=folder)


def bundled(gloam, name, folder):
    """The same of one that is a page."""
    shutil.copy(EXAMPLES / "page.js", folder)
    folder = shutil.copytree(EXAMPLES / name, folder / name, ignore=shutil.ignore_patterns("node_modules", "gloam"))
    run(gloam, "pack", "--npm", "gloam", folder=folder)
    run("npm", "install", "--no-audit", "--no-fund", "--no-package-lock", folder=folder)
    return run(sys.executable, "-B", EXAMPLES / "compare.py", folder, "--gloam", gloam, folder=folder)


def faults(rows):
    """rows: (pass, error) of an example: that of gloam render, of nothing, the engine's own, gloam's."""
    ours = [(name, error) for name, error in rows if name.startswith(("gloam,", "vtkGloam", "GloamAO"))]
    others = [error for name, error in rows[1:] if not name.startswith(("gloam", "vtkGloam", "GloamAO"))]
    for name, error in ours:
        if not error <= MOST * rows[0][1]:
            yield f"{name}: error {error}, expected at most {MOST} of {rows[0][1]}"
        if not error < min(others):
            yield f"{name}: error {error}, expected less than {min(others)}"
    if not ours:
        yield "no row of gloam's pass"


def main():
    gloam, *names = sys.argv[1:] or sys.exit(__doc__)
    gloam = Path(gloam).resolve()
    os.environ["LIBGL_ALWAYS_SOFTWARE"] = "1"
    wrong = []
    print("| engine | pass | RMSE (G) | ms |\n| --- | --- | --: | --: |")
    for name in names or (*CMAKE, *PAGES):
        with tempfile.TemporaryDirectory() as folder:
            table = (compiled if name in CMAKE else bundled)(gloam, name, Path(folder))
        rows = [line.strip("| ").split(" | ") for line in table.splitlines() if line.startswith("| ")][2:]
        for row in rows:
            print(f"| {name} | {' | '.join(row)} |", flush=True)
        wrong += [f"{name}: {fault}" for fault in faults([(row[0], float(row[1])) for row in rows])]
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main()
