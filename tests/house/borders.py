#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""borders.py ROOT: the borders of the house, as rules over its sources.

Prints one line per violation, "file:line: [rule] what is wrong", and exits 1 when there is one.
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

# The wings of harness/, their rooms, and whom each of these may include besides itself, as the architecture has them.
ROOM = re.compile(r"^\| `harness/(\w+)/(\w+)` \|.*\| ([\w, ]+) \|$", re.M)
WINGS = {}
ARCHITECTURE = Path(__file__).parents[2] / "docs" / "architecture.md"
for its_wing, its_room, its_uses in ROOM.findall(ARCHITECTURE.read_text(encoding="utf-8")):
    WINGS.setdefault(its_wing, {})[its_room] = set(its_uses.split(", ")) - {"no other"}
ANYONE = {"base", "numeric"}  # may be used by every room
ROOMS = {room: uses | ANYONE for wing in WINGS.values() for room, uses in wing.items()}
MAY_INCLUDE = {**ROOMS, "tools": set(ROOMS)}

# Libraries that belong to one room, or one folder of it, by what their headers are called.
LIBRARY_HOME = {
    "vulkan": (re.compile(r"(vulkan|vk_\w+\.h)"), "backend/vulkan"),
    "opengl": (re.compile(r"(EGL|GLES\d?|GL|KHR|epoxy)/"), "backend/gl"),
    "glslang": (re.compile(r"(glslang|SPIRV|spirv[-/_]|StandAlone)"), "module"),
    "assimp": (re.compile(r"assimp/"), "scene"),
    "embree": (re.compile(r"embree"), "scene"),
    "sqlite": (re.compile(r"sqlite3"), "experiment"),
    "stb_image": (re.compile(r"(stb/)?stb_image"), "base"),
    "stb_truetype": (re.compile(r"(stb/)?stb_truetype"), "pictures"),
}

OPENED = re.compile(r"^namespace gloam::(\w+)[\w:]* \{\n(.*?)^\}", re.M | re.S)
ANNOUNCED = re.compile(r"(GLOAM_MEMBERS|template <>\nconstexpr Form form_of)\b[^;)]*[;)]|(struct|class) \w+;")
MAX_LINES = 400
CODE = {".cpp", ".hpp", ".glsl", ".comp", ".vert", ".frag", ".py", ".cmake", ".in"}
TEXT = CODE | {".txt", ".md", ".json", ".supp", ""}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
PRINTED = re.compile(r"// No method or pass here calls it: it is "
                     r"(TSSAO|ISSAO|the \w+ of the comparative study|OpenGL's)\b.+\.")
CALL = re.compile(r"\b(gloam_\w+)\s*\(")
NAMED_PATH = re.compile(r"(?<![\w/.-])((?:cmake|docs|examples|glsl|gloam|harness|tests|tools)/[\w./-]*\w)")
SHOWN_FROM = ("examples", "glsl", "harness", "tests")  # what pages may show pieces of
SHOWN = re.compile(r"^```(?:cpp|glsl|cmake|cpp consumer|glsl engine.glsl)\n(.*?)^```", re.M | re.S)
MACHINE_PATH = re.compile(r"(?<![\w./}-])/(home|root|work|tmp|Users|mnt|media)/\w")


class Source:
    """A text file of the house: its path from the root, its lines, and the room it stands in."""

    def __init__(self, root, path):
        self.root = root
        self.path = path.relative_to(root)
        self.text = path.read_text(encoding="utf-8", errors="replace")
        self.lines = self.text.splitlines()
        parts = self.path.parts
        self.area = parts[0] if len(parts) > 1 else ""
        depth = {"harness": 2, "tests": 1}.get(self.area, 0)
        self.wing = parts[1] if self.area == "harness" and len(parts) > 2 else ""
        self.room = parts[depth] if len(parts) > depth + 1 else self.area
        self.is_shader_library = parts[:2] == ("glsl", "gloam")

    def includes(self):
        """(line number, opening delimiter, name) of each #include directive."""
        for number, line in enumerate(self.lines if self.path.suffix in CODE else [], 1):
            match = INCLUDE.match(line)
            if match:
                yield number, match.group(1), match.group(2)


