#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""demo_test.py GLOAM FOLDER: the first minute, `gloam demo`. The tests in browsers use the page that it leaves."""
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

GLOAM, FOLDER = sys.argv[1], Path(sys.argv[2])
PICTURES = ("plain", "shaded", "truth", "visibility", "error")
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
                     '<details class="fold">', '<canvas id="canvas"'):
            self.assertIn(part, page)
        # Every file of the page is there, and nothing that the page does not show.
        scenes = {"room", "moving", "bunny" if "bunny_plain.png" in page else "knot"}
        pictures = {f"{scene}_{picture}.png" for scene in scenes for picture in PICTURES}
        for picture in pictures:
            self.assertIn(f'src="{picture}"', page)
        for guide in GUIDES:
            self.assertIn(f'href="{guide}"', page)
        live = {"live.js", "scene-room.js", "scene-columns.js", "scene-knot.js"}
        self.assertEqual({"index.html", "sheet.png", *GUIDES, *pictures, *live}, {one.name for one in FOLDER.iterdir()})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
