#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""table_page_test.py GLOAM: the page of `gloam list equations --html` in headless Chromium, used as a reader would.

Left with status 77 where there is no Chromium."""
import subprocess

from site_case import GLOAM, BrowserCase, main

SHOWN = "[...document.querySelectorAll('tbody tr')].filter((row) => !row.hidden).map((row) => row.cells[0].textContent)"


class TablePageTest(BrowserCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.file = cls.folder / "equations.html"
        subprocess.run([GLOAM, "list", "equations", "--html", cls.file], check=True)
        listed = subprocess.run([GLOAM, "list", "equations"], check=True, capture_output=True, text=True)
        cls.names = [line.split()[0] for line in listed.stdout.splitlines()]

    def setUp(self):
        self.browser.open(self.file)

    def after(self, script):
        """The first cells of the rows that are shown once a reader has done that."""
        return self.browser.evaluate(f"{script}; {SHOWN}")

    def count(self):
        return self.browser.evaluate("document.querySelector('output').textContent")

    def test_its_own_script_runs_and_no_other(self):
        page = self.file.with_name("foreign.html")
        foreign = "<script>document.body.textContent = 'foreign'</script></body>"
        page.write_text(self.file.read_text(encoding="utf-8").replace("</body>", foreign), encoding="utf-8")
        self.browser.open(page)
        self.assertEqual(self.count(), f"{len(self.names)} of {len(self.names)} rows")
        self.assertEqual(self.after(""), self.names)

    def test_a_click_sorts_and_another_turns_the_order_round(self):
        click = "document.querySelector('th button').click()"
        self.assertEqual(self.after(click), sorted(self.names))
        self.assertEqual(self.after(click), sorted(self.names, reverse=True))

    def test_words_and_a_choice_filter(self):
        shown = self.after("const text = document.querySelector('input[type=search]'); text.value = 'halton BASE';"
                           "text.dispatchEvent(new Event('input'))")
        self.assertTrue(shown)
        self.assertTrue(all("halton" in name.lower() for name in shown), shown)
        self.assertEqual(self.count(), f"{len(shown)} of {len(self.names)} rows")
        self.browser.open(self.file)
        of_the_file = [name for name in self.names if name.startswith(("SINCOS", "TURNS"))]
        self.assertEqual(self.after("const choice = document.querySelector('select');"
                                    "choice.value = 'gloam/numeric/sincos.glsl';"
                                    "choice.dispatchEvent(new Event('input'))"), of_the_file)


if __name__ == "__main__":
    main()