def blank_comments(text):
    """The text with every comment replaced by spaces: lines and columns stay where they are."""
    return re.sub(r"//[^\n]*|/\*.*?\*/", lambda m: re.sub(r"[^\n]", " ", m.group()), text, flags=re.S)


def blank_code(text):
    """blank_comments(), with preprocessor lines blanked too."""
    return re.sub(r"^[ \t]*#[^\n]*", lambda m: " " * len(m.group()), blank_comments(text), flags=re.M)


def file_scope_statements(code):
    """(position, head, has a body) of each statement at file scope; the head ends before ';' or '{'."""
    start, depth, body = 0, 0, False
    for position, char in enumerate(code):
        if char == "{":
            if depth == 0:
                head, body = code[start:position], True
            depth += 1
        elif char == "}":
            depth -= 1
        ends = char == ";" or (char == "}" and body and head.rstrip().endswith(")"))  # a function body takes no ';'
        if depth == 0 and ends:
            text = head if body else code[start:position]
            if text.strip():
                yield start + len(text) - len(text.lstrip()), text.strip(), body
            start, body = position + 1, False


FUNCTION_HEAD = re.compile(r"^[\w\s\[\]]*?\b(\w+)\s*\([^()]*\)$", re.S)


def line_of(text, position):
    return text.count("\n", 0, position) + 1


# Each rule: (source) -> (line, message) pairs. Its name is the function's name.


def include(source):
    """A room of harness/ stands in its wing. It includes only the rooms that it may use, and of these the public headers,
    named from the root, "room/file.hpp"; what lies in ROOM/internal is for that room, its tests and the fuzz targets. The
    commands of the framework include nothing that knows of occlusion: main hands that in."""
    if source.area == "harness" and source.room not in WINGS.get(source.wing, ()):
        yield 1, f"harness/{source.wing}/{source.room}: expected harness/WING/ROOM of docs/architecture.md"
    allowed = MAY_INCLUDE.get(source.room, set()) | {source.room}
    if source.area not in ("harness", "tools"):
        allowed = set(MAY_INCLUDE)
    is_command = source.path.parts[:3] == ("tools", "cli", "framework")
    for number, delimiter, name in source.includes():
        room, *rest = name.split("/")
        ours = room in MAY_INCLUDE
        if ours and room not in allowed:
            yield number, f"{source.room} may not include {name}"
        if is_command and (room in WINGS["occlusion"] or name.startswith("cli/occlusion/")):
            yield number, f"a command of the framework may not include {name}"
        if ours and "internal" in rest[:-1] and source.room not in (room, "fuzz"):
            yield number, f"{name} is internal to {room}"
        if source.area not in ("harness", "tools", "tests") or source.path.suffix not in (".cpp", ".hpp"):
            continue
        if ".." in (room, *rest):
            yield number, f"{name}: name the header from the root"
        elif delimiter == "<" and ours and rest:
            yield number, f'{name}: ours are included as "{name}"'
        elif delimiter == '"' and source.area == "harness" and not (ours and rest):
            yield number, f'{name}: include it as "room/file.hpp", or as <{name}> when it is not ours'


def namespace(source):
    """A room declares in the namespace of its name. In that of another it only announces types, or says how its own
    values are written (GLOAM_MEMBERS, form_of)."""
    for block in OPENED.finditer(source.text) if source.area == "harness" else ():
        if block.group(1) != source.room and ANNOUNCED.sub("", block.group(2)).strip():
            yield line_of(source.text, block.start()), f"expected namespace gloam::{source.room}"


def join_header(source):
    """fmt 11 has fmt::join in a header of its own."""
    if source.path.suffix in (".cpp", ".hpp") and "fmt::join(" in source.text and "<fmt/ranges.h>" not in source.text:
        yield 1, "fmt::join needs <fmt/ranges.h>"


def library_home(source):
    """A library's headers are included in its own room only, and there not in a public header."""
    if source.area == "examples":  # programs of their own
        return
    for number, _, name in source.includes():
        for library, (pattern, home) in LIBRARY_HOME.items():
            if not pattern.match(name):
                continue
            # A home is a room, or a folder of it as "room/folder"; its tests stand there, too.
            in_rooms = source.area in ("harness", "tests")
            if not (f"/{home}/" in source.path.as_posix() if in_rooms else source.room == home):
                yield number, f"{name}: {library} headers belong in {home}"
            elif source.area == "harness" and source.path.suffix == ".hpp" and "internal" not in source.path.parts:
                yield number, f"{name}: {library} shows in a public header of {home}"


