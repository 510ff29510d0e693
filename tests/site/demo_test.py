#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""demo_test.py GLOAM FOLDER: the first minute, `gloam demo`. The tests in browsers use the page that it leaves."""
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

GLOAM, FOLDER = sys.argv[1], Path(sys.argv[2])
PICTURES = {"plain.png", "shaded.png", "truth.png", "tiles.png"}
GUIDES = ("copy-a-shader.txt", "testing.txt", "judge-a-driver.txt")


class DemoTest(unittest.TestCase):
    def test_it_says_in_ten_lines_what_it_did_and_where_to_look(self):
        shutil.rmtree(FOLDER, ignore_errors=True)
        done = subprocess.run([GLOAM, "demo", "--out", FOLDER], capture_output=True, text=True, check=False)
        self.assertEqual((0, ""), (done.returncode, done.stderr))
        self.assertLessEqual(done.stdout.count("\n"), 10, done.stdout)
        for said in (str(FOLDER / "index.html"), str(FOLDER / "sheet.png"), "equations, 4096 inputs each"):
            self.assertIn(said, done.stdout)
        self.assertNotIn("\033", done.stdout)  # no terminal, no colour
        page = (FOLDER / "index.html").read_text(encoding="utf-8")
        for part in ('<input type="radio"', "gloam_radical_inverse_base2", '<svg class="plot"',
                     '<details class="fold">', '<canvas id="canvas"', *(f'src="{picture}"' for picture in PICTURES),
                     *(f'href="{guide}"' for guide in GUIDES)):
            self.assertIn(part, page)
        # Every file of the page is there, and nothing that the page does not show.
        live = {"live.js", "scene-room.js", "scene-columns.js", "scene-knot.js"}
        self.assertEqual({"index.html", "sheet.png", *GUIDES, *PICTURES, *live}, {one.name for one in FOLDER.iterdir()})
        error, command = re.search(r"<figcaption>Error ([0-9.]+) .*, as gloam (.*) prints it", page).groups()
        self.assertIn(f"its occlusion is {error} off the truth", done.stdout)
        bench = subprocess.run([GLOAM, *command.split()], capture_output=True, text=True, check=True).stdout
        self.assertEqual(error, re.search(r"\| workshop \|.*\| ([0-9.]+) \|$", bench, re.MULTILINE)[1])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
