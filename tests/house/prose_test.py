#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""prose_test.py: prose.py finds what it looks for, and nothing else."""
import tempfile
import unittest
from pathlib import Path

import prose

WORDS = " ".join(["word"] * 36)


class ProseTest(unittest.TestCase):
    def found(self, name, text, exempt=frozenset()):
        """The messages about a folder with one file."""
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            return prose.check(Path(folder), set(exempt))[0]

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
        self.assertEqual(self.found("docs/data/a.md", "x" * 200 + "\n"), [])

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

    def test_the_list_shrinks(self):
        line = "x" * 121 + "\n"
        self.assertEqual(self.found("a.cpp", line, {("columns", "a.cpp")}), [])
        messages = self.found("a.cpp", "x\n", {("columns", "a.cpp")})
        self.assertEqual(len(messages), 1)
        self.assertIn("not needed any more", messages[0])


if __name__ == "__main__":
    unittest.main()
