#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""axe_test.py GLOAM FOLDER: the page of `gloam demo`, judged by axe-core in headless Chromium, in light and in dark.

Left with status 77 where there is no Chromium, no npm, or no registry within reach of npm."""
import tempfile
from pathlib import Path

from site_case import PageCase, install, main

PACKAGE = "axe-core@4.10.3"
SERIOUS = ("serious", "critical")
FIND = """axe.run().then(({violations}) => violations.map(({id, impact, nodes}) =>
    [impact, id, nodes.map(({html}) => html.slice(0, 120)).slice(0, 3)]))"""


class AxeTest(PageCase):
    def test_the_page_has_no_serious_finding(self):
        """With its table open."""
        found = []
        for dark in (False, True):
            self.browser.look(390, 844, dark)
            self.open()
            self.ask("$('summary').click()")
            self.ask(AXE + "; 0")
            found += [("dark" if dark else "light", *one) for one in self.ask(FIND) if one[0] in SERIOUS]
        self.assertEqual([], found)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as FOLDER:
        install(FOLDER, PACKAGE)
        AXE = Path(FOLDER, "node_modules", "axe-core", "axe.min.js").read_text(encoding="utf-8")
    main()
