#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""catalogue_test.py GLOAM: every check of the site passes in headless Chromium.

Left with status 77 where there is no Chromium."""
from check_page import CheckPage
from site_case import SiteCase, main


class CatalogueTest(SiteCase):
    @classmethod
    def words(cls):
        return ["--method", "sweep", "--no-pictures"]

    def test_every_check_passes(self):
        self.browser.timeout = 250
        page = CheckPage(self.browser, self.site)
        # The loops of all kernels need 1/16 of the rounds that they may take.
        self.browser.evaluate("gloam.workerText = gloam.workerText.replace('most = 2 ** 14', 'most = 2 ** 10');"
                              "gloam.checkPage.state.runner.end()")
        page.click("run")
        page.finish()
        rows = page.rows()
        self.assertGreater(len(rows), 250)
        self.assertEqual([], [(row["equation"], row["error"] or row["story"])
                              for row in rows if row["outcome"] == "failed"])


if __name__ == "__main__":
    main()
