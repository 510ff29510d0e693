#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""filament_test.py GLOAM EXAMPLE CXX: examples/filament, built and run by the commands of its README under a display of
its own. Its occlusion is that of `gloam render` for the depth that Filament has drawn.

Left with status 77 where Filament 1.9 or Xvfb is missing."""
import array
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

GLOAM, EXAMPLE, COMPILER = sys.argv[1], Path(sys.argv[2]), sys.argv[3]
WIDTH, HEIGHT = 640, 360


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **options)
    if done.returncode != 0:
        raise RuntimeError(f"{command}: exit status {done.returncode}\n{done.stdout}{done.stderr}")


def read_pfm(file):
    """The values of a PFM image, the bottom row first."""
    head, size, scale, data = file.read_bytes().split(b"\n", 3)
    assert (head, size) == (b"Pf", b"%d %d" % (WIDTH, HEIGHT)) and float(scale) < 0
    return array.array("f", data)


def mean_difference(a, b):
    return sum(abs(x - y) for x, y in zip(a, b, strict=True)) / len(a)


class Display:
    """A display of its own, under a number that is free."""

    def __enter__(self):
        to_read, to_write = os.pipe()
        self.process = subprocess.Popen(["Xvfb", "-displayfd", str(to_write), "-screen", "0", "64x64x24"],
                                        pass_fds=[to_write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_write)
        with os.fdopen(to_read) as answer:
            number = answer.readline().strip()
        return {**os.environ, "DISPLAY": ":" + number, "LIBGL_ALWAYS_SOFTWARE": "1"}

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()


class FilamentTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.owner = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.owner.name, "example")
        shutil.copytree(EXAMPLE, cls.folder, ignore=shutil.ignore_patterns("build", "gloam.glsl"))
        readme = (cls.folder / "README.md").read_text(encoding="utf-8")
        pack = re.search(r"^    (gloam pack.*?gloam\.glsl)$", readme, re.M | re.S).group(1)
        run("bash", "-c", 'gloam() { "$GLOAM" "$@"; }; set -o pipefail; ' + pack, cwd=cls.folder,
            env={**os.environ, "GLOAM": GLOAM})
        run("cmake", "-G", "Ninja", "-S", ".", "-B", "build", f"-DCMAKE_CXX_COMPILER={COMPILER}",
            "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror", cwd=cls.folder)
        run("cmake", "--build", "build", cwd=cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.owner.cleanup()

    def rendered(self, radius):
        """What gloam makes of the depth that the program has written."""
        out = self.folder / f"rendered-{radius}"
        run(GLOAM, "render", "--gbuffer", self.folder / "build", "--preset", "balanced", "--samples", "96",
            "--no-filter", "--radius", radius, "--quiet", "--out", out)
        return read_pfm(out / "f0000_ao.pfm")

    def test_the_occlusion_is_that_of_the_program(self):
        with Display() as environment:
            run("build/filament_occlusion", "build", "1", "build", cwd=self.folder, env=environment)
        got = read_pfm(self.folder / "build" / "occlusion.pfm")
        want = self.rendered("1")
        self.assertGreater(max(want), 0.5)
        self.assertLess(mean_difference(got, want), 0.004)
        self.assertLess(abs(sum(got) - sum(want)), 0.01 * sum(want))
        self.assertGreater(mean_difference(got, self.rendered("0.8")), 0.004)
        without, shaded = ((self.folder / "build" / name).read_bytes() for name in ("without.png", "with.png"))
        self.assertNotEqual(without, shaded)

    def test_bad_input_is_named(self):
        for radius, materials, named in (("much", "build", "radius much: expected a number"),
                                         ("-1", "build", "radius -1: expected a number"),
                                         ("1", "nowhere", "cannot read nowhere/surface.filamat")):
            with Display() as environment:
                done = subprocess.run(["build/filament_occlusion", materials, radius, "build"], cwd=self.folder,
                                      env=environment, capture_output=True, text=True, check=False)
            self.assertEqual(2, done.returncode)
            self.assertIn(named, done.stderr)


if __name__ == "__main__":
    if shutil.which("matc") is None or shutil.which("Xvfb") is None or not Path("/usr/include/filament-1.9").is_dir():
        print("no Filament 1.9, or no Xvfb")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
