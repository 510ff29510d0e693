# SPDX-License-Identifier: MIT
"""Rules of borders.py for the documentation: the files that it names exist, and the code that it shows is tested."""
import re

SHOWN_FROM = ("examples", "glsl", "harness", "tests")
NAMED_PATH = re.compile(r"(?<![\w/.-])((?:cmake|docs|examples|glsl|gloam|harness|tests|tools)/[\w./-]*\w)")
BLOCK = re.compile(r"^```(?:cpp|glsl|cmake)\n(.*?)^```", re.M | re.S)


def is_placeholder(path):
    """harness/ROOM/CMakeLists.txt stands for many files."""
    return any(re.fullmatch(r"[A-Z_]+(\.\w+)?", part) and part != "README.md" for part in path.split("/"))


def paper_path(source):
    """A path that a page names is there; gloam/... is meant as in #include."""
    if source.path.suffix != ".md":
        return
    for number, line in enumerate(source.lines, 1):
        for path in NAMED_PATH.findall(line):
            roots = ("", "glsl", "harness") if path.startswith("gloam/") else ("", source.path.parent.as_posix())
            known = any((source.root / root / path).exists() for root in roots)
            if not known and not is_placeholder(path) and path != "gloam/shader_test.hpp":
                yield number, f"there is no {path}"


def stripped(lines):
    return "\n".join(line.strip() for line in lines if line.strip())


def paper_code(source):
    """A block of C++, GLSL or CMake in a page stands, line by line, in a file of ours; so it compiles and is tested."""
    if source.path.suffix != ".md":
        return
    for block in BLOCK.finditer(source.text):
        wanted = stripped(block.group(1).splitlines())
        files = (path for area in SHOWN_FROM for path in sorted((source.root / area).rglob("*"))
                 if path.suffix in (".cpp", ".hpp", ".glsl", ".comp") or path.name == "CMakeLists.txt")
        if not any(wanted in stripped(path.read_text(encoding="utf-8").splitlines()) for path in files):
            yield source.text.count("\n", 0, block.start()) + 1, "this code stands in no file of the house"
