#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""webgpu_test.py GLOAM: the checks of the site in WebGPU, in headless Chromium.

Left with status 77 where there is no Chromium, or none with WebGPU."""
import json

from check_page import NATIVE, CheckCase, CheckPage, compare, run
from site_case import main, skip

# The four of FINITE* are not judged: no input whose result is false is.
NOT_JUDGED = 4


class WebGpuTest(CheckCase):
    # Some of each kind: with images, with many outputs, integers, structures.
    EQUATIONS = ["GTAO-a*", "GTAO-gather", "TSSAO-10*", "TSSAO-RP-h*", "HALTON*", "NORMAL*", "FINITE*"]

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        if not CheckPage(cls.browser, cls.site).choose("webgpu"):
            skip("no WebGPU")

    def checked(self, site=None):
        """A page whose checks have run in WebGPU; that of an earlier test where it is still open."""
        page = CheckPage(self.browser, site or self.site, again=False)
        if "finished" not in page.text("told"):
            self.assertTrue(page.choose("webgpu"))
            page.click("run")
            page.finish()
        return page

    def test_the_results_agree_with_those_of_the_program(self):
        file = self.folder / "native.json"
        native = run("check", *self.EQUATIONS, "--device", NATIVE, "--inputs", 512, "--json", file)
        if native.returncode == 2:
            self.skipTest(native.stderr)
        known = {row["equation"]: row for row in json.loads(file.read_text(encoding="utf-8"))["results"]}
        page = self.checked()
        self.assertGreater(len(page.rows()), 20)
        compare(self, known, page.rows())
        self.assertIn(f" 0 failed, {NOT_JUDGED} not judged (finished)", page.text("told"))
        self.assertEqual([], self.browser.problems())

    def test_a_kernel_with_a_wrong_result_fails(self):
        page = self.checked(self.spoiled("bitcast<u32>(gloam_kernel_result)",
                                         "bitcast<u32>(gloam_kernel_result * 1.0001)"))
        failed = [row for row in page.rows() if row["outside"]]
        self.assertEqual(1, len(failed))
        self.assertIn("1 failed", page.text("told"))
        self.assertNotEqual([], failed[0]["worst"]["input_words"])

    def test_kernels_that_were_changed_without_a_change_of_meaning_pass(self):
        site = self.folder / "changed"
        written = run("site", site, "GTAO-a*", "TSSAO-10*", "UNIT", "BITMASK", "--method", "sweep", "--no-pictures",
                      "--metamorphic", 3)
        self.assertEqual(0, written.returncode, written.stderr)
        page = self.checked(site)
        self.assertGreater(len(page.rows()), 4)
        self.assertEqual([], [row for row in page.rows() if row["outside"] or row["error"]])

    def test_a_kernel_that_does_not_compile_is_an_error(self):
        page = self.checked(self.spoiled("fn gloam_gaussian", "fn gloam_gauss"))
        errors = [row for row in page.rows() if row["error"]]
        self.assertEqual(["error"], [row["reason"] for row in errors])
        self.assertIn("unresolved call target", errors[0]["error"])

    def test_a_kernel_that_leaves_an_input_out_is_an_error(self):
        page = self.checked(self.spoiled("gloam_kernel_index = gloam_kernel_input()",
                                         "gloam_kernel_index = (gloam_kernel_input() & 0xfffffffeu)"))
        self.assertEqual(["the kernel did not finish for input 1"],
                         [row["error"] for row in page.rows() if row["error"]])

    def test_a_lost_device_costs_one_check(self):
        page = CheckPage(self.browser, self.site)
        self.assertTrue(page.choose("webgpu"))
        page.before_run("webgpu", "gloam_gtao_arc", "device.destroy(); await device.lost;")
        page.click("run")
        page.finish()
        self.assertEqual(["device lost"], [row["reason"] for row in page.rows() if row["reason"]])
        self.assertIn(f"1 failed, {NOT_JUDGED} not judged (finished)", page.text("told"))
        self.browser.open(self.site / "index.html")  # the next test begins with a page of its own

    def test_a_kernel_that_never_ends_costs_one_check(self):
        page = self.checked(self.spoiled("let gloam_kernel_output_at", "loop { } for (;;) { } while true { if true "
                                         "{ continue; } } let gloam_kernel_output_at"))
        self.assertEqual(["error"], [row["reason"] for row in page.rows() if row["outcome"] == "failed"])
        self.assertIn("does not end for input 0", [row["error"] for row in page.rows() if row["error"]][0])
        self.assertIn("1 failed, 0 not judged (finished)", page.text("told"))

    def test_the_saved_file_is_merged_with_those_of_drivers(self):
        page = self.checked()
        self.browser.save_downloads_to(self.folder)
        page.click("save")
        saved = self.folder / "gloam-webgpu.json"
        self.browser.wait("new Promise((resolve) => setTimeout(() => resolve(true), 300))")
        merged = self.folder / "merged.json"
        report = run("report", saved, "--json", merged)
        self.assertEqual(0, report.returncode, report.stderr)
        self.assertIn("webgpu: ", report.stdout)
        there = json.loads(merged.read_text(encoding="utf-8"))
        self.assertEqual("webgpu", there["device"]["type"])
        self.assertEqual(len(page.rows()), len(there["results"]))


if __name__ == "__main__":
    main()
