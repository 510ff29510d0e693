#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""module_test.py ROOT BUILD [--wheel]: the Python package of a build folder; with --wheel, installed by pip.

Exit status 77: numpy or pip is missing."""
import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT, BUILD = Path(sys.argv[1]), Path(sys.argv[2])
for needed in ("numpy", "pip") if "--wheel" in sys.argv else ("numpy",):
    if importlib.util.find_spec(needed) is None:
        print(f"skipped: {needed} is missing (python3-{needed})")
        sys.exit(77)
if "--wheel" not in sys.argv:
    sys.path.insert(0, str(BUILD / "python"))
    import gloam
    import numpy as np

FIXTURES = ROOT / "tests" / "subject" / "fixtures"
GUIDE = BUILD / "tests" / "judge" / "guide"  # the files of docs/testing.md


class Wheel(unittest.TestCase):
    def test_pip_installs_a_package_that_runs(self):
        with tempfile.TemporaryDirectory() as target:
            pip = [sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-build-isolation", "--no-deps"]
            subprocess.run([*pip, "--target", target, str(ROOT)], check=True,
                           env=dict(os.environ, GLOAM_BUILD=str(BUILD)))
            code = ("import gloam, importlib.metadata as of; print(gloam.__version__ == of.version('gloam'), "
                    "'LICENSE' in [file.name for file in of.files('gloam')], "
                    f"gloam.File({str(GUIDE / 'tone.glsl')!r})['tone_reinhard'](1.0))")
            ran = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True,
                                 env=dict(os.environ, PYTHONPATH=target), cwd=target)
            self.assertEqual(ran.stdout, "True True 0.5\n")


class Module(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.tone = gloam.File(GUIDE / "tone.glsl")["tone_reinhard"]

    def test_a_call_takes_numbers_and_arrays(self):
        self.assertEqual(self.tone(1.0), np.float32(0.5))
        self.assertEqual(self.tone([0.0, 1.0, 3.0]).tolist(), [0.0, 0.5, 0.75])
        self.assertEqual(self.tone(np.ones((2, 3))).shape, (2, 3))

    def test_inputs_broadcast_and_out_parameters_follow_the_result(self):
        lamp = gloam.File(GUIDE / "lamp.glsl", device="interpreter")["lamp_radiance"]
        self.assertEqual(list(lamp.inputs), ["lamp", "dist"])
        words = np.array([1, 2, 4, 8], dtype=np.float32).view(np.uint32)
        color, falloff = lamp(words, [1.0, 0.0])
        self.assertEqual(color.tolist(), [[4, 8, 16], [8, 16, 32]])
        self.assertEqual(falloff.tolist(), [0.5, 1.0])

    def test_macros_are_set(self):
        with tempfile.TemporaryDirectory() as folder:
            fog = Path(folder, "fog.glsl")
            fog.write_text("float fog(float x) { return x * FOG; }\n", encoding="utf-8")
            self.assertEqual(gloam.File(fog, device="interpreter", defines=["FOG=3.0"])["fog"](2.0), 6.0)

    def test_quads_and_discard(self):
        file = gloam.File(FIXTURES / "quads.frag")
        self.assertEqual(file["edge_width"]([0, 1, 2, 3]).tolist(), [3, 3, 3, 3])
        _, discarded = file["cut_out"]([0.2, 0.6, 0.7, 0.4])
        self.assertEqual(discarded.tolist(), [True, False, False, True])

    def test_no_inputs_give_no_results(self):
        self.assertEqual(self.tone([]).shape, (0,))
        normal = gloam.File(FIXTURES / "quads.frag")["face_normal"]
        self.assertEqual(normal(np.zeros((0, 4, 3))).shape, (0, 4, 3))

    def test_a_reference_judges(self):
        right = self.tone.compare(lambda x: x / (1 + x), {"x": (0, 1000)}, ulp=4, inputs=512)
        self.assertTrue(right, str(right))
        self.assertEqual(right.inputs, 512)
        wrong = self.tone.compare(lambda x: x / (1.001 + x), {"x": (0, 1000)}, ulp=4, inputs=512)
        self.assertFalse(wrong)
        self.assertGreater(wrong.outside, 0)
        self.assertIn("worst input", str(wrong))

    def test_a_reference_gets_vectors_as_arrays(self):
        normal = gloam.File(FIXTURES / "quads.frag")["face_normal"]
        seen = []
        normal.compare(lambda p: seen.append(p) or np.zeros((4, 3)), {"p": (0, 1)}, absolute=2, inputs=64)
        self.assertEqual((seen[0].shape, seen[0].dtype), ((4, 3), np.float64))

    def test_half_precision(self):
        file = gloam.File(FIXTURES / "numbers.glsl")
        self.assertEqual(file["half_sum"](2048, [1, 2]).tolist(), [2048.0, 2050.0])
        self.assertEqual(file["half_sum"](1, 2).dtype, np.float16)
        ranges = {"a": (0, 1), "b": (0, 1)}
        self.assertTrue(file["half_sum"].compare(lambda a, b: a + b, ranges, ulp=1, inputs=256))
        self.assertFalse(file["half_sum"].compare(lambda a, b: 1.1 * (a + b), ranges, ulp=1, inputs=256))
        with self.assertRaisesRegex(ValueError, "double is not judged: gloam judges float, float16_t, int"):
            file["of_double"]
        self.assertTrue(file["half_vectors"].check_rules(inputs=256))

    def test_rules_audit_and_explanation(self):
        self.assertTrue(self.tone.check_rules(inputs=512))
        self.assertIn(" at random", self.tone.audit())
        self.assertIn("OpFDiv", self.tone.explain(0.5))
        self.assertEqual(self.tone.domain({"x": (0, 2)}), ["x: 0 to 2 (--range)"])

    def test_errors_name_what_was_expected(self):
        def message(kind, call):
            with self.assertRaises(kind) as caught:
                call()
            return str(caught.exception)
        file = gloam.File(FIXTURES / "own.glsl")
        self.assertIn("it has: own_root", message(ValueError, lambda: file["missing"]))
        self.assertIn("sampler2DMS is not judged", message(
            ValueError, lambda: gloam.File(FIXTURES / "samplers.glsl")["of_several"]))
        self.assertIn("expected 1 values (x), got 2", message(ValueError, lambda: self.tone(1, 2)))
        normal = gloam.File(FIXTURES / "quads.frag")["face_normal"]
        self.assertIn("expected vec3[4]", message(ValueError, lambda: normal(np.ones(3))))
        self.assertIn("which is no input", message(ValueError, lambda: self.tone.check_rules({"y": (0, 1)})))
        self.assertIn("(LOW, HIGH)", message(ValueError, lambda: self.tone.check_rules({"x": (1, 0)})))
        self.assertIn("division by zero", message(RuntimeError, lambda: self.tone.compare(lambda x: 1 / 0, inputs=16)))
        self.assertIn("missing.glsl", message(FileNotFoundError, lambda: gloam.File("missing.glsl")))
        self.assertIn("no Vulkan device", message(RuntimeError, lambda: gloam.File(
            GUIDE / "tone.glsl", device="none")))
        both = message(RuntimeError, lambda: self.tone.compare(lambda x: (x, x), inputs=16))
        self.assertIn("2 output words", both)


if __name__ == "__main__":
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(Wheel if "--wheel" in sys.argv else Module)
    sys.exit(0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1)
