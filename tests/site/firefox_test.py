#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""firefox_test.py GLOAM: the site in Firefox: its pages work, and the occlusion is that of Chromium.

Left with status 77 where there is no firefox-esr, no Xvfb or no Chromium."""
import browser
import firefox
from site_case import SiteCase, main


class FirefoxTest(SiteCase):
    open_browser = firefox.Firefox

    def begin(self, page):
        page.open(self.site / "index.html")
        page.wait("gloam.live.state.picture?.occlusion.frames > 1")

    def occlusion(self, page):
        self.begin(page)
        return self.shade(page)

    def test_the_occlusion_is_that_of_chromium(self):
        """The bounds are twice those of effect_test.py, which compares Chromium with the program."""
        with browser.Browser() as chromium:
            want = self.occlusion(chromium)
        self.compare(self.occlusion(self.browser), want, bounds=2)

    def test_every_page_works(self):
        self.begin(self.browser)
        self.assertEqual("", self.browser.text("told"))
        self.assertRegex(self.browser.text("timing"), "^WebGL2: .* ms from frame to frame")
        for page, ready in (("methods", "document.querySelectorAll('.method').length === 1"),
                            ("check", "document.getElementById('gpu').textContent !== 'unknown'")):
            self.browser.open(self.site / f"{page}.html")
            self.browser.wait(ready)
        self.assertEqual([], self.browser.problems())

    def test_a_check_runs(self):
        self.browser.open(self.site / "check.html")
        self.browser.wait("!document.getElementById('run').disabled")
        self.browser.evaluate("document.getElementById('run').click()")
        self.browser.wait("document.querySelectorAll('#results tbody tr').length > 0"
                          " && !document.getElementById('run').disabled")
        self.assertIn("ok", self.browser.evaluate("document.querySelector('#results tbody tr').textContent"))


if __name__ == "__main__":
    have_both = firefox.program() and browser.program()
    main(missing=None if have_both else "no firefox-esr, no Xvfb or no Chromium")
