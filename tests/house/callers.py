#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""callers.py ROOT: every function of glsl/gloam is called by a method or a pass, directly or by way of others, or its
comment ends with the line that says that it is there to be copied; and no function that is called has that line.

Prints one line per violation, "file:line: what is wrong", and exits 1 when there is one.
"""
import re
import sys
from pathlib import Path

from borders import FUNCTION_HEAD, blank_code, file_scope_statements, line_of

TO_BE_COPIED = "// No method or pass here calls it: it is there to be copied."
CALL = re.compile(r"\b(gloam_\w+)\s*\(")


class Function:
    """A function with a body: where it stands, and which functions of the library it calls."""

    def __init__(self, path, text, line, body):
        self.path = path
        self.line = line
        self.to_be_copied = text.splitlines()[line - 2] == TO_BE_COPIED
        self.calls = set(CALL.findall(body))


def functions_of(root, path):
    """(name, Function) of each function that a file of the library defines."""
    text = path.read_text(encoding="utf-8")
    code = blank_code(text)
    statements = list(file_scope_statements(code))
    ends = [position for position, _, _ in statements[1:]] + [len(code)]
    for (position, head, has_body), end in zip(statements, ends):
        match = FUNCTION_HEAD.match(head) if has_body else None
        if match:
            body = code[position + len(head):end]
            yield match.group(1), Function(path.relative_to(root), text, line_of(code, position), body)


def roots(root):
    """Names called by passes, and the methods' own functions: what the effect calls by its macro."""
    called = set()
    for path in (root / "glsl/passes").rglob("*"):
        if path.is_file():
            called |= set(CALL.findall(blank_code(path.read_text(encoding="utf-8"))))
    return called | {"gloam_" + path.stem for path in (root / "glsl/gloam/methods").glob("*.glsl")}


def called_functions(functions, start):
    """All names that are reached from the names of `start`. Of overloads all count as called."""
    reached, waiting = set(), set(start)
    while waiting:
        name = waiting.pop()
        if name in reached:
            continue
        reached.add(name)
        for function in functions.get(name, []):
            waiting |= function.calls - reached
    return reached


def violations(root):
    """(path, line, message) of every function that is neither called nor to be copied, or both."""
    root = Path(root)
    functions = {}
    for path in sorted((root / "glsl/gloam").rglob("*.glsl")):
        for name, function in functions_of(root, path):
            functions.setdefault(name, []).append(function)
    called = called_functions(functions, roots(root))
    found = []
    for name, all_of_name in functions.items():
        for function in all_of_name:
            if name in called and function.to_be_copied:
                found.append((function.path, function.line, f"{name} is called, and said to be there to be copied"))
            elif name not in called and not function.to_be_copied:
                message = f'nothing calls {name}: expected the line "{TO_BE_COPIED}"'
                found.append((function.path, function.line, message))
    return sorted(found)


def main(arguments):
    if len(arguments) != 2 or not (Path(arguments[1]) / "glsl").is_dir():
        print("callers.py ROOT: the folder that holds glsl/", file=sys.stderr)
        return 2
    found = violations(arguments[1])
    for path, line, message in found:
        print(f"{path.as_posix()}:{line}: {message}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
