#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""browser_test.py GLOAM JUDGE_CASES: the site that `gloam site` writes, used in headless Chromium as a person would.

Left with status 77 where there is no Chromium."""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser, program
from check_page import NATIVE, CheckPage, Gloam, compare, replace

GLOAM, JUDGE_CASES = sys.argv[1:3]
run = Gloam(GLOAM)
# Some of each kind: with images, with many outputs, integers, inputs that the budget moves.
EQUATIONS = ["GTAO-a*", "GTAO-gather", "TSSAO-10*", "TSSAO-RP-h*", "CS-Q-k*", "HALTON*", "NORMAL*", "FINITE*"]

# What the judge of the page says of the outputs in gloam.cases, beside what the framework said of them.
JUDGE_ALL = """gloam.cases.map(({check, outputs, answer}) => {
    const tally = gloam.judge.newTally();
    check.scenarios.forEach((scenario, i) => gloam.judge.addScenario(tally, check, gloam.judge.decode(scenario),
        gloam.words(outputs[i])));
    return [answer, gloam.results.row(check, {tally, fault: "", error: "", reason: "", seconds: 0})];
})"""


class SiteTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder_owner = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.folder_owner.name)
        cls.site = cls.folder / "site"
        written = run("site", cls.site, *EQUATIONS, "--no-pictures")
        assert written.returncode == 0, written.stderr
        cls.browser = Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.__exit__()
        cls.folder_owner.cleanup()

    def setUp(self):
        self.browser.look(1200, 900)

    def checked(self, site=None):
        """A page whose checks have run; that of an earlier test where it is still open."""
        site = site or self.site
        page = CheckPage(self.browser, site, again=False)
        if self.browser.evaluate("!document.getElementById('told').textContent.includes('finished')"):
            page.click("run")
            page.finish()
        return page

    def spoiled(self, old, new):
        """A copy of the site with its checks of the filters changed in one place."""
        copy = Path(tempfile.mkdtemp(dir=self.folder))
        written = run("site", copy, "TSSAO-10", "TSSAO-10-g", "TSSAO-11", "GTAO-arc", "--no-pictures")
        self.assertEqual(0, written.returncode, written.stderr)
        replace(copy / "checks-filter.js", old, new)
        return copy

    def test_the_checks_pass_and_ask_no_network(self):
        page = self.checked()
        rows = page.rows()
        self.assertGreater(len(rows), 20)
        self.assertEqual([], [row["equation"] for row in rows if row["outside"] or row["error"] or row["fault"]])
        self.assertIn("0 failed (finished)", page.text("told"))
        self.assertIn("SwiftShader", page.text("gpu"))
        self.assertEqual([], self.browser.problems())
        asked = [url for url in self.browser.requests() if not url.startswith(("file:", "blob:", "about:"))]
        self.assertEqual([], asked)

    def test_the_results_agree_with_those_of_the_program(self):
        file = self.folder / "native.json"
        native = run("check", *EQUATIONS, "--device", NATIVE, "--inputs", 512, "--json", file)
        if native.returncode == 2:
            self.skipTest(native.stderr)
        known = {row["equation"]: row for row in json.loads(file.read_text(encoding="utf-8"))["results"]}
        rows = self.checked().rows()
        self.assertEqual(sorted(known), sorted(row["equation"] for row in rows))
        compare(self, known, rows)

    def test_the_page_judges_as_the_program_does(self):
        cases = self.folder / "cases.js"
        subprocess.run([JUDGE_CASES, cases], check=True)
        CheckPage(self.browser, self.site)
        self.browser.evaluate(cases.read_text(encoding="utf-8") + "0")
        outside = 0
        for there, here in self.browser.evaluate(JUDGE_ALL):
            for row in (there, here):
                row["variant"] = row["seconds"] = row["story"] = None
                if row["worst"]:
                    row["worst"]["values"] = None  # the text of numbers differs: 1e-8, 1e-08
            outside += here["outside"]
            if there["outside"]:
                self.forgive(there, here)
            self.assertEqual(there, here)
        self.assertGreater(outside, 1000)

    def forgive(self, there, here):
        """Makes equal what may differ where outputs fail. At zero the program counts a failure as worse than any
        other. Of the exact results that the budget covers, the page has only those that allow further outputs: the
        error is then up to a little larger."""
        if there["worst"]["class"] == "zero":
            here["worst"] = there["worst"]
        if there["budget"]["backward_ulp"] == 0:
            return
        for error in ("max_ulp", "max_abs", "budget_fraction"):
            if there[error] != here[error]:
                self.assertTrue(there[error] <= here[error] <= 1.25 * there[error], (there, here))
                here[error] = there[error]
        here["worst"] = there["worst"]

    def test_a_kernel_with_a_wrong_result_fails(self):
        site = self.spoiled("floatBitsToUint(gloam_kernel_result)", "floatBitsToUint(gloam_kernel_result * 1.0001)")
        page = self.checked(site)
        failed = [row["equation"] for row in page.rows() if row["outside"]]
        self.assertEqual(1, len(failed))
        self.assertIn("1 failed", page.text("told"))
        self.assertEqual(1, page.shown(2).count("failed"))
        worst = next(row["worst"] for row in page.rows() if row["outside"])
        self.assertNotEqual([], worst["input_words"])
        self.assertIn("0x", worst["values"])

    def test_a_kernel_that_does_not_compile_is_an_error(self):
        page = self.checked(self.spoiled("void main() {", "void main() { no_such_name = 1.0;"))
        errors = [row for row in page.rows() if row["error"]]
        self.assertEqual(1, len(errors))
        self.assertIn("no_such_name", errors[0]["error"])
        self.assertEqual("error", errors[0]["reason"])
        self.assertIn("1 failed", page.text("told"))

    def test_a_kernel_that_leaves_an_input_out_is_an_error(self):
        page = self.checked(self.spoiled("gloam_kernel_canary ^ gloam_kernel_index",
                                         "gloam_kernel_canary ^ (gloam_kernel_index & ~1u)"))
        self.assertEqual(["the kernel did not finish for input 1"],
                         [row["error"] for row in page.rows() if row["error"]])

    def test_a_lost_context_costs_one_check(self):
        page = CheckPage(self.browser, self.site)
        self.browser.evaluate("""(() => {
            const {run} = gloam.kernel;
            let runs = 0;
            gloam.kernel.run = (gl, ...rest) => {
                if (++runs === 3) gl.getExtension("WEBGL_lose_context").loseContext();
                return run(gl, ...rest);
            };
        })()""")
        page.click("run")
        page.finish()
        self.assertEqual(["device lost"], [row["reason"] for row in page.rows() if row["reason"]])
        self.assertIn("1 failed (finished)", page.text("told"))
        self.browser.open(self.site / "index.html")  # the next test begins with a page of its own

    def test_the_saved_file_is_merged_with_those_of_drivers(self):
        page = self.checked()
        self.browser.save_downloads_to(self.folder)
        page.click("save")
        saved = self.folder / "gloam-webgl2.json"
        self.browser.wait("new Promise((resolve) => setTimeout(() => resolve(true), 300))")
        device = json.loads(saved.read_text(encoding="utf-8"))["device"]
        self.assertIn("SwiftShader", device["name"])
        other = self.folder / "interpreter.json"
        run("check", "GTAO-arc", "--device", "interpreter", "--inputs", 512, "--json", other)
        merged = self.folder / "merged.json"
        report = run("report", saved, other, "--json", merged)
        self.assertEqual(0, report.returncode, report.stderr)
        self.assertIn("webgl2: ANGLE", report.stdout)
        page_file = self.folder / "merged.html"
        run("report", saved, other, "--html", page_file)
        self.assertIn("WebGL 2.0", page_file.read_text(encoding="utf-8"))
        reports = json.loads(merged.read_text(encoding="utf-8"))
        self.assertEqual(["webgl", "interpreter"], [one["device"]["type"] for one in reports])
        self.assertEqual(len(page.rows()), len(reports[0]["results"]))

    def test_the_table_sorts_and_filters(self):
        page = self.checked()
        self.browser.evaluate("document.querySelectorAll('th button')[3].click()")
        worst = [float(text) for text in page.shown(3)]
        self.assertEqual(sorted(worst, reverse=True), worst)
        self.assertEqual("descending", self.browser.evaluate(
            "document.querySelectorAll('th')[3].getAttribute('aria-sort')"))
        self.browser.evaluate("document.querySelectorAll('th button')[0].click()")
        self.assertEqual("FINITE", page.shown(0)[[name.startswith("FINITE") for name in page.shown(0)].index(True)])
        self.browser.evaluate("document.getElementById('filter').value = 'halton';"
                              "document.getElementById('filter').dispatchEvent(new Event('input'))")
        shown = page.shown(0)
        self.assertTrue(shown and all("HALTON" in name for name in shown), shown)

    def test_the_keyboard_is_enough(self):
        page = CheckPage(self.browser, self.site)
        focused = "document.activeElement.id"
        for _ in range(10):
            if self.browser.evaluate(focused) == "run":
                break
            self.browser.key("Tab")
        self.assertEqual("run", self.browser.evaluate(focused))
        self.browser.key("Enter")
        self.browser.wait("gloam.checkPage.state.rows.length > 3")
        page.click("stop")
        page.finish()
        self.assertIn("stopped", page.text("told"))

    def test_a_small_screen_and_the_dark(self):
        background = "getComputedStyle(document.body).backgroundColor"
        self.browser.look(390, 844, dark=False)
        self.checked()
        light = self.browser.evaluate(background)
        self.assertLessEqual(self.browser.evaluate("document.documentElement.scrollWidth"), 390)
        self.browser.look(390, 844, dark=True)
        self.assertNotEqual(light, self.browser.evaluate(background))


if __name__ == "__main__":
    if program() is None:
        print("no Chromium")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
