#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""budgets.py ROOT: no folder of the house has more lines than budgets.txt allows it.

A row of the table is FOLDER LINES, or FOLDER LINES OWED PAYER: the folder may have OWED lines more until PAYER, another
folder of the table, has as many fewer. A folder counts with its subfolders, but for those with a row of their own. The
row `all` limits the sum of the column LINES: a folder's number rises only by what another's falls. PAYER `repairs` needs
no folder; the rows owe it at most REPAIRS lines in all.
Prints one line per violation and exits 1 when there is one. With --print: each folder's lines beside its budget.
"""
import sys
from pathlib import Path

from borders import files_of

TABLE = Path(__file__).with_name("budgets.txt")
REPAIRS = 2500


def rows_of(text):
    """(folder, lines, owed, payer) of each row; a row of another form ends the run."""
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split("#")[0].split()
        if not words:
            continue
        if len(words) not in (2, 4) or not all(word.isdecimal() for word in words[1:3]):
            sys.exit(f"{TABLE.name}:{number}: expected FOLDER LINES, or FOLDER LINES OWED PAYER")
        yield words[0], int(words[1]), int((words + ["0"])[2]), (words + ["0", ""])[3]


def lines_of(file):
    """Lines of a text file; 0 of one that holds a zero byte, which is none."""
    content = file.read_bytes()
    if b"\0" in content:
        return 0
    return content.count(b"\n") + (not content.endswith(b"\n") and bool(content))


def folder_of(path, table):
    """The innermost folder with a row that holds a file; `.` holds what no other does."""
    return next((folder.as_posix() for folder in Path(path).parents if folder.as_posix() in table), ".")


def violations(counts, table, total):
    """The messages about a table, and about the folders that are above it."""
    allowed = sum(lines for lines, _, _ in table.values())
    if allowed > total:
        yield f"{TABLE.name}: the folders have {allowed} lines, `all` allows {total}: another folder must give them"
    for folder, (lines, owed, payer) in table.items():
        if payer and payer != "repairs" and (payer == folder or payer not in table):
            yield f"{TABLE.name}: {folder} owes {owed} lines to {payer}, expected another folder of the table"
        if counts.get(folder, 0) > lines + owed:
            yield f"{folder}: {counts[folder]} lines, its budget is {lines + owed}"
    repairs = sum(owed for _, owed, payer in table.values() if payer == "repairs")
    if repairs > REPAIRS:
        yield f"{TABLE.name}: repairs have {repairs} lines, at most {REPAIRS}"


def main(root, *options):
    rows = list(rows_of(TABLE.read_text(encoding="utf-8")))
    table = {folder: (lines, owed, payer) for folder, lines, owed, payer in rows if folder != "all"}
    counts = dict.fromkeys(table, 0)
    for path in files_of(Path(root)):
        counts[folder_of(path, table)] += lines_of(Path(root, path))
    if "--print" in options:
        for folder, lines in counts.items():
            print(f"{folder:32} {lines:7} of {sum(table[folder][:2]):7}")
        print(f"{'all':32} {sum(counts.values()):7}")
    found = list(violations(counts, table, next((lines for folder, lines, _, _ in rows if folder == "all"), 0)))
    for message in found:
        print(message)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
