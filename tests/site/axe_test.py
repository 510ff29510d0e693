#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""axe_test.py GLOAM: every kind of page of the site, judged by axe-core in headless Chromium, in light and in dark.

Left with status 77 where there is no Chromium, no npm, or no registry within reach of npm."""
import json
import tempfile
from pathlib import Path

from npm_packages import NoPackages, install
from site_case import SiteCase, main, skip

# When each page shows what it has; the one of checks once its check has run.
PAGES = {"index": "gloam.live.state.picture?.occlusion.frames > 0",
         "check": "gloam.checkPage.state.rows.length > 0 || document.getElementById('run').click()",
         "methods": "document.querySelectorAll('.method').length === 1"}
PACKAGE = "axe-core@4.10.3"
SERIOUS = ("serious", "critical")
FIND = """axe.run().then(({violations}) => violations.map(({id, impact, nodes}) =>
    [impact, id, nodes.map(({html}) => html.slice(0, 120)).slice(0, 3)]))"""


def axe_script(folder):
    """The text of axe-core."""
    install(folder, PACKAGE)
    return Path(folder, "node_modules", "axe-core", "axe.min.js").read_text(encoding="utf-8")


class AxeTest(SiteCase):
    def test_no_page_has_a_serious_finding(self):
        """The pages with all that they can show: the details of a method, and of a check that failed."""
        data = next(self.site.glob("checks-*.js"))
        data.write_text(data.read_text(encoding="utf-8").replace("void main() {", "void main() { no_such;"),
                        encoding="utf-8")
        found = []
        for dark in (False, True):
            for page, ready in PAGES.items():
                self.browser.look(390, 844, dark)
                self.browser.open(self.site / f"{page}.html")
                self.browser.wait(ready)
                self.browser.evaluate("document.querySelector('summary, tbody .small')?.click()")
                self.browser.evaluate(AXE + "; 0")
                found += [f"{page}, {'dark' if dark else 'light'}: {json.dumps(one)}"
                          for one in self.browser.evaluate(FIND) if one[0] in SERIOUS]
        self.assertEqual([], found, "\n".join(found))


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as INSTALLED:
        try:
            AXE = axe_script(INSTALLED)
        except NoPackages as reason:
            skip(reason)
    main()
