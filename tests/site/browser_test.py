#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""browser_test.py GLOAM JUDGE_CASES: the site that `gloam site` writes, used in headless Chromium as a person would.

Left with status 77 where there is no Chromium."""
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from check_page import CheckPage
from site_case import GLOAM, SiteCase, main

JUDGE_CASES = sys.argv[2]
NATIVE = "es:llvmpipe-3.0"  # the device whose verdicts a browser's must be
SMALL = ("TSSAO-10", "TSSAO-10-g", "TSSAO-11", "GTAO-arc")  # equations of a site whose kernels are spoiled

# What the judge of the page says of the outputs in gloam.cases, beside what the framework said of them.
JUDGE_ALL = """Promise.all(gloam.cases.map(async ({check, outputs, answer}) => {
    const tally = gloam.judge.newTally();
    for (const [i, scenario] of check.scenarios.entries())
        gloam.judge.addScenario(tally, check, await gloam.judge.decode(scenario),
            await gloam.values(Uint32Array, outputs[i]));
    return [answer, gloam.results.row(check, {tally, fault: "", error: "", reason: "", seconds: 0})];
}))"""


def run(*arguments):
    """The program with these arguments."""
    return subprocess.run([GLOAM, *map(str, arguments)], capture_output=True, text=True, check=False)


class SiteTest(SiteCase):
    # Some of each kind: with images, with many outputs, integers, inputs that the budget moves.
    EQUATIONS = ["GTAO-a*", "GTAO-gather", "TSSAO-10*", "TSSAO-RP-h*", "CS-Q-b*", "HALTON*", "NORMAL*", "FINITE*"]

    @classmethod
    def words(cls):
        return [*cls.EQUATIONS, "--method", "sweep", "--no-pictures"]

    def setUp(self):
        self.browser.look(1200, 900)

    def spoiled(self, old, new):
        """A small site in which the kernel of a function of the filters is changed in one place."""
        small = self.folder / "small"
        if not small.exists():
            run("site", small, *SMALL, "--method", "sweep", "--no-pictures").check_returncode()
        copy = Path(tempfile.mkdtemp(dir=self.folder)) / "site"
        shutil.copytree(small, copy)
        file = copy / "checks-filter.js"
        text = file.read_text(encoding="utf-8")
        self.assertIn(old, text)
        file.write_text(text.replace(old, new, 1), encoding="utf-8")
        return copy

    def checked(self, site=None):
        """A page whose checks have run; that of an earlier test where it is still open."""
        site = site or self.site
        page = CheckPage(self.browser, site, again=False)
        if self.browser.evaluate("!document.getElementById('told').textContent.includes('finished')"):
            page.click("run")
            page.finish()
        return page

    def test_the_checks_pass_and_ask_no_network(self):
        page = self.checked()
        rows = page.rows()
        self.assertGreater(len(rows), 20)
        # No input is judged for which a test of finite numbers gives false: a constant would pass.
        not_judged = {row["equation"]: row["not_judged_because"] for row in rows if row["outcome"] != "ok"}
        self.assertEqual({"FINITE", "FINITE-2", "FINITE-3", "FINITE-4"}, set(not_judged))
        self.assertEqual({"no input could be judged whose result is false: a function that is always true would pass"},
                         set(not_judged.values()))
        self.assertIn(f"{len(rows) - 4} ok, 0 failed, 4 not judged (finished)", page.text("told"))
        self.assertIn("SwiftShader", page.text("gpu"))
        self.assertEqual([], self.browser.problems())
        asked = [url for url in self.browser.requests() if not url.startswith(("file:", "blob:", "about:"))]
        self.assertEqual([], asked)

    def test_the_results_agree_with_those_of_the_program(self):
        file = self.folder / "native.json"
        native = run("check", *self.EQUATIONS, "--device", NATIVE, "--inputs", 128, "--json", file)
        if native.returncode == 2:
            self.skipTest(native.stderr)
        known = {row["equation"]: row for row in json.loads(file.read_text(encoding="utf-8"))["results"]}
        rows = self.checked().rows()
        self.assertEqual(sorted(known), sorted(row["equation"] for row in rows))
        for row in rows:
            there = known[row["equation"]]
            for member in ("function", "file", "variant", "verdict", "inputs", "outside", "recorded", "classes",
                           "budget"):
                self.assertEqual(there[member], row[member], f"{row['equation']}: {member}")
            self.assertEqual(set(there), set(row))

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

    def fresh(self, site=None):
        """A page whose checks have not run."""
        return CheckPage(self.browser, site or self.site)

    def run_all(self, page):
        """The reasons of the checks that failed."""
        page.click("run")
        page.finish()
        self.assertIn("(finished)", page.text("told"))
        return [row["reason"] for row in page.rows() if row["outcome"] == "failed"]

    def test_what_is_wrong_with_a_kernel_fails_one_check(self):
        endless = "for (;;) { } while (true) if (true) continue; do { } while (true); for (int i = 0; i < 1; ) i = 0;"
        for old, new, reason, words in (
                ("floatBitsToUint(gloam_kernel_result)", "floatBitsToUint(gloam_kernel_result * 1.0001)", "", "0x"),
                ("void main() {", "void main() { no_such_name = 1.0;", "error", "no_such_name"),
                ("gloam_kernel_canary ^ gloam_kernel_index", "gloam_kernel_canary ^ (gloam_kernel_index & ~1u)",
                 "error", "the kernel did not finish for input 1"),
                ("void main() {", "void main() { " + endless, "error", "does not end for input 0")):
            with self.subTest(new):
                page = self.fresh(self.spoiled(old, new))
                self.assertEqual([reason], self.run_all(page))
                self.assertIn("1 failed", page.text("told"))
                self.assertEqual(1, page.shown(0).count(reason or "failed"))
                row = next(row for row in page.rows() if row["outcome"] == "failed")
                self.assertIn(words, row["error"] or row["worst"]["values"])

    def test_a_driver_that_fails_or_does_not_return_costs_one_check(self):
        limited = """(() => {
            const {evaluate} = gloam.runner.Runner.prototype;
            gloam.runner.Runner.prototype.evaluate = function (check, scenarios) {
                gloam.runner.limits.evaluate = check.function === "gloam_gtao_arc" ? 1 : 600;
                return evaluate.call(this, check, scenarios);
            };
        })()"""
        for before, script, reason in (
                ("0", "passes.gl.getExtension('WEBGL_lose_context').loseContext();", "device lost"),
                (limited, "for (;;);", "hang")):
            with self.subTest(reason):
                page = self.fresh()
                page.before_run("gloam_gtao_arc", script)
                self.browser.evaluate(before)
                self.assertEqual([reason], self.run_all(page))
        self.browser.open(self.site / "index.html")  # the next test begins with a page of its own

    def test_a_failed_kernel_is_shown_with_the_line_of_its_error(self):
        page = self.checked(self.spoiled("void main() {", "void main() { no_such_name = 1.0;"))
        shown = self.browser.evaluate("""(() => {
            const row = [...document.querySelectorAll("tbody tr")].find((row) => row.cells[0].textContent === "error");
            row.querySelector(".small").click();
            const lines = [...document.querySelectorAll("dialog .code .line")];
            return [document.querySelector("dialog").open, lines.map((line) => line.textContent).join(""),
                lines.filter((line) => line.matches(".bad")).map((line) => line.textContent),
                getComputedStyle(lines[1], "::before").content, row.cells[9].textContent];
        })()""")
        self.assertTrue(shown[0])
        self.assertTrue(shown[1].startswith("#version 300 es\nprecision highp float;"), shown[1])
        self.assertEqual(["void main() { no_such_name = 1.0;\n"], shown[2])
        self.assertEqual("counter(line)", shown[3])
        self.assertIn("no_such_name", shown[4])

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

    def test_the_table_sorts(self):
        page = self.checked()
        self.browser.evaluate("document.querySelectorAll('th button')[3].click()")
        worst = [float(text) for text in page.shown(3)]
        self.assertEqual(sorted(worst, reverse=True), worst)
        self.assertEqual("descending", self.browser.evaluate(
            "document.querySelectorAll('th')[3].getAttribute('aria-sort')"))
        self.browser.evaluate("document.querySelectorAll('th button')[1].click()")
        self.assertEqual(sorted(page.shown(1)), page.shown(1))

    def tab_to(self, selector):
        """Presses Tab until an element has the focus; it is visible then."""
        for _ in range(40):
            self.browser.key("Tab")
            if self.browser.evaluate(f"document.activeElement.matches({json.dumps(selector)})"):
                outline = self.browser.evaluate("getComputedStyle(document.activeElement).outline")
                self.assertRegex(outline, "solid 2px")
                return
        self.fail(f"Tab does not reach {selector}")

    def test_the_keyboard_is_enough(self):
        page = self.fresh(self.spoiled("void main() {", "void main() { no_such_name = 1.0;"))
        self.tab_to("#run")
        self.browser.key("Enter")
        page.finish()
        for selector in ("#save", "#results", "th button"):
            self.tab_to(selector)
        self.browser.key("Space")
        self.assertEqual("ascending", self.browser.evaluate("document.querySelector('th').getAttribute('aria-sort')"))
        self.tab_to("tbody .small")
        self.browser.key("Space")
        self.tab_to(".code")
        self.browser.key("Escape")
        self.assertFalse(self.browser.evaluate("document.querySelector('dialog').open"))

    def test_the_focus_stays_on_the_buttons_of_a_run(self):
        page = self.fresh()
        self.tab_to("#run")
        self.browser.key("Enter")
        self.browser.wait("gloam.checkPage.state.rows.length > 3")
        self.assertEqual("stop", self.browser.evaluate("document.activeElement.id"))
        self.browser.key("Space")
        page.finish()
        self.assertIn("stopped", page.text("told"))
        self.assertEqual("run", self.browser.evaluate("document.activeElement.id"))
        self.browser.key("Enter")
        page.finish()
        self.assertEqual(len(page.rows()), len(page.shown(0)))  # those of the first run are gone
        self.assertEqual("status", self.browser.evaluate("document.getElementById('told').getAttribute('role')"))


if __name__ == "__main__":
    main(2)
