#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""guides.py ROOT GLOAM: runs the guides.

Reads the fenced blocks of docs/testing.md and the other guides, in their order. Fails when
one of them does not do what the page says. A block's first line says what it is:

    ```sh           commands, run one after the other in a scratch folder; each must exit with 0
    ```sh WHY       commands that another test runs, or that would take too long here; WHY is one of WHY_NOT_RUN
    ```text         what the commands above printed: every line, in its order; "..." stands for any lines
    ```python       statements, run with the module of the build folder, if it has one
    ```glsl NAME    a file that tests/judge/snippets.py makes of the block; engine.glsl: lines of a fixture beside it
    ```cpp          a test, in docs/testing.md, by tests/judge/snippets.py
    ```cpp consumer    lines of the test in examples/own_function
    ```cmake consumer  lines of its CMakeLists.txt; others may stand between them

Also: every source that an equation cites by author and year is in docs/glossary.md.
"""
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

GUIDES = ("testing.md", "judge-a-driver.md", "copy-a-shader.md")
WHY_NOT_RUN = {
    "package": "tests/house/package does the same",
    "long": "takes minutes",
    "engine": "needs a cluster or a build: tests/laboratory, tests/tools/stories/steps.txt",
}
BLOCK = re.compile(r"^```(\S*) ?(\S*)\n(.*?)^```$", re.S | re.M)
CITED = re.compile(r"([A-Z][\w-]+(?:, [A-Z][\w-]+)*(?: and [A-Z][\w-]+)?(?: et al\.)? \d{4})")
SECONDS = 300  # for the commands of a block


def squeezed(text):
    """The lines of a text without their indentation and without empty ones."""
    return "\n".join(line.strip() for line in text.splitlines() if line.strip())


def holds(file, block):
    return squeezed(block) in squeezed(file.read_text(encoding="utf-8"))


class Guide:
    """One page, run in a folder of its own."""

    def __init__(self, root, name, gloam, folder):
        self.root = root
        self.name = name
        self.folder = folder
        self.module = gloam.parent.parent / "python"
        self.environment = dict(os.environ, PATH=f"{gloam.parent}:{os.environ['PATH']}", PYTHONPATH=str(self.module))
        self.printed = ""
        self.failures = []

    def fail(self, what):
        self.failures.append(f"docs/{self.name}: {what}")

    def run(self, commands, program=("bash", "-e")):
        done = subprocess.run([*program, "-c", commands], cwd=self.folder, env=self.environment, text=True,
                              capture_output=True, timeout=SECONDS, check=False)
        self.printed = done.stdout
        if done.returncode != 0:
            self.fail(f"exit status {done.returncode}:\n{commands}{done.stdout[-2000:]}{done.stderr[-2000:]}")

    def expect_printed(self, block):
        lines = iter(self.printed.splitlines())
        for expected in block.splitlines():
            if expected != "..." and not any(line.rstrip() == expected for line in lines):
                self.fail(f"the commands did not print, in this order: {expected}\nbut:\n{self.printed[:3000]}")
                return

    def expect_in(self, file, block):
        if not holds(self.root / file, block):
            self.fail(f"{file} does not hold this block:\n{block}")

    def block(self, kind, argument, text):
        if kind == "sh":
            if not argument:
                self.run(text)
            elif argument not in WHY_NOT_RUN:
                self.fail(f"a block is not run because of \"{argument}\", which is no reason")
        elif kind == "text":
            self.expect_printed(text)
        elif kind == "python":
            if any((self.module / "gloam").glob("_gloam*")):
                self.run(text, ("/usr/bin/python3",))
        elif kind == "glsl":
            if argument == "engine.glsl":
                self.expect_in(f"tests/subject/fixtures/guide/{argument}", text)
            else:
                (self.folder / argument).write_text(text, encoding="utf-8")
        elif kind == "cpp" and argument:
            self.expect_in("examples/own_function/shader_test.cpp", text)
        elif kind == "cpp":
            if self.name != "testing.md":
                self.fail("a block in C++ that no test has")
        elif kind == "cmake":
            file = self.root / "examples/own_function/CMakeLists.txt"
            lines = iter(squeezed(file.read_text(encoding="utf-8")).splitlines())
            if not all(line in lines for line in squeezed(text).splitlines()):
                self.fail(f"the project's CMakeLists.txt does not hold these lines in this order:\n{text}")
        else:
            self.fail(f"a block of an unknown kind: \"{kind}\"")


def run_guide(root, name, gloam):
    text = (root / "docs" / name).read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        guide = Guide(root, name, gloam, Path(folder))
        for kind, argument, block in BLOCK.findall(text):
            guide.block(kind, argument, block)
        if len(BLOCK.findall(text)) * 2 != len(re.findall(r"^```", text, re.M)):
            guide.fail("fences that do not pair up")
        if re.search(r"^    (gloam|tools/run|cmake) ", text, re.M):
            guide.fail("a command outside a fenced block: nothing would run it")
    return guide.failures


def uncited(root, gloam):
    known = (root / "docs" / "glossary.md").read_text(encoding="utf-8")
    listed = subprocess.run([gloam, "list", "equations", "--json"], check=True, capture_output=True)
    cited = set()
    for equation in json.loads(listed.stdout)["equations"]:
        names = CITED.findall(equation["source"])
        cited.update(re.sub(r"^(?:AO|GTAO|SSDO), ", "", name) for name in names)
    return [f"docs/glossary.md does not have {name}" for name in sorted(cited) if name not in known]


def main():
    root, gloam = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    failures = [failure for name in GUIDES for failure in run_guide(root, name, gloam)] + uncited(root, gloam)
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
