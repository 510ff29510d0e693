#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""guides.py ROOT GLOAM: runs the guides.

Reads the fenced blocks of docs/testing.md and the other guides, in their order. Fails when
one of them does not do what the page says. A block's first line says what it is:

    ```sh           commands, run one after the other in a scratch folder; each must exit with 0
    ```sh WHY       commands that another test runs, or that would take too long here; WHY is one of WHY_NOT_RUN
    ```text         what the commands above printed: every line, in its order; "..." stands for any lines
    ```python       statements, run with the module of the build folder, if it has one
    ```glsl NAME    a file that tests/judge/snippets.py makes of the block
    ```cmake consumer  lines of the CMakeLists.txt in examples/own_function; others may stand between them

Blocks of C++, and of engine.glsl, are those of borders.py, and of tests/judge/snippets.py; those of JavaScript and C
are shown alone: tests/site and tests/examples run such programs.
Also: every source that an equation cites by author and year is in docs/glossary.md.
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT, GLOAM = (Path(argument).resolve() for argument in sys.argv[1:3])
GUIDES = ("testing.md", "judge-a-driver.md", "copy-a-shader.md", "integration.md", "one-pass.md")
WHY_NOT_RUN = ("package",  # tests/house/package does the same
               "long",     # takes minutes
               "engine")   # needs a cluster, a build or an engine: tests/laboratory, tests/site, tests/tools/stories
BLOCK = re.compile(r"^```(\S*) ?(\S*)\n(.*?)^```$", re.S | re.M)
CITED = re.compile(r"([A-Z][\w-]+(?:, [A-Z][\w-]+)*(?: and [A-Z][\w-]+)?(?: et al\.)? \d{4})")
SECONDS = 300  # for the commands of a block
MODULE = GLOAM.parent.parent / "python"
ENVIRONMENT = {**os.environ, "PATH": f"{GLOAM.parent}:{os.environ['PATH']}", "PYTHONPATH": str(MODULE)}


class Guides(unittest.TestCase):
    def run_block(self, commands, folder, *program):
        """What the commands print."""
        done = subprocess.run([*program, "-c", commands], cwd=folder, env=ENVIRONMENT, text=True, capture_output=True,
                              timeout=SECONDS, check=False)
        self.assertEqual(0, done.returncode, commands + done.stdout[-2000:] + done.stderr[-2000:])
        return done.stdout

    def assert_lines(self, expected, text):
        """The lines stand in the text, in this order."""
        lines = iter(text.splitlines())
        for one in expected.splitlines():
            self.assertTrue(one == "..." or any(line.rstrip() == one for line in lines),
                            f"expected, in this order: {one}\nbut:\n{text[:3000]}")

    def run_guide(self, blocks, folder):
        printed = ""
        for kind, argument, text in blocks:
            if kind == "sh" and not argument:
                printed = self.run_block(text, folder, "bash", "-e")
            elif kind == "sh":
                self.assertIn(argument, WHY_NOT_RUN)
            elif kind == "text":
                self.assert_lines(text, printed)
            elif kind == "python":
                if any((MODULE / "gloam").glob("_gloam*")):
                    self.run_block(text, folder, "/usr/bin/python3")
            elif kind == "cmake":
                file = (ROOT / "examples/own_function/CMakeLists.txt").read_text(encoding="utf-8")
                self.assert_lines(text, re.sub(r"(?m)^ +", "", file))
            elif kind == "glsl" and argument != "engine.glsl":
                Path(folder, argument).write_text(text, encoding="utf-8")
            else:
                self.assertIn(kind, ("glsl", "cpp", "js", "c"), "a block of an unknown kind")

    def test_each_does_what_it_says(self):
        for name in GUIDES:
            text = (ROOT / "docs" / name).read_text(encoding="utf-8")
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                blocks = BLOCK.findall(text)
                self.assertEqual(2 * len(blocks), len(re.findall(r"^```", text, re.M)), "fences that do not pair up")
                self.assertNotRegex(text, r"(?m)^    (gloam|tools/run|cmake) ", "nothing would run it")
                self.run_guide(blocks, folder)

    def test_the_glossary_has_every_source(self):
        known = (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8")
        listed = subprocess.run([GLOAM, "list", "equations", "--json"], check=True, capture_output=True)
        for equation in json.loads(listed.stdout)["equations"]:
            for cited in CITED.findall(equation["source"]):
                self.assertIn(re.sub(r"^(?:AO|GTAO|SSDO), ", "", cited), known)


if __name__ == "__main__":
    unittest.main(argv=["guides.py"])
