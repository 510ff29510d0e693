#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""snippets.py PAGE FOLDER: the fenced blocks of a guide for its tests: each GLSL file as FOLDER/NAME, and those in C++
as FOLDER/snippets.inc. A block that is no test of its own becomes the body of one, with what earlier blocks defined."""
import re
import sys
from pathlib import Path

DEFINED_BEFORE = {
    "tone": 'const Function<float(float)> tone(lab, "tone.glsl", "tone_reinhard");',
    "reinhard": "const auto reinhard = [](double x) { return x / (1.0 + x); };"}


def test_of(number, block):
    """A block as a test."""
    if "TEST" in block:
        return block
    before = [line for name, line in DEFINED_BEFORE.items()
              if re.search(rf"\b{name}\b", block) and not re.search(rf"> {name}\(lab|auto {name} =", block)]
    return "\n".join([f"TEST(Guide, Snippet{number}) {{", "const Lab lab = guide_lab();", *before, block + "}\n"])


def main():
    page, folder = Path(sys.argv[1]), Path(sys.argv[2])
    blocks = re.findall(r"^```(cpp|glsl \S+)\n(.*?)^```$", page.read_text(encoding="utf-8"), re.S | re.M)
    folder.mkdir(parents=True, exist_ok=True)
    for kind, block in blocks:
        if kind != "cpp":
            (folder / kind.split()[1]).write_text(block, encoding="utf-8")
    tests = [test_of(number, block) for number, (kind, block) in enumerate(blocks) if kind == "cpp"]
    (folder / "snippets.inc").write_text("\n".join(tests), encoding="utf-8")


if __name__ == "__main__":
    main()
