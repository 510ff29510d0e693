#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mutants_test.py: the faults that tools/mutants draws, what they change, and that files are restored."""
import contextlib
import json
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools" / "mutants"))
import mutants  # noqa: E402
from faults import faults_of  # noqa: E402
from modules import Modules, is_conditional  # noqa: E402
from tests import Tests  # noqa: E402

TEXT = """#ifndef GLOAM_X_GLSL
// A comment: a < b.
struct Both { float first; float second; };
layout(constant_id = 1) const int steps = 4;
float chosen(Both both, vec3 v) {
    if (v.x < -both.first) return 1.0;
    float sum = max(v.y, 2.0);
    sum += v.z > 0.0 && both.second != 3.0 ? 0.5 : sum;
    return sum;
}
#endif
"""
FILE = "gloam/occlusion/bias.glsl"


def changed(text):
    """The lines that the faults of a text make."""
    lines = set()
    for place in faults_of(text, text):
        for start, end, new in place:
            fault = text[:start] + new + text[end:]
            lines |= {line.strip() for line in fault.splitlines()} - {line.strip() for line in text.splitlines()}
    return lines


class Faults(unittest.TestCase):
    def test_each_kind_is_found(self):
        for line in ("if (v.x <= -both.first) return 1.0;", "if (v.y < -both.first) return 1.0;",
                     "if (v.x < both.first) return 1.0;", "if (v.x < -both.second) return 1.0;",
                     "if (true) return 1.0;", "if (false) return 1.0;", "if (v.x < -both.first) return 0.0;",
                     "float sum = min(v.y, 2.0);", "float sum = max(v.y, 4.0);",
                     "sum -= v.z > 0.0 && both.second != 3.0 ? 0.5 : sum;",
                     "sum += v.z > 0.0 || both.second != 3.0 ? 0.5 : sum;",
                     "sum += v.z > 0.0 && both.second == 3.0 ? 0.5 : sum;", "sum += true ? 0.5 : sum;", ";"):
            self.assertIn(line, changed(TEXT))

    def test_comments_directives_and_the_interface_are_left_alone(self):
        for line in changed(TEXT):
            self.assertNotRegex(line, "comment|#|layout|struct")

    def test_a_seed_draws_the_same_faults(self):
        files = mutants.files_under([ROOT / "glsl" / "gloam" / "occlusion"])
        one, same, other = (mutants.drawn(files, 20, seed) for seed in (1, 1, 2))
        self.assertEqual(one, same)
        self.assertNotEqual(one, other)
        for fault in one:
            text = (ROOT / fault["file"]).read_text(encoding="utf-8")
            self.assertNotEqual(mutants.planted(fault, text)[0], text)

    def test_a_line_that_has_moved_is_found_and_one_that_is_gone_is_not(self):
        fault = mutants.drawn([ROOT / "glsl" / FILE], 1, 1)[0]
        text = (ROOT / "glsl" / FILE).read_text(encoding="utf-8")
        moved = mutants.planted(fault, "\n\n" + text)[0]
        self.assertEqual(moved, "\n\n" + mutants.planted(fault, text)[0])
        self.assertIsNone(mutants.planted(fault, text.replace(fault["of"], "")))


class Change(unittest.TestCase):
    def test_of_the_module(self):
        with tempfile.TemporaryDirectory() as scratch:
            modules = Modules(Path(scratch))
            text = (ROOT / "glsl" / FILE).read_text(encoding="utf-8")
            at = text.index("scaled <= GLOAM_LARGEST")
            for new, verdict in (("(scaled <= GLOAM_LARGEST)", "same"), ("scaled >= GLOAM_LARGEST", "other"),
                                 ("scaled <= nothing", "invalid")):
                after = text[:at] + new + text[at + len("scaled <= GLOAM_LARGEST"):]
                self.assertEqual(modules.change(FILE, text, after, at), verdict)

    def test_what_some_definitions_exclude_is_not_judged(self):
        self.assertFalse(is_conditional(TEXT, TEXT.index("sum")))
        self.assertTrue(is_conditional("#ifdef GLOAM_A\nfloat a;\n#endif\n", 16))


class Trial(unittest.TestCase):
    def setUp(self):
        self.tests = Tests.__new__(Tests)
        self.tests.groups = {"group": ("program", {})}
        self.tests.lists = {("group", name): ({"a.glsl"}, 1.0) for name in ("A.one", "A.two", "A.three")}
        self.tests.shared, self.tests.sound, self.tests.useful = {}, {}, set()
        self.failing = set()
        self.tests.run = lambda group, names, seconds: next((name for name in names if name in self.failing), None)

    def failing_within(self, seconds):
        return self.tests.failing(Path("a.glsl"), contextlib.nullcontext, seconds)

    def test_of_all_tests_or_of_as_many_as_the_seconds_allow(self):
        self.assertEqual(self.failing_within(100.0), (None, 0))
        self.assertEqual(self.failing_within(1.0), (None, 2))
        self.assertEqual(self.failing_within(2.0), (None, 1))

    def test_a_test_that_fails_without_the_fault_notices_nothing(self):
        self.failing = {"A.two"}
        self.assertEqual(self.failing_within(100.0), (None, 0))
        self.tests.sound["A.two"] = True
        self.assertEqual(self.failing_within(100.0)[0], "A.two")
        self.assertEqual(self.tests.useful, {"A.two"})


class Restored(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.bench = mutants.Bench.__new__(mutants.Bench)
        self.bench.stash = Path(scratch.name) / "mutants.original"
        self.file = Path(scratch.name) / "a.glsl"
        self.file.write_text("original", encoding="utf-8")

    def test_after_an_error_inside_of_another_change(self):
        with self.assertRaises(KeyboardInterrupt), self.bench.with_text(self.file, "fault"):
            with self.bench.with_text(self.file, "original"):
                self.assertEqual(self.file.read_text(encoding="utf-8"), "original")
            self.assertEqual(self.file.read_text(encoding="utf-8"), "fault")
            raise KeyboardInterrupt
        self.assertEqual(self.file.read_text(encoding="utf-8"), "original")
        self.assertFalse(self.bench.stash.exists())

    def test_by_the_next_run_after_a_kill(self):
        self.file.write_text("fault", encoding="utf-8")
        self.bench.stash.write_text(json.dumps({"file": str(self.file), "text": "original"}), encoding="utf-8")
        self.bench.restore()
        self.assertEqual(self.file.read_text(encoding="utf-8"), "original")
        self.assertFalse(self.bench.stash.exists())


if __name__ == "__main__":
    unittest.main()
