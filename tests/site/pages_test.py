#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""pages_test.py GLOAM DOCS: the methods, the gallery, the measurements and the licences of the site in headless
Chromium, and truth on its first page.

Left with status 77 where there is no Chromium."""
import json
import subprocess
import sys
from pathlib import Path

from site_case import GLOAM, SiteCase, main

DOCS = Path(sys.argv[2])
PAGES = ["index", "check", "methods", "gallery", "drivers", "measurements", "licences"]
METHODS = ["gtao", "sweep"]
MEASURED = """# Of this machine

| run | RMSE (G) | ms |
| --- | --: | --: |
| one/single | 0.08 | 27.1 |
| two/temporal | 0.05 | 14.6 |
| three/temporal | 0.04 | 84.0 |
"""


def tables_in(text):
    """How many tables a page of Markdown has."""
    return sum("---" in line and set(line) <= set("|-: ") for line in text.splitlines())


class PagesTest(SiteCase):
    @classmethod
    def words(cls):
        measured = cls.folder / "measured.md"
        measured.write_text(MEASURED, encoding="utf-8")
        return ["TSSAO-5", "--measured", measured, "--method", *METHODS]

    def open(self, page, dark=False, width=1000):
        self.browser.look(width, 900, dark)
        self.browser.open(self.site / f"{page}.html")

    def count(self, selector):
        return self.browser.evaluate(f"document.querySelectorAll('{selector}').length")

    def test_every_page_works_on_a_small_screen_and_asks_no_network(self):
        for page in [*PAGES, *(f"method-{name}" for name in METHODS)]:
            self.open(page, width=390)
            self.assertLessEqual(self.browser.evaluate("document.documentElement.scrollWidth"), 390, page)
            self.assertEqual(len(PAGES), self.count("nav a"), page)
            self.assertEqual(int(page in PAGES), self.count("nav a[aria-current]"), page)
            self.assertIn("gloam", self.browser.evaluate("document.title"), page)
            self.assertEqual(1, self.count('meta[name="description"]'), page)
            self.assertEqual(1 + (page == "measurements"), self.count("h1"), page)  # a page of the user
            links = self.browser.evaluate("[...document.querySelectorAll('a')].map((a) => a.getAttribute('href'))")
            self.assertEqual([], [link for link in links if not (self.site / link.split("#")[0]).is_file()], page)
        self.assertEqual([], self.browser.problems())
        asked = [url for url in self.browser.requests() if not url.startswith(("file:", "data:", "about:", "blob:"))]
        self.assertEqual([], asked)

    def test_the_documents_have_their_tables(self):
        for page, further in (("drivers", ""), ("measurements", MEASURED)):
            text = (DOCS / f"{page}.md").read_text(encoding="utf-8")
            self.open(page)
            self.assertEqual(tables_in(text + further), self.count("#document .wide table"), page)
            self.assertGreater(self.count("h2"), 1, page)
            self.assertEqual(text.splitlines()[0].lstrip("# "),
                             self.browser.evaluate("document.querySelector('h1').textContent"))

    def test_the_measurements_end_with_the_pages_of_the_user(self):
        self.open("measurements")
        last = "[...document.querySelectorAll('{}')].at(-1).textContent"
        self.assertEqual("Of this machine", self.browser.evaluate(last.format("h1")))
        self.assertIn("three/temporal", self.browser.evaluate(last.format("table")))

    def test_the_columns_of_a_document_sort_by_number(self):
        self.open("measurements")
        values = ("[...document.querySelectorAll('.wide')[0].querySelectorAll('tbody tr')]"
                  ".map((row) => Number(row.cells[1].textContent))")
        click = "document.querySelectorAll('.wide')[0].querySelectorAll('th button')[1].click()"
        self.browser.evaluate(click)
        falling = self.browser.evaluate(values)
        self.assertEqual(sorted(falling, reverse=True), falling)
        self.browser.evaluate(click)
        self.assertEqual(falling[::-1], self.browser.evaluate(values))
        self.assertGreater(len(falling), 3)

    def test_the_charts_have_the_points_of_the_tables(self):
        self.open("measurements", dark=True)
        charts = self.count(".chart canvas")
        self.assertGreater(charts, 1)
        self.assertEqual(charts, self.count(".chart"))
        tables = self.browser.evaluate("gloam.documents.flat().filter((block) => block.kind === 'table')"
                                       ".map((block) => [block.rows.length, gloam.chart.pointsOf(block).length])")
        self.assertEqual(charts, sum(points > 0 for _, points in tables))
        self.assertEqual([], [pair for pair in tables if pair[1] not in (0, pair[0])])
        drawn = self.browser.evaluate("""(() => {
            const canvas = document.querySelector(".chart canvas");
            const pixels = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
            const of_points = [0x6c, 0xb2, 0xf5];  // --mark in the dark
            let count = 0;
            for (let i = 0; i < pixels.length; i += 4)
                if (of_points.every((value, k) => pixels[i + k] === value)) ++count;
            return count;
        })()""")
        self.assertGreater(drawn, 50)

    def text(self, selector):
        return self.browser.evaluate(f"document.querySelector('{selector}').textContent")

    def test_the_methods_have_a_table_and_a_page_each(self):
        self.open("methods")
        names = self.browser.evaluate("[...document.querySelectorAll('tbody a')].map((a) => a.textContent)")
        self.assertEqual(METHODS, names)
        listed = json.loads(subprocess.run([GLOAM, "list", "presets", "--json"], check=True, capture_output=True,
                                           text=True).stdout)["presets"]
        self.assertIn("reference", self.text("tbody tr:nth-child(2)"))
        for name, equation in (("gtao", "GTAO-gather"), ("sweep", "SWEEP-gather")):
            self.open(f"method-{name}")
            self.browser.wait(f"document.querySelector('.source').textContent.includes('gloam_{name}')")
            self.assertIn(equation, self.text("tbody td"))
            rows = self.browser.evaluate("[...document.querySelectorAll('[aria-label=Presets] tbody tr')]"
                                         ".map((row) => [...row.cells].slice(0, 3).map((cell) => cell.textContent))")
            want = [[one["name"], f"{one['error']:.4f}", f"{one['time']:.2f}"] for one in listed
                    if one["settings"].get("method", "hemisphere") == name]
            self.assertEqual(want, rows)
        self.open("method-gtao")
        table = (DOCS / "methods.md").read_text(encoding="utf-8")
        row = next(line for line in table.splitlines() if line.startswith("| gtao | "))
        said = self.browser.evaluate("document.querySelector('main').textContent").lower()
        for cell in row.strip("| ").split(" | ")[1:]:
            self.assertIn(cell, said)

    def test_the_methods_have_pictures(self):
        self.open("method-gtao")
        if self.count("figure img") == 0:
            self.skipTest("there is no Vulkan device")
        self.browser.wait("document.querySelector('figure img').complete")
        self.assertEqual(480, self.browser.evaluate("document.querySelector('figure img').naturalWidth"))
        self.assertIn("preset balanced", self.text("figcaption"))
        pictures = [(self.site / f"method-{name}.png").read_bytes() for name in METHODS]
        self.assertNotEqual(*pictures)
        self.assertIn('content="preview.png"', (self.site / "index.html").read_text(encoding="utf-8"))
        self.assertTrue((self.site / "preview.png").is_file())

    def test_truth_is_that_of_the_program(self):
        """The page and the program rasterize for themselves, so their pixels at edges differ."""
        self.browser.look(1000, 900)
        self.browser.open(self.site / "index.html", "#left=truth&view=difference&method=gtao")
        if self.browser.evaluate("gloam.effectData.truths.length") == 0:
            self.skipTest("there is no Vulkan device")
        self.browser.wait("gloam.live.state.effect?.frames >= 16")
        self.assertEqual("truth: 256 rays a pixel of 480x270, radius 0.3", self.text("#left-told"))
        got = self.browser.evaluate("gloam.live.state.effect.error()")
        out = self.site.parent / "truth"
        subprocess.run([GLOAM, "render", "room", "--still", "--frames", "16", "--size", "480x270", "--method", "gtao",
                        "--truth", "--truth-rays", "256", "--out", out, "--quiet"], check=True)
        want = json.loads((out / "render.json").read_text(encoding="utf-8"))["frames"][-1]["errors"]["filtered"]["rmse"]
        self.assertAlmostEqual(want, got, delta=0.005)
        self.assertGreater(got, 0.02)
        self.browser.evaluate("gloam.live.state.orbit.change({yaw: 0.1})")
        self.browser.wait("document.getElementById('left-told').textContent === 'without'")

    def test_the_gallery_has_sliders(self):
        self.open("gallery")
        if self.count("img-comparison-slider") == 0:
            self.assertIn("no pictures", self.browser.text("device"))
            self.skipTest("there is no Vulkan device")
        self.browser.wait("[...document.images].every((image) => image.complete || image.loading === 'lazy')")
        self.assertEqual(3, self.count("img-comparison-slider.rendered"))
        self.assertEqual(640, self.browser.evaluate("document.images[0].naturalWidth"))
        exposure = "document.querySelector('img-comparison-slider').exposure"
        self.browser.evaluate("document.querySelector('img-comparison-slider').focus()")
        before = self.browser.evaluate(exposure)
        self.browser.key("ArrowRight", until=f"{exposure} !== {before}")

    def test_a_site_without_pictures_says_so(self):
        folder = self.site.parent / "plain"
        subprocess.run([GLOAM, "site", folder, "TSSAO-5", "--method", "sweep", "--quiet", "--no-pictures"], check=True)
        self.browser.open(folder / "gallery.html")
        self.assertIn("no pictures", self.browser.text("device"))
        self.assertEqual([], list(folder.glob("*.png")))

    def test_the_licences_are_in_the_page(self):
        self.open("licences")
        text = self.browser.text("licences")
        for words in ("uPlot 1.6.32", "Leon Sorokin", "img-comparison-slider 8.0.7", "Dmitry Snisarenko",
                      "Permission is hereby granted"):
            self.assertIn(words, text)


if __name__ == "__main__":
    main(2)
