#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""prose.py ROOT: how the pages, the comments and the code read.

- No line has more than 120 columns. Tables, links and pictures of a page may, and what a command printed.
- No sentence of a page, or of a comment in a header or in the shader library, has more than 35 words.
- An equation's ID, CS-P say, stands in brackets behind its plain name, or in a table, not alone in a sentence.
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

LONGEST_LINE = 120
MOST_WORDS = 35
CODE = {".cpp", ".hpp", ".glsl", ".comp", ".vert", ".frag", ".py", ".cmake", ".css", ".js", ".in"}
COMMENTED = {".hpp", ".glsl"}  # whose comments people read who use them
THIRD_PARTY = "tools/site/third-party/"  # copies without a change
ID = re.compile(r"\b(?:TSSAO|CS|ISSAO|GTAO)-[A-Z0-9][\w.-]*")
SENTENCE_END = re.compile(r"(?<=[.!?:;])\s+")


def is_free_form(line):
    """A line of a page that may be as long as it likes."""
    return line.lstrip().startswith(("|", "![", "- [")) or "](" in line or "http" in line


def page_paragraphs(text):
    """(line number, text) of the paragraphs of a Markdown page, without code, tables and headings."""
    begin, lines, in_code = 0, [], False
    for number, line in enumerate(text.splitlines() + [""], 1):
        if line.startswith("```"):
            in_code = not in_code
        item = re.match(r"\s*(?:[-*]|\d+\.) ", line)
        ends = in_code or not line.strip() or line.startswith(("|", "#", "    ", "```", "!["))
        if (ends or item) and lines:
            yield begin, " ".join(lines)
            lines = []
        if not ends:
            begin = begin if lines else number
            lines.append(re.sub(r"^\s*(?:[-*]|\d+\.) ", "", line).strip())


def comment_paragraphs(text):
    """The same of the // comments that stand on lines of their own."""
    begin, lines = 0, []
    for number, line in enumerate(text.splitlines() + [""], 1):
        match = re.match(r"\s*// ?(.*)", line)
        content = match[1] if match else ""
        ends = not content.strip() or content.startswith("  ") or content.startswith("SPDX")
        if ends and lines:
            yield begin, " ".join(lines)
            lines = []
        if not ends:
            begin = begin if lines else number
            lines.append(content.strip())


def long_lines(path, text):
    printed = False  # between the fences of a block of text that a command printed
    for number, line in enumerate(text.splitlines(), 1):
        if path.suffix == ".md" and line.startswith("```"):
            printed = line == "```text"
        if not printed and len(line) > LONGEST_LINE and not (path.suffix == ".md" and is_free_form(line)):
            yield number, f"{len(line)} columns, expected at most {LONGEST_LINE}"


def long_sentences(paragraphs):
    for number, paragraph in paragraphs:
        for sentence in SENTENCE_END.split(paragraph):
            words = sentence.split()
            if len(words) > MOST_WORDS:
                yield number, (f"a sentence of {len(words)} words, expected at most {MOST_WORDS}: "
                               f"{' '.join(words[:8])} ...")


def bare_ids(paragraphs):
    for number, paragraph in paragraphs:
        without_brackets = re.sub(r"\([^()]*\)|\[[^][]*\]|`[^`]*`", "", paragraph)
        found = ID.search(without_brackets)
        if found:
            yield number, f"{found[0]} without its plain name: write the name, and the ID in brackets behind it"


def departures(root, name):
    """(rule, line, what is wrong) of a file."""
    path = root / name
    is_third_party = name.startswith(THIRD_PARTY) and path.suffix != ".md"
    if path.suffix not in CODE | {".md"} or is_third_party:
        return
    text = path.read_text(encoding="utf-8", errors="replace")
    yield from (("columns", *found) for found in long_lines(path, text))
    if path.suffix == ".md":
        paragraphs = list(page_paragraphs(text))
    elif path.suffix in COMMENTED and not name.startswith("tests/"):
        paragraphs = list(comment_paragraphs(text))
    else:
        return
    yield from (("sentences", *found) for found in long_sentences(paragraphs))
    yield from (("ids", *found) for found in bare_ids(paragraphs))


def files_of(root):
    """Names of the files of the repository: those of git where there is one, without what it ignores."""
    if shutil.which("git"):
        listed = subprocess.run(["git", "-C", str(root), "ls-files", "-co", "--exclude-standard"], capture_output=True,
                                text=True, check=False)
        if listed.returncode == 0:
            return sorted(name for name in listed.stdout.splitlines() if (root / name).is_file())
    skipped = {"build", ".git"}
    return sorted(str(path.relative_to(root)) for path in root.rglob("*")
                  if path.is_file() and path.relative_to(root).parts[0] not in skipped)


def check(root):
    """Lines that say what is wrong."""
    return [f"{name}:{line}: [{rule}] {what}" for name in files_of(root) for rule, line, what in departures(root, name)]


def main():
    failures = check(Path(sys.argv[1]).resolve())
    print("\n".join(failures))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
