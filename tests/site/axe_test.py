#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""axe_test.py GLOAM: every kind of page of the site, judged by axe-core in headless Chromium, in light and in dark.

Left with status 77 where there is no Chromium, no npm, or no registry within reach of npm."""
import json
import subprocess
import tempfile
import unittest
from pathlib import Path

from browser import Browser
from npm_packages import NoPackages, install
from site_case import GLOAM, main, skip

PAGES = ["index", "check", "methods"]
PACKAGE = "axe-core@4.10.3"
SERIOUS = ("serious", "critical")
FIND = """axe.run().then(({violations}) => violations.map(({id, impact, nodes}) =>
    [impact, id, nodes.map(({html}) => html.slice(0, 120)).slice(0, 3)]))"""


def axe_script(folder):
    """The text of axe-core."""
    install(folder, PACKAGE)
    return Path(folder, "node_modules", "axe-core", "axe.min.js").read_text(encoding="utf-8")


class AxeTest(unittest.TestCase):
    def found(self, browser, page):
        browser.evaluate(AXE + "; 0")
        return [f"{page}: {json.dumps(one)}" for one in browser.evaluate(FIND) if one[0] in SERIOUS]

    def test_no_page_has_a_serious_finding(self):
        with tempfile.TemporaryDirectory() as folder, Browser() as browser:
            site = Path(folder, "site")
            subprocess.run([GLOAM, "site", site, "TSSAO-5", "--method", "sweep", "--quiet", "--no-pictures"],
                           check=True)
            found = []
            for dark in (False, True):
                for page in PAGES:
                    browser.look(1200, 900, dark)
                    browser.open(site / f"{page}.html", "#size=320x180" if page == "index" else "")
                    if page == "index":
                        browser.wait("gloam.live.state.effect?.frames > 0")
                        browser.evaluate("document.getElementById('source').open = true")
                        browser.wait("document.querySelector('.source').textContent !== ''")
                    if page == "methods":
                        browser.evaluate("document.querySelector('button.small').click()")
                    found += self.found(browser, f"{page}, {'dark' if dark else 'light'}")
            self.assertEqual([], found, "\n".join(found))

    def test_a_fault_is_found(self):
        with tempfile.TemporaryDirectory() as folder, Browser() as browser:
            Path(folder, "bad.html").write_text("<!DOCTYPE html><title>x</title><img src='x.png'><button></button>",
                                                encoding="utf-8")
            browser.open(Path(folder, "bad.html"))
            self.assertGreaterEqual(len(self.found(browser, "bad")), 2)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as INSTALLED:
        try:
            AXE = axe_script(INSTALLED)
        except NoPackages as reason:
            skip(reason)
    main()
