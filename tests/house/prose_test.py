#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""prose_test.py: prose.py and format find what they look for, and nothing else."""
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import prose

HERE = Path(__file__).resolve().parent
WORDS = " ".join(["word"] * 36)


class ProseTest(unittest.TestCase):
    def found(self, name, text):
        """The messages about a folder with one file."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            return prose.check(Path(folder))

    def expect_one(self, name, text, part):
        messages = self.found(name, text)
        self.assertEqual(len(messages), 1, messages)
        self.assertIn(part, messages[0])

    def test_long_lines(self):
        self.expect_one("a.cpp", "x" * 121 + "\n", "a.cpp:1: [columns] 121 columns")
        self.expect_one("a.md", "short\n\n" + "x" * 121 + "\n", "a.md:3: [columns]")
        self.assertEqual(self.found("a.cpp", "x" * 120 + "\n"), [])
        self.assertEqual(self.found("a.md", "| " + "x" * 200 + " |\n"), [])
        self.assertEqual(self.found("a.md", "```text\n" + "x" * 200 + "\n```\n"), [])

    def test_long_sentences(self):
        broken = WORDS.replace(" ", "\n")
        self.expect_one("a.md", broken + ".\n", "a.md:1: [sentences] a sentence of 36 words")
        self.expect_one("harness/a.hpp", "int x;\n// " + WORDS.replace(" ", "\n// ") + "\n", "a.hpp:2: [sentences]")
        self.assertEqual(self.found("a.md", broken.replace("word\nword", "word.\nword", 1) + "\n"), [])
        self.assertEqual(self.found("a.cpp", "// " + broken.replace("\n", "\n// ") + "\n"), [])  # not public
        self.assertEqual(self.found("a.md", "```sh\n" + broken + "\n```\n"), [])
        self.assertEqual(self.found("a.md", "- " + WORDS[:90] + "\n- " + WORDS[:90] + "\n"), [])  # two items

    def test_bare_ids(self):
        self.expect_one("a.md", "It is like CS-P.\n", "[ids] CS-P")
        self.expect_one("a.glsl", "// As TSSAO-12 says.\n", "[ids] TSSAO-12")
        self.assertEqual(self.found("a.glsl", "// crease shading (TSSAO-12): `C of TSSAO-1` [TSSAO-2].\n"), [])
        self.assertEqual(self.found("a.md", "Two half balls (CS-P) and the validity test (TSSAO-9, ISSAO-2).\n"), [])
        self.assertEqual(self.found("a.md", "| CS-P | half balls |\n"), [])


class Format(unittest.TestCase):
    """The check by clang-format passes what clang-format wrote and fails anything else."""

    def status(self, name, text):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(HERE.parents[1] / ".clang-format", folder)
            Path(folder, name).write_text(text, encoding="utf-8")
            return subprocess.run([HERE / "format", folder], capture_output=True, check=False).returncode

    def test_formatted(self):
        self.assertEqual(self.status("a.cpp", "int main() {\n    return 0;\n}\n"), 0)

    def test_not_formatted(self):
        self.assertNotEqual(self.status("a.cpp", "int main() {\n  return 0;\n}\n"), 0)
        self.assertNotEqual(self.status("a.hpp", "int  f();\n"), 0)


if __name__ == "__main__":
    unittest.main()
