#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""page_test.py GLOAM: the page of `gloam list equations --html` in a browser, used as a reader would.

The page runs its own script under its own content security policy; a click on a title sorts, a second one turns the
order round; words and a choice filter. Left with status 77 where there is no Chromium."""
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
SECONDS = 120
ROW = re.compile(r"<tr([^>]*)><td[^>]*>([^<]*)</td>")


class Browser:
    """A page after its scripts have run."""

    def __init__(self, html):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder, "page.html")
            page.write_text(html, encoding="utf-8")
            command = [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile",
                       "--dump-dom", page.as_uri()]
            self.dom = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=True).stdout

    def count(self):
        return re.search(r"<output[^>]*>([^<]*)</output>", self.dom).group(1)

    def shown(self):
        """The first cells of the rows that are not hidden."""
        body = re.search(r"<tbody>(.*)</tbody>", self.dom, re.S).group(1)
        return [name for attributes, name in ROW.findall(body) if "hidden" not in attributes]


class Equations(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "equations.html")
            subprocess.run([sys.argv[1], "list", "equations", "--html", file], check=True)
            cls.html = file.read_text(encoding="utf-8")
        listed = subprocess.run([sys.argv[1], "list", "equations"], check=True, capture_output=True, text=True)
        cls.names = listed.stdout.split()

    def after(self, script):
        """The page once a reader has done that, which its policy would not let anybody else's script do."""
        without_policy = re.sub(r"<meta http-equiv=\"Content-Security-Policy\"[^>]*>", "", self.html)
        self.assertNotEqual(without_policy, self.html)
        return Browser(without_policy.replace("</body>", f"<script>{script}</script></body>"))

    def test_its_own_script_runs_and_no_other(self):
        page = Browser(self.html.replace("</body>", "<script>document.body.textContent = 'foreign'</script></body>"))
        self.assertEqual(page.count(), f"{len(self.names)} of {len(self.names)} rows")
        self.assertEqual(page.shown(), self.names)

    def test_a_click_sorts_and_another_turns_the_order_round(self):
        click = "document.querySelector('th button').click();"
        self.assertEqual(self.after(click).shown(), sorted(self.names))
        self.assertEqual(self.after(click + click).shown(), sorted(self.names, reverse=True))

    def test_words_and_a_choice_filter(self):
        typed = ("const text = document.querySelector('input[type=search]'); text.value = 'halton BASE';"
                 "text.dispatchEvent(new Event('input'));")
        page = self.after(typed)
        self.assertTrue(page.shown())
        self.assertTrue(all("halton" in name.lower() for name in page.shown()), page.shown())
        self.assertEqual(page.count(), f"{len(page.shown())} of {len(self.names)} rows")
        chosen = ("const choice = document.querySelector('select'); choice.value = 'gloam/numeric/sincos.glsl';"
                  "choice.dispatchEvent(new Event('input'));")
        of_the_file = [name for name in self.names if name.startswith(("SINCOS", "TURNS"))]
        self.assertEqual(self.after(chosen).shown(), of_the_file)


if __name__ == "__main__":
    if CHROMIUM is None:
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
