#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""page_test.py GLOAM FOLDER: the page of `gloam demo` in headless Chromium: pictures, plot and table.

Left with status 77 where there is no Chromium."""
import subprocess

from site_case import GLOAM, PAGE, PageCase, main

# The equations of the rows that are shown.
SHOWN = "$$('tbody tr').filter((row) => !row.hidden).map((row) => row.cells[1].textContent)"


def listed(kind):
    """The names that `gloam list` prints."""
    done = subprocess.run([GLOAM, "list", kind], check=True, capture_output=True, text=True)
    return [line.split()[0] for line in done.stdout.splitlines()]


class PageTest(PageCase):
    def setUp(self):
        self.browser.look(1000, 900)
        self.open()

    def test_it_fits_and_the_picture_is_in_the_first_screen(self):
        for width, height in ((1920, 1080), (1280, 720), (390, 844)):
            self.browser.look(width, height)
            self.open()
            self.assertLessEqual(self.ask("$('.choose').getBoundingClientRect().bottom"), height)
            self.ask("$('summary').click()")
            self.assertLessEqual(self.ask("document.documentElement.scrollWidth"), width)
        self.assertEqual(1, self.ask("$$('h1').length"))
        links = self.ask("$$('a').map((a) => a.getAttribute('href'))")
        self.assertEqual([], [link for link in links if not (PAGE.parent / link).is_file()])
        self.assertEqual([], self.browser.problems())

    def test_the_plot_has_every_preset(self):
        points = self.ask("$$('.plot title').map((one) => one.textContent)")
        self.assertEqual(listed("presets"), [point.split(":")[0] for point in points])
        names = self.ask("$$('.plot text.own').map((one) => one.textContent)")
        self.assertEqual(["fast", "balanced", "quality", "reference"], names)

    def test_one_of_the_pictures_is_shown(self):
        seen = self.ask("""$$('input', $('.choose')).flatMap((choice) => {
            choice.click();
            return $$('img', $('.choose')).filter((one) => one.checkVisibility()).map((one) => one.src);
        })""")
        self.assertEqual((4, 4), (len(seen), len(set(seen))))

    def count(self):
        return self.ask("$('.filter output').textContent")

    def test_its_own_scripts_run_and_no_other(self):
        page = PAGE.with_name("foreign.html")
        self.addCleanup(page.unlink)
        foreign = "<script>document.body.textContent = 'foreign'</script></body>"
        page.write_text(PAGE.read_text(encoding="utf-8").replace("</body>", foreign), encoding="utf-8")
        self.browser.open(page)
        rows = len(self.ask(SHOWN))
        self.assertEqual(self.count(), f"{rows} of {rows} rows")

    def test_the_table_sorts_and_is_searched(self):
        self.ask("$('summary').click()")
        rows = self.ask(SHOWN)
        self.assertLessEqual(set(listed("equations")), set(rows))
        for order in (sorted(rows), sorted(rows)[::-1]):
            self.ask("$$('th button')[1].click()")
            self.assertEqual(order, self.ask(SHOWN))
        self.assertEqual("descending", self.ask("$$('th')[1].getAttribute('aria-sort')"))
        found = self.ask("const text = $('input[type=search]'); text.value = 'halton BASE';"
                         f"text.dispatchEvent(new Event('input')); {SHOWN}")
        self.assertTrue(found)
        self.assertTrue(all("halton" in name.lower() for name in found), found)
        self.assertEqual(self.count(), f"{len(found)} of {len(rows)} rows")

    def test_a_choice_filters(self):
        chosen, shown = self.ask("""(() => {
            const choice = $('section.table select');
            choice.selectedIndex = 1;
            choice.dispatchEvent(new Event('input'));
            return [choice.value, $$('tbody tr').filter((row) => !row.hidden)
                .map((row) => row.cells[choice.dataset.column].textContent)];
        })()""")
        self.assertTrue(shown)
        self.assertEqual({chosen}, set(shown))
        self.assertRegex(self.count(), f"^{len(shown)} of ")


if __name__ == "__main__":
    main()
