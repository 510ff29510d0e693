#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""budgets.py ROOT: no folder of the house has more lines than budgets.txt allows it.

A row of the table is FOLDER LINES, or FOLDER LINES OWED PAYER: the folder may have OWED lines more until PAYER, another
folder of the table, has as many fewer. A folder counts with its subfolders, but for those with a row of their own. The
row `all` limits the sum of the column LINES: a folder's number rises only by what another's falls. PAYER `repairs` needs
no folder; the rows of a table owe it at most REPAIRS lines.
Prints one line per violation and exits 1 when there is one. With --print: each folder's lines beside its budget.
"""
import subprocess
import sys
from pathlib import Path

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


def lines_of(root):
    """The lines of every text file that git knows or would take, by path."""
    found = subprocess.run(["git", "-C", root, "grep", "-I", "-c", "--untracked", "", "--", "."],
                           capture_output=True, text=True, check=True).stdout
    return {path: int(lines) for path, lines in (row.rsplit(":", 1) for row in found.splitlines())}


def folder_of(path, table):
    """The innermost folder with a row that holds a file; `.` holds what no other does."""
    folder = Path(path).parent
    while folder.as_posix() != "." and folder.as_posix() not in table:
        folder = folder.parent
    return folder.as_posix()


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
    rows = list(rows_of(TABLE.read_text()))
    table = {folder: (lines, owed, payer) for folder, lines, owed, payer in rows if folder != "all"}
    counts = dict.fromkeys(table, 0)
    for path, lines in lines_of(root).items():
        folder = folder_of(path, table)
        counts[folder] = counts.get(folder, 0) + lines
    found = list(violations(counts, table, next((lines for folder, lines, _, _ in rows if folder == "all"), 0)))
    if "--print" in options:
        for folder, lines in counts.items():
            print(f"{folder:32} {lines:7} of {sum(table.get(folder, (0, 0))[:2]):7}")
        print(f"{'all':32} {sum(counts.values()):7}")
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
