#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""budgets.py ROOT: no folder of the house has more lines than budgets.txt allows it.

A row of the table is FOLDER LINES. A folder counts with its subfolders, but for those with a row of their own. The row
`all` limits the sum of the column LINES: a folder's number rises only by what another's falls.
Prints one line per violation and exits 1 when there is one.
"""
import re
import sys
from pathlib import Path

from borders import files_of

TABLE = Path(__file__).with_name("budgets.txt")


def rows_of(text):
    """(folder, lines) of each row; a row of another form ends the run."""
    for number, line in enumerate(text.splitlines(), 1):
        row = line.split("#")[0].strip()
        match = re.fullmatch(r"(\S+) +(\d+)", row)
        if match:
            yield match[1], int(match[2])
        elif row:
            sys.exit(f"{TABLE.name}:{number}: expected FOLDER LINES")


def violations(root):
    """The messages about the table, and about the folders that are above it."""
    allowed = dict(rows_of(TABLE.read_text(encoding="utf-8")))
    total = allowed.pop("all")
    counts = dict.fromkeys(allowed, 0)
    for path in files_of(root):
        content = (root / path).read_bytes()
        if b"\0" not in content:  # a text; `.` holds what no other folder with a row does
            innermost = (folder.as_posix() for folder in Path(path).parents if folder.as_posix() in counts)
            counts[next(innermost, ".")] += len(content.splitlines())
    if sum(allowed.values()) > total:
        yield (f"{TABLE.name}: the folders have {sum(allowed.values())} lines, `all` allows {total}: another folder must "
               "give them")
    for folder, lines in allowed.items():
        if counts[folder] > lines:
            yield f"{folder}: {counts[folder]} lines, its budget is {lines}"


if __name__ == "__main__":
    FOUND = list(violations(Path(sys.argv[1])))
    print("".join(message + "\n" for message in FOUND), end="")
    sys.exit(1 if FOUND else 0)