def statements(source):
    """(line, head, its first line, name of the function or None, body or None) of each statement at file scope."""
    code = blank_code(source.text)
    found = list(file_scope_statements(code))
    ends = [position for position, _, _ in found[1:]] + [len(code)]
    for (position, head, has_body), end in zip(found, ends):
        function = FUNCTION_HEAD.match(head)
        body = code[position + len(head):end] if has_body else None
        yield line_of(code, position), head, head.splitlines()[0], function and function.group(1), body


def shader_statement(source):
    """glsl/gloam holds no bindings, no main and no globals: those belong to passes and engines. Its functions are called
    gloam_snake_case, and each has a comment directly above it."""
    for line, head, first, name, _ in statements(source) if source.is_shader_library else ():
        if name == "main":
            yield line, "main() belongs in glsl/passes"
        elif re.search(r"\b(layout|uniform|buffer|shared)\b", head.split("(")[0] if name else head):
            yield line, f"a binding belongs in glsl/passes: {first}"
        elif not name and not re.match(r"(struct\b|const\s+\w+\s+GLOAM_\w+)", head):
            yield line, f"file scope holds functions, structs and GLOAM_ constants only: {first}"
        elif name and not re.fullmatch(r"gloam_[a-z0-9_]+", name):
            yield line, f"{name}: functions are called gloam_snake_case"
        elif name and not source.lines[line - 2].startswith("//"):
            yield line, f"{name} has no comment directly above it"


def shader_include(source):
    """glsl/gloam includes only itself, named from the root."""
    for number, _, name in source.includes() if source.is_shader_library else ():
        if not re.fullmatch(r"gloam/\w+/\w+\.glsl", name):
            yield number, f'{name}: include "gloam/room/file.glsl"'


def shader_reference(source):
    """Every function of glsl/gloam has its reference in C++, in a header of its room in harness/occlusion/reference.
    Methods, and what their loops share, are judged whole: each method has a descriptor, by which the tests try it."""
    if not source.is_shader_library or source.path.parts[2] in ("methods", "gather"):
        return
    room = source.path.parts[2]
    headers = sorted((source.root / "harness/occlusion/reference").glob(f"{room}*.hpp"))
    references = "".join(header.read_text(encoding="utf-8") for header in headers)
    for line, _, _, name, body in statements(source):
        if body and name and name.startswith("gloam_") and f" {name}(" not in references:
            yield line, f"no harness/occlusion/reference/{room}*.hpp has {name}()"


def guard(source):
    """A header is read once: #pragma once in C++, GLOAM_ROOM_FILE_GLSL in the shader library."""
    lines = [line for line in blank_comments(source.text).splitlines() if line.strip()]
    if source.path.suffix == ".hpp" and lines[:1] != ["#pragma once"]:
        yield 1, "#pragma once must come before everything but comments"
    if source.is_shader_library:
        name = re.sub(r"\W", "_", "/".join(source.path.parts[1:])).upper()
        if lines[:2] != [f"#ifndef {name}", f"#define {name}"] or lines[-1] != "#endif":
            yield 1, f"the guard {name} must enclose the file"


def spdx(source):
    """Every source says its licence in its first line (the second after #!). A test's fixtures need not."""
    if "fixtures" in source.path.parts:
        return
    is_script = source.text.startswith("#!")
    named = source.path.name in ("CMakeLists.txt", "packages.txt", "packages-tests.txt") or is_script
    if source.path.suffix not in CODE and not named:
        return
    first = source.lines[1:2] if is_script else source.lines[:1]
    if not first or not re.fullmatch(r"(//|#) SPDX-License-Identifier: MIT", first[0]):
        yield 1, "the first line must be SPDX-License-Identifier: MIT in a comment"


def length(source):
    """A file that does one thing is short."""
    if source.path.suffix in CODE and len(source.lines) > MAX_LINES:
        yield len(source.lines), f"{len(source.lines)} lines; at most {MAX_LINES}"


def machine_path(source):
    """Nothing refers to a place on somebody's machine."""
    for number, line in enumerate(source.lines, 1):
        match = MACHINE_PATH.search(line)
        if match:
            yield number, f"a path of one machine: {line[match.start():match.start() + 40]}"


