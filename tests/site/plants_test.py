#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""plants_test.py GLOAM: the page that checks the browser notices wrong results in every check of the site.

Left with status 77 where there is no Chromium."""
import tempfile
import unittest
from pathlib import Path

from browser import Browser
from check_page import CheckPage, run
from site_case import main

# Replaces what each kernel returns, judges that as the page does, and keeps in gloam.missed what does not fail.
PLANT = """(() => {
    const constant = {f: 0x42280000, i: 42, u: 42, b: 1};  // 42.0
    const rows = (outputs, width) => Array.from({length: outputs.length / width},
        (_, i) => outputs.slice(i * width, (i + 1) * width));
    const plants = {
        constant: (outputs, check) => outputs.map((_, i) => constant[check.outputs[i % check.outputs.length]]),
        zero: (outputs) => outputs.map(() => 0),
        "swapped words": (outputs, check) =>
            Uint32Array.from(rows(outputs, check.outputs.length).flatMap((row) => [...row.reverse()])),
        "results of another input": (outputs, check) =>
            Uint32Array.from(rows(outputs, check.outputs.length).reverse().flatMap((row) => [...row]))
    };
    const outcomeOf = (check, scenarios, outputs) => {
        const tally = gloam.judge.newTally();
        scenarios.forEach((data, i) => gloam.judge.addScenario(tally, check, data, outputs[i]));
        return gloam.judge.outcomeOf({tally, fault: "", error: "", reason: ""}).outcome;
    };
    gloam.missed = [];
    const {evaluate} = gloam.runner.Runner.prototype;
    gloam.runner.Runner.prototype.evaluate = async function (check, scenarios) {
        const results = await evaluate.call(this, check, scenarios);
        if (outcomeOf(check, scenarios, results.map((result) => result.outputs)) === "not judged") return results;
        for (const [name, plant] of Object.entries(plants)) {
            const outputs = results.map((result) => plant(result.outputs, check));
            // One word cannot be swapped, and all results of some functions are the same.
            if (outputs.every((words, i) => words.every((word, k) => word === results[i].outputs[k]))) continue;
            const outcome = outcomeOf(check, scenarios, outputs);
            if (outcome !== "failed") gloam.missed.push(`${check.equation}, ${name}: ${outcome}`);
        }
        return results;
    };
})()"""


class PlantsTest(unittest.TestCase):
    def test_each_planted_result_fails_in_every_check(self):
        with tempfile.TemporaryDirectory() as folder:
            written = run("site", folder, "--method", "sweep", "--no-pictures")
            self.assertEqual(0, written.returncode, written.stderr)
            with Browser(timeout=250) as browser:
                self.plant(browser, Path(folder))

    def plant(self, browser, folder):
        page = CheckPage(browser, folder)
        browser.evaluate(PLANT)
        # The loops of all kernels need 1/16 of the rounds that they may take.
        browser.evaluate("gloam.workerText = gloam.workerText.replace('most = 2 ** 14', 'most = 2 ** 10');"
                         "gloam.checkPage.state.runner.end()")
        page.click("run")
        page.finish()
        rows = page.rows()
        self.assertGreater(len(rows), 250)
        self.assertEqual([], [(row["equation"], row["error"] or row["story"])
                              for row in rows if row["outcome"] == "failed"])
        self.assertEqual([], browser.evaluate("gloam.missed"))


if __name__ == "__main__":
    main()
