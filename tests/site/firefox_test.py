#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""firefox_test.py GLOAM FOLDER: the page of `gloam demo` in Firefox works, and its occlusion is that of Chromium.

Left with status 77 where there is no firefox-esr, no Xvfb or no Chromium."""
import browser
import firefox
from site_case import PageCase, main


class FirefoxTest(PageCase):
    open_browser = firefox.Firefox

    def test_the_occlusion_is_that_of_chromium(self):
        """The bounds are twice those of effect_test.py, which compares Chromium with the program."""
        with browser.Browser() as chromium:
            chromium.open(self.page)
            chromium.wait("gloam.live?.state.picture?.occlusion.frames > 1")
            want = {preset: self.shade(chromium, preset) for preset in ("balanced", "quality")}
        self.open()
        for preset, image in want.items():
            with self.subTest(preset):
                self.compare(self.shade(self.browser, preset), image, bounds=2)

    def test_the_page_works(self):
        self.open()
        self.assertEqual("", self.browser.text("told"))
        self.browser.wait("/^WebGL2: .* ms from frame to frame/.test(document.getElementById('timing').textContent)")
        self.browser.evaluate("document.getElementById('stop').click()")
        self.assertEqual("Go on", self.browser.text("stop"))
        rows = self.browser.evaluate("document.querySelectorAll('tbody tr').length")
        self.assertEqual(f"{rows} of {rows} rows", self.browser.evaluate("document.querySelector('.filter output').textContent"))
        self.assertEqual([], self.browser.problems())


if __name__ == "__main__":
    main(missing=None if firefox.program() and browser.program() else "no firefox-esr, no Xvfb or no Chromium")
