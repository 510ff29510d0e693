#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""page_test.py GLOAM FOLDER: the page of `gloam demo` in headless Chromium: pictures, plot and table.

Left with status 77 where there is no Chromium."""
import subprocess

from site_case import GLOAM, PAGE, PageCase, main

# The equations of the rows that are shown.
SHOWN = "[...document.querySelectorAll('tbody tr')].filter((row) => !row.hidden).map((row) => row.cells[1].textContent)"


def listed(kind):
    """The names that `gloam list` prints."""
    done = subprocess.run([GLOAM, "list", kind], check=True, capture_output=True, text=True)
    return [line.split()[0] for line in done.stdout.splitlines()]


class PageTest(PageCase):
    def setUp(self):
        self.browser.look(1000, 900)
        self.open()

    def test_it_works_on_a_small_screen_and_asks_no_network(self):
        for width in (1920, 390):
            self.browser.look(width, 900)
            self.open()
            self.browser.evaluate("document.querySelector('summary').click()")
            self.assertLessEqual(self.browser.evaluate("document.documentElement.scrollWidth"), width)
        self.assertEqual(1, self.browser.evaluate("document.querySelectorAll('h1').length"))
        links = self.browser.evaluate("[...document.querySelectorAll('a')].map((a) => a.getAttribute('href'))")
        self.assertEqual([], [link for link in links if not (PAGE.parent / link).is_file()])
        self.assertEqual([], self.browser.problems())
        asked = [url for url in self.browser.requests() if not url.startswith(("file:", "data:", "about:", "blob:"))]
        self.assertEqual([], asked)

    def test_the_plot_has_every_preset(self):
        points = self.browser.evaluate("[...document.querySelectorAll('.plot title')].map((one) => one.textContent)")
        self.assertEqual(listed("presets"), [point.split(":")[0] for point in points])
        names = self.browser.evaluate("[...document.querySelectorAll('.plot text.own')].map((one) => one.textContent)")
        self.assertEqual(["fast", "balanced", "quality", "reference"], names)

    def test_one_of_the_pictures_of_a_scene_is_shown(self):
        figure = "document.querySelector('.choose')"
        shown = f"[...{figure}.querySelectorAll('img')].filter((one) => one.checkVisibility()).map((one) => one.src)"
        seen = []
        for choice in range(self.browser.evaluate(f"{figure}.querySelectorAll('input').length")):
            self.browser.evaluate(f"{figure}.querySelectorAll('input')[{choice}].click()")
            seen += self.browser.evaluate(shown)
        self.assertEqual((5, 5), (len(seen), len(set(seen))))
        self.assertIn("error", self.browser.evaluate(f"{figure}.querySelector('figcaption').textContent"))

    def count(self):
        return self.browser.evaluate("document.querySelector('.filter output').textContent")

    def test_its_own_scripts_run_and_no_other(self):
        page = PAGE.with_name("foreign.html")
        foreign = "<script>document.body.textContent = 'foreign'</script></body>"
        try:
            page.write_text(PAGE.read_text(encoding="utf-8").replace("</body>", foreign), encoding="utf-8")
            self.browser.open(page)
            rows = len(self.browser.evaluate(SHOWN))
            self.assertEqual(self.count(), f"{rows} of {rows} rows")
        finally:
            page.unlink()

    def test_the_table_sorts_and_is_searched(self):
        self.browser.evaluate("document.querySelector('summary').click()")
        rows = self.browser.evaluate(SHOWN)
        self.assertLessEqual(set(listed("equations")), set(rows))
        head = "document.querySelectorAll('th')[1]"
        self.browser.evaluate(f"{head}.querySelector('button').click()")
        self.assertEqual(sorted(rows), self.browser.evaluate(SHOWN))
        self.browser.evaluate(f"{head}.querySelector('button').click()")
        self.assertEqual("descending", self.browser.evaluate(f"{head}.getAttribute('aria-sort')"))
        self.assertEqual(sorted(rows)[::-1], self.browser.evaluate(SHOWN))
        found = self.browser.evaluate("const text = document.querySelector('input[type=search]');"
                                      "text.value = 'halton BASE';"
                                      f"text.dispatchEvent(new Event('input')); {SHOWN}")
        self.assertTrue(found)
        self.assertTrue(all("halton" in name.lower() for name in found), found)
        self.assertEqual(self.count(), f"{len(found)} of {len(rows)} rows")

    def test_a_choice_filters(self):
        chosen, shown = self.browser.evaluate("""(() => {
            const choice = document.querySelector('section.table select');
            choice.selectedIndex = 1;
            choice.dispatchEvent(new Event('input'));
            return [choice.value, [...document.querySelectorAll('tbody tr')].filter((row) => !row.hidden)
                .map((row) => row.cells[choice.dataset.column].textContent)];
        })()""")
        self.assertTrue(shown)
        self.assertEqual({chosen}, set(shown))
        self.assertRegex(self.count(), f"^{len(shown)} of ")


if __name__ == "__main__":
    main()
