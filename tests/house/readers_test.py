#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""readers_test.py: which tests tools/test-readers runs for a changed shader, in which order, and what it returns."""
import contextlib
import importlib.machinery
import importlib.util
import io
import json
import os
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

SCRIPT = Path(__file__).resolve().parents[2] / "tools" / "test-readers"
LOADER = importlib.machinery.SourceFileLoader("test_readers", str(SCRIPT))
readers = importlib.util.module_from_spec(importlib.util.spec_from_loader("test_readers", LOADER))
LOADER.exec_module(readers)

# A test program: logs its tests, and fails those that it is asked to fail.
PROGRAM = """#!/bin/sh
echo "$3" >> "$LOG"
for test in $(echo "${3#*=}" | tr : ' '); do
    case $test in "$FAILS") fault=${GLOAM_SHADERS:+yes} ;; "$ALWAYS") fault=yes ;; *) fault= ;; esac
    [ "$fault" ] || continue
    case $test in *.endless) exec sleep 60 ;; esac
    echo "[  FAILED  ] $test (1 ms)"
    exit 1
done
"""


class Readers(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name).resolve()
        self.file = self.folder / "glsl" / "disc.glsl"
        for path, text in ((self.file, "a + b"), (self.folder / "copy" / "disc.glsl", "a - b")):
            path.parent.mkdir()
            path.write_text(text, encoding="utf-8")
        for name, lines in {"one.A:A.wide": [self.file, "x", "y", "seconds 3"],
                            "one.A:A.narrow": [self.file, "x", "seconds 1"],
                            "one.A:B,disc": [self.file, "seconds 1"], "one.A:A.blind": ["x", "seconds 1"],
                            "two.A": [self.file], "two.A:C.shared": ["seconds 1"]}.items():
            path = self.folder / "seen" / name
            path.parent.mkdir(exist_ok=True)
            path.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
        self.log = self.folder / "log"
        self.program = self.folder / "program"
        self.program.write_text(PROGRAM, encoding="utf-8")
        self.program.chmod(0o755)

    def run_it(self, *words, changed="disc.glsl", fails="none", always="none"):
        """The exit status, and the tests of each run of a program: `fails` fails with the fault, `always` without."""
        self.log.unlink(missing_ok=True)
        variables = {"LOG": str(self.log), "FAILS": fails, "ALWAYS": always,
                     "GLOAM_CACHE_DIR": str(self.folder / "cache")}
        environment = {"GLOAM_SHADERS": str(self.folder / "copy"), "GLOAM_SHADERS_OF": str(self.folder / "glsl"),
                       "GLOAM_SHADERS_CHANGED": changed}
        groups = [(name, (str(self.program), variables)) for name in ("one.A", "two.A")]
        with mock.patch.multiple(readers, BUILD=self.folder, programs=lambda: groups), \
                mock.patch.dict(os.environ, environment), mock.patch.object(sys, "argv", ["test-readers", *words]), \
                contextlib.redirect_stderr(io.StringIO()):
            status = readers.main()
        ran = self.log.read_text(encoding="utf-8").splitlines() if self.log.exists() else []
        return status, [line.removeprefix("--gtest_filter=") for line in ran]

    def test_what_reads_the_file_itself_comes_first_and_of_these_what_reads_the_fewest(self):
        self.assertEqual(self.run_it(), (0, ["B/disc", "A.narrow:A.wide:C.shared"]))

    def test_a_limit_and_the_first_failure_end_it(self):
        self.assertEqual(self.run_it("2"), (0, ["B/disc", "A.narrow"]))
        self.assertEqual(self.run_it(fails="B/disc"), (1, ["B/disc", "B/disc"]))
        self.assertEqual(self.run_it(fails="A.wide"), (1, ["B/disc", "A.narrow:A.wide:C.shared", "A.wide"]))

    def test_what_fails_without_a_fault_as_well_does_not_count(self):
        self.assertEqual(self.run_it(always="A.wide"),
                         (0, ["B/disc", "A.narrow:A.wide:C.shared", "A.wide", "A.narrow:C.shared"]))
        self.assertEqual(self.run_it(always="A.wide", fails="C.shared")[0], 1)

    def test_a_test_that_does_not_end_counts_if_it_ends_without_the_fault(self):
        with mock.patch.multiple(readers, LEAST_PATIENCE=0.2, PATIENCE=0.0):
            self.assertEqual(self.run_it(fails="A.endless")[0], 0)
            (self.folder / "seen" / "one.A:A.endless").write_text(f"{self.file}\nseconds 1\n", encoding="utf-8")
            self.assertEqual(self.run_it(fails="A.endless")[0], 1)

    def test_without_a_fault_nothing_runs(self):
        (self.folder / "copy" / "disc.glsl").write_text("a + b", encoding="utf-8")
        self.assertEqual(self.run_it(fails="B/disc"), (0, []))

    def test_without_readers_or_variables_it_cannot_run(self):
        self.assertEqual(self.run_it(changed="none.glsl"), (2, []))
        self.assertEqual(self.run_it("2", "3"), (2, []))

    def test_a_group_is_its_program_without_its_shard(self):
        listing = [{"name": "g.A/1of2", "command": ["program", "--gtest_filter=A.*"],
                    "properties": [{"name": "ENVIRONMENT", "value": ["GLOAM_DEPENDENCIES_OUTPUT=seen", "A=b",
                                                                     "GTEST_TOTAL_SHARDS=2", "GTEST_SHARD_INDEX=0"]}]},
                   {"name": "house.format", "command": ["format"]}]
        listed = mock.Mock(stdout=json.dumps({"tests": listing}))
        with mock.patch.object(readers.subprocess, "run", return_value=listed):
            self.assertEqual(list(readers.programs()), [("g.A,1of2", ("program", {"A": "b"}))])

    def test_compiled_shaders_of_the_run_are_forgotten(self):
        cache = self.folder / "cache" / "spirv"
        cache.mkdir(parents=True)
        for name, age in (("old", 1), ("new", 4e9)):
            (cache / name).touch()
            os.utime(cache / name, (age, age))
        self.run_it()
        self.assertEqual([entry.name for entry in cache.iterdir()], ["old"])


if __name__ == "__main__":
    unittest.main()
