#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""seeing_test.py PROGRAM: PROGRAM is a GoogleTest of gloam, glsl_geometry_tests.

Each of its tests writes the shaders that it reads into a list of its own, and only the tests of given lists run: what
`tools/test --seeing FILE` relies on."""
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "tools" / "test"

SUITE = "Reprojection"
SHADER = "gloam/geometry/reprojection.glsl"
OTHER = "Normal.OfBackgroundIsZero"  # reads other shaders


def run(folder, **variables):
    """Names of the tests that ran."""
    environment = {**os.environ, "GLOAM_DEPENDENCIES_OUTPUT": str(folder / "geometry.group"), **variables}
    result = subprocess.run([sys.argv[1], f"--gtest_filter={SUITE}.*"], env=environment, capture_output=True, text=True)
    if result.returncode != 0:
        raise AssertionError(result.stdout + result.stderr)
    return re.findall(r"^\[       OK \] (\S+)", result.stdout, re.M)


class Seeing(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.all = run(self.folder)
        self.only = self.folder / "only"

    def run_only(self, *lists, **variables):
        self.only.write_text("".join(f"{name}\n" for name in lists), encoding="utf-8")
        return run(self.folder, GLOAM_ONLY_LISTS=str(self.only), **variables)

    def test_each_test_has_a_list_of_what_it_reads(self):
        self.assertGreater(len(self.all), 2)
        reading = [file for file in self.folder.iterdir() if SHADER in file.read_text(encoding="utf-8")]
        self.assertTrue(reading)
        for file in reading:
            self.assertIn(file.name.removeprefix("geometry.group:"), self.all)

    def cold_list(self, *names):
        """What the first of the tests reads, with nothing compiled before."""
        with tempfile.TemporaryDirectory() as scratch:
            folder = Path(scratch)
            only = folder / "only"
            only.write_text("".join(f"geometry.group:{name}\n" for name in names), encoding="utf-8")
            run(folder, GLOAM_ONLY_LISTS=str(only), GLOAM_CACHE_DIR=str(folder / "cache"))
            lines = (folder / f"geometry.group:{names[0]}").read_text(encoding="utf-8").splitlines()
            return {line for line in lines if not line.startswith("seconds ")}

    def test_a_list_holds_nothing_that_later_tests_read(self):
        # The compiler's process, which reads includes, is started by the first test and serves all.
        self.assertEqual(self.cold_list(self.all[0], OTHER), self.cold_list(self.all[0]))

    def test_the_last_line_of_a_list_is_the_time(self):
        for file in self.folder.glob("geometry.group:*"):
            self.assertRegex(file.read_text(encoding="utf-8").splitlines()[-1], r"^seconds [0-9.]+$", file.name)

    def test_only_the_listed_tests_run(self):
        self.assertEqual(self.run_only(f"geometry.group:{self.all[1]}", f"other.group:{self.all[0]}"), [self.all[1]])
        self.assertEqual(self.run_only("other.group"), [])

    def test_the_list_of_the_group_means_all_of_it(self):
        self.assertEqual(self.run_only(f"geometry.group:{self.all[1]}", "geometry.group"), self.all)

    def test_a_shard_runs_its_listed_tests_whatever_its_number(self):
        listed = [f"geometry.group:{name}" for name in self.all[:2]]
        shard = {"GTEST_TOTAL_SHARDS": "2", "GTEST_SHARD_INDEX": "1"}
        self.assertEqual(self.run_only(*listed, **shard), self.all[:2])

    def within(self, seconds, lists):
        """What tools/test --within keeps of lists, given as {name: (files, seconds)}, on one core."""
        with tempfile.TemporaryDirectory() as scratch:
            seen = Path(scratch) / "seen"
            seen.mkdir()
            for name, (files, took) in lists.items():
                text = "".join(f"/{i}.glsl\n" for i in range(files)) + (f"seconds {took}\n" if ":" in name else "")
                (seen / name).write_text(text, encoding="utf-8")
            function = f'source <(sed -n "/^within()/,/^}}/p" {SCRIPT})'
            code = f"nproc() {{ echo 1; }}; build={scratch}; {function}; within {seconds}"
            result = subprocess.run(["bash", "-euc", code], input="".join(f"{name}\n" for name in lists),
                                    capture_output=True, text=True, check=True)
            return set(result.stdout.split())

    def test_within_a_time_tests_of_few_files_come_first(self):
        lists = {"a:wide": (50, 1.0), "a:narrow": (2, 6.0), "b:middle": (9, 2.0)}
        self.assertEqual(self.within(100, lists), set(lists))
        self.assertEqual(self.within(9, lists), {"a:narrow", "b:middle"})  # 6 + 2 and the starts of two groups
        self.assertEqual(self.within(7, lists), {"a:narrow"})
        self.assertEqual(self.within(1, lists), {"a:narrow"})  # one at least

    def groups_within(self, seconds, groups, first=()):
        """The groups that tools/test --within chooses of groups, given as {name: seconds or None}, on one core."""
        with tempfile.TemporaryDirectory() as scratch:
            costs = Path(scratch) / "Testing" / "Temporary" / "CTestCostData.txt"
            costs.parent.mkdir(parents=True)
            costs.write_text("".join(f"{name} 3 {took}\n" for name, took in groups.items() if took is not None) +
                             "---\nfailed.before\n", encoding="utf-8")
            listed = Path(scratch) / "tests" / "releases.txt"
            listed.parent.mkdir()
            listed.write_text("# why\n" + "".join(f"{name}\n" for name in first), encoding="utf-8")
            code = (f"nproc() {{ echo 1; }}; build={scratch}; root={scratch}; "
                    f'source <(sed -n "/^groups_within()/,/^}}/p" {SCRIPT}); groups_within {seconds}')
            return subprocess.run(["bash", "-euo", "pipefail", "-c", code], capture_output=True, text=True, check=True,
                                  input="".join(f"{name}\n" for name in groups)).stdout.split()

    def test_within_a_time_groups_that_differed_come_first_and_then_quick_ones(self):
        groups = {"a.Slow": 60, "b.Quick": 1, "c.New": None, "d.All/Differs/1of2": 30}
        differed = ["d.All/Differs/1of2", "e.Removed"]
        self.assertEqual(self.groups_within(100, groups, differed),
                         ["d.All/Differs/1of2", "b.Quick", "c.New", "a.Slow"])
        self.assertEqual(self.groups_within(36, groups, differed), ["d.All/Differs/1of2", "b.Quick", "c.New"])
        self.assertEqual(self.groups_within(32, groups), ["b.Quick", "c.New"])
        self.assertEqual(self.groups_within(1, groups, differed), ["d.All/Differs/1of2"])  # one at least

    def test_a_group_takes_as_long_as_its_tests(self):
        lists = {"a": (1, 0.0), "a:one": (5, 4.0), "a:two": (6, 4.0)}
        self.assertEqual(self.within(9, lists), {"a"})
        self.assertEqual(self.within(5, {"b:other": (1, 1.0), **lists}), {"b:other"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
