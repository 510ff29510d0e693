#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""firefox_test.py GLOAM: the site in Firefox: its pages work, and the occlusion is that of Chromium.

Left with status 77 where there is no firefox-esr, no Xvfb or no Chromium."""
import array
import base64

import browser
import firefox
from site_case import SHADE, SiteCase, main


class FirefoxTest(SiteCase):
    open_browser = firefox.Firefox

    def begin(self, page):
        page.open(self.site / "index.html")
        page.wait("gloam.live.state.picture?.occlusion.frames > 1")

    def occlusion(self, page):
        self.begin(page)
        script = SHADE.format(width=192, height=108, preset="balanced", frames=4, moves="true", read="readOcclusion")
        return array.array("f", base64.b64decode(page.evaluate(script)))

    def test_the_occlusion_is_that_of_chromium(self):
        """Their rasterizers differ, so pixels at edges may differ at all: means and percentiles are compared. The
        bounds are twice those of effect_test.py, which compares Chromium with the program."""
        with browser.Browser() as chromium:
            want = self.occlusion(chromium)
        got = self.occlusion(self.browser)
        self.assertEqual(192 * 108, len(got))
        self.assertGreater(max(got) - min(got), 0.5)
        errors = sorted(abs(a - b) for a, b in zip(got, want))
        self.assertLess(sum(errors) / len(errors), 0.003)
        self.assertLess(errors[len(errors) // 2], 4e-5)
        self.assertLess(errors[len(errors) * 95 // 100], 0.006)

    def test_every_page_works(self):
        self.begin(self.browser)
        self.assertEqual("", self.browser.text("told"))
        self.assertRegex(self.browser.text("timing"), "^WebGL2: .* ms from frame to frame")
        for page, ready in (("methods", "document.querySelectorAll('tbody tr').length === 1"),
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

    def test_an_error_of_a_page_is_found(self):
        page = self.site.parent / "bad.html"
        page.write_text("<!DOCTYPE html><script>noSuchFunction()</script>", encoding="utf-8")
        with firefox.Firefox() as other:
            other.open(page)
            self.assertIn("noSuchFunction", " ".join(other.problems()))


if __name__ == "__main__":
    have_both = firefox.program() and browser.program()
    main(missing=None if have_both else "no firefox-esr, no Xvfb or no Chromium")