# What users include or import from the installed packages.
PACKAGED = ("gloam/babylon", "gloam/judge/matchers.hpp", "gloam/playcanvas", "gloam/shader_test.hpp", "gloam/three")


def paper_path(source):
    """A path that a page names is there; gloam/... is meant as in #include. ROOM in a path stands for many."""
    for number, line in enumerate(source.lines if source.path.suffix == ".md" else [], 1):
        for path in NAMED_PATH.findall(line):
            roots = ("", "glsl", "harness") if path.startswith("gloam/") else ("", source.path.parent.as_posix())
            known = any((source.root / root / path).exists() for root in roots) or path in PACKAGED
            if not known and not re.search(r"(^|/)(?!README\.md)[A-Z_]+(\.\w+)?(/|$)", path):
                yield number, f"there is no {path}"


def stripped(text):
    return "\n".join(line.strip() for line in text.splitlines() if line.strip())


def paper_code(source):
    """A block of C++, GLSL or CMake in a page stands, line by line, in a file of ours; so it compiles and is tested.
    The C++ of docs/testing.md is compiled from the page itself (tests/judge/snippets.py)."""
    for block in SHOWN.finditer(source.text) if source.path.suffix == ".md" else ():
        if source.path.as_posix() == "docs/testing.md" and block.group(0).startswith("```cpp\n"):
            continue
        files = (path for area in SHOWN_FROM for path in sorted((source.root / area).rglob("*"))
                 if path.suffix in (".cpp", ".hpp", ".glsl", ".comp", ".txt"))
        if not any(stripped(block.group(1)) in stripped(path.read_text(encoding="utf-8")) for path in files):
            yield line_of(source.text, block.start()), "this code stands in no file of the house"


RULES = (include, namespace, join_header, library_home, shader_statement, shader_include, shader_reference, guard, spdx,
         length, machine_path, paper_path, paper_code)


def shader_caller(house):
    """A method or a pass calls each function of glsl/gloam, itself or by others; or the last line of the function's
    comment says which printed equation it is (PRINTED). What such a function calls is called. Of overloads all count as
    called. The rule reads all sources at once: (source, line, message)."""
    functions, called, waiting = {}, set(), set()
    for source in house:
        if source.path.parts[:2] == ("glsl", "passes"):
            waiting.update(CALL.findall(blank_code(source.text)))
        for line, head, _, name, body in statements(source) if source.is_shader_library else ():
            if name and name.startswith("gloam_") and body:
                printed = PRINTED.fullmatch(source.lines[line - 2]) is not None
                functions.setdefault(name, []).append((source, line, printed, set(CALL.findall(body))))
                waiting.update(functions[name][-1][3] - {name} if printed else ())
            if source.path.parts[2] == "methods" and head.startswith("GloamEstimate gloam_"):
                waiting.add(name)  # the effect calls it by its macro
    while waiting:
        called |= waiting
        waiting = {name for caller in waiting for *_, calls in functions.get(caller, ()) for name in calls} - called
    for name, all_of_name in functions.items():
        for source, line, printed, _ in all_of_name:
            if name in called and printed:
                yield source, line, f"{name} is called, and said not to be"
            elif name not in called and not printed:
                yield source, line, (f"nothing calls {name}: expected a method or pass that does, or, at the end of "
                                     'its comment, "// No method or pass here calls it: it is SOURCE, WHAT.", SOURCE: '
                                     "TSSAO, ISSAO, the ... of the comparative study, or OpenGL's")


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


def sources(root):
    """Every text file of the house, in order."""
    for name in files_of(root):
        path = Path(root, name)
        if path.suffix in TEXT and (path.suffix or "/" in name):
            yield Source(root, path)


def violations(root):
    """A line for everything that breaks a rule below `root`."""
    house = list(sources(root))
    found = [(source, line, rule, message) for source in house for rule in RULES for line, message in rule(source)]
    found += [(source, line, shader_caller, message) for source, line, message in shader_caller(house)]
    return [f"{source.path.as_posix()}:{line}: [{rule.__name__}] {message}\n" for source, line, rule, message in found]


if __name__ == "__main__":
    FOUND = violations(Path(sys.argv[1]))
    print("".join(FOUND), end="")
    sys.exit(1 if FOUND else 0)
