#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""budgets.py ROOT: no folder of the house has more lines than budgets.txt allows it.

A row of the table is FOLDER LINES [OWED PAYER]...: LINES is what the folder may have in the end, and each OWED is what it
may have more until PAYER, a step of the work, has taken them away. A folder counts with its subfolders, but for those
with a row of their own. The row `all` limits the sum of the column LINES: a folder's number rises only by what another's
falls. The rows owe `repairs` at most REPAIRS lines in all.
Prints one line per violation and exits 1 when there is one.
"""
import re
import sys
from pathlib import Path

from borders import files_of

TABLE = Path(__file__).with_name("budgets.txt")
ROW = re.compile(r"(\S+) +(\d+)((?: +\d+ (?:methods|house|build|tests|repairs))*)$")
REPAIRS = 2000


def rows_of(text):
    """(folder, lines, all that it owes, what it owes to repairs) of each row; a row of another form ends the run."""
    for number, line in enumerate(text.splitlines(), 1):
        row = line.split("#")[0].strip()
        match = ROW.match(row)
        if match:
            owed = re.findall(r"(\d+) (\w+)", match[3])
            yield (match[1], int(match[2]), sum(int(lines) for lines, _ in owed),
                   sum(int(lines) for lines, payer in owed if payer == "repairs"))
        elif row:
            sys.exit(f"{TABLE.name}:{number}: expected FOLDER LINES [OWED PAYER]...")


def violations(root):
    """The messages about the table, and about the folders that are above it."""
    rows = list(rows_of(TABLE.read_text(encoding="utf-8")))
    folders = [row for row in rows if row[0] != "all"]
    counts = {folder: 0 for folder, *_ in folders}
    for path in files_of(root):
        content = (root / path).read_bytes()
        if b"\0" not in content:  # a text; `.` holds what no other folder with a row does
            innermost = (folder.as_posix() for folder in Path(path).parents if folder.as_posix() in counts)
            counts[next(innermost, ".")] += len(content.splitlines())
    allowed = sum(lines for _, lines, *_ in folders)
    total = sum(lines for folder, lines, *_ in rows if folder == "all")
    if allowed > total:
        yield f"{TABLE.name}: the folders have {allowed} lines, `all` allows {total}: another folder must give them"
    for folder, lines, owed, _ in folders:
        if counts[folder] > lines + owed:
            yield f"{folder}: {counts[folder]} lines, its budget is {lines + owed}"
    repairs = sum(row[3] for row in folders)
    if repairs > REPAIRS:
        yield f"{TABLE.name}: repairs have {repairs} lines, at most {REPAIRS}"


if __name__ == "__main__":
    FOUND = list(violations(Path(sys.argv[1])))
    print("".join(message + "\n" for message in FOUND), end="")
    sys.exit(1 if FOUND else 0)
