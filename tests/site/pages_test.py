#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pages_test.py GLOAM DOCS: the pages of the site in headless Chromium, and their pictures;
and a page with a table.

Left with status 77 where there is no Chromium."""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

from site_case import GLOAM, BrowserCase, SiteCase, main

DOCS = Path(sys.argv[2])
PAGES = ["index", "check", "methods"]
METHODS = ["gtao", "sweep"]
SHOWN = "[...document.querySelectorAll('tbody tr')].filter((row) => !row.hidden).map((row) => row.cells[0].textContent)"


class PagesTest(SiteCase):
    @classmethod
    def words(cls):
        return ["TSSAO-5", "--method", *METHODS, "--address", "https://example.org/gloam/"]

    def open(self, page, dark=False, width=1000):
        self.browser.look(width, 900, dark)
        self.browser.open(self.site / f"{page}.html")

    def count(self, selector):
        return self.browser.evaluate(f"document.querySelectorAll('{selector}').length")

    def test_every_page_works_on_a_small_screen_and_asks_no_network(self):
        for page in PAGES:
            for width in (1920, 390):
                self.open(page, width=width)
                self.assertLessEqual(self.browser.evaluate("document.documentElement.scrollWidth"), width, page)
            self.assertEqual(len(PAGES), self.count("nav a"), page)
            self.assertEqual(1, self.count("nav a[aria-current]"), page)
            self.assertIn("gloam", self.browser.evaluate("document.title"), page)
            self.assertEqual(1, self.count('meta[name="description"]'), page)
            self.assertEqual(1, self.count("h1"), page)
            links = self.browser.evaluate("[...document.querySelectorAll('a')].map((a) => a.getAttribute('href'))")
            self.assertEqual([], [link for link in links if not (self.site / link.split("#")[0]).is_file()], page)
        self.assertEqual([], self.browser.problems())
        asked = [url for url in self.browser.requests() if not url.startswith(("file:", "data:", "about:", "blob:"))]
        self.assertEqual([], asked)

    def text(self, selector):
        return self.browser.evaluate(f"document.querySelector('{selector}').textContent")

    def test_the_methods_have_their_equations_presets_and_failures(self):
        self.open("methods")
        self.assertEqual(METHODS, self.browser.evaluate("[...document.querySelectorAll('tbody tr')].map((row) =>"
                                                        " row.cells[0].textContent)"))
        self.assertIn("reference", self.text("tbody tr:nth-child(2)"))
        listed = json.loads(subprocess.run([GLOAM, "list", "presets", "--json"], check=True, capture_output=True,
                                           text=True).stdout)["presets"]
        for name, equation in (("gtao", "GTAO-gather"), ("sweep", "SWEEP-gather")):
            said = self.text(f"#{name} dl")
            self.assertIn(equation, said)
            for one in listed:
                if one["settings"].get("method", "hemisphere") == name:
                    self.assertIn(f"{one['name']}: error {one['error']:.4f}, time {one['time']:.2f}", said)
        table = (DOCS / "methods.md").read_text(encoding="utf-8").split("| method | fails | number |")[1]
        failure = next(line for line in table.splitlines() if line.startswith("| gtao | "))
        for cell in failure.strip("| ").split(" | ")[1:]:
            self.assertIn(cell, self.text("#gtao dl"))

    def test_the_methods_have_pictures(self):
        self.open("methods")
        if self.count("#gtao img") == 0:
            self.skipTest("there is no Vulkan device")
        self.browser.wait("document.querySelector('#gtao img').complete")
        self.assertEqual(320, self.browser.evaluate("document.querySelector('#gtao img').naturalWidth"))
        self.assertIn("preset balanced", self.text("main .soft"))
        pictures = [(self.site / f"method-{name}.png").read_bytes() for name in METHODS]
        self.assertNotEqual(*pictures)

    def test_the_plot_has_every_preset(self):
        self.open("index")
        listed = subprocess.run([GLOAM, "list", "presets"], check=True, capture_output=True, text=True).stdout
        points = self.browser.evaluate("[...document.querySelectorAll('.plot title')].map((one) => one.textContent)")
        self.assertEqual([line.split()[0] for line in listed.splitlines()], [point.split(":")[0] for point in points])
        names = self.browser.evaluate("[...document.querySelectorAll('.plot text.own')].map((one) => one.textContent)")
        self.assertEqual(["fast", "balanced", "quality", "reference"], names)

    def test_one_of_the_pictures_of_a_room_is_shown(self):
        self.open("index")
        if self.count(".choose") == 0:
            self.skipTest("there is no Vulkan device")
        shown = ("[...document.querySelectorAll('.choose img')].filter((one) => one.checkVisibility())"
                 ".map((one) => one.getAttribute('src'))")
        for name, file in (("with", "room-with.png"), ("without", "room-without.png"), ("traced", "room-truth.png"),
                           ("alone", "room-occlusion.png")):
            self.browser.evaluate(f"document.getElementById('{name}').click()")
            self.assertEqual([file], self.browser.evaluate(shown))
        self.assertEqual(4, len({(self.site / f"room-{name}.png").read_bytes()
                                 for name in ("with", "without", "truth", "occlusion")}))
        self.assertIn("error", self.text(".choose figcaption"))
        self.assertIn('content="https://example.org/gloam/room-with.png"', (self.site / "index.html").read_text(encoding="utf-8"))

    def test_the_commands_of_the_doors_run(self):
        self.open("index")
        commands = self.browser.evaluate("[...document.querySelectorAll('pre.command')].map((one) => one.textContent)")
        self.assertEqual(3, len(commands))
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "luminance.glsl").write_text(self.text("#luminance"), encoding="utf-8")
            for command in commands:
                name, *words = command.split()
                self.assertEqual("gloam", name)
                done = subprocess.run([GLOAM, *words], check=True, capture_output=True, text=True, cwd=folder)
                self.assertIn("gloam_sweep" if "pack" in words else " 0 failed", done.stdout)

    def test_previews_have_the_address_of_the_site(self):
        text = (self.site / "methods.html").read_text(encoding="utf-8")
        self.assertIn('<meta property="og:url" content="https://example.org/gloam/methods.html">', text)
        self.assertIn('<meta property="og:title" content="gloam: methods', text)

    def test_a_site_without_pictures_has_none(self):
        folder = self.site.parent / "plain"
        subprocess.run([GLOAM, "site", folder, "TSSAO-5", "--method", "sweep", "--quiet", "--no-pictures"], check=True)
        self.browser.open(folder / "index.html")
        self.assertEqual(0, self.count(".choose"))
        self.assertEqual([], list(folder.glob("*.png")))


class TablePageTest(BrowserCase):
    """The page of `gloam list equations --html`, used as a reader would."""

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
    main(2)
