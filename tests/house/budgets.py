#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""budgets.py ROOT: no folder of the house has more lines than budgets.txt allows it.

A row of the table is FOLDER LINES [OWED PAYER]...: LINES is what the folder may have in the end, and each OWED is what it
may have more until PAYER, a step of the work, has taken them away. A folder counts with its subfolders, but for those
with a row of their own. The row `all` limits the sum of the column LINES: a folder's number rises only by what another's
falls. The rows owe `repairs` at most REPAIRS lines in all.
Prints one line per violation and exits 1 when there is one. With --print: each folder's lines beside its budget, and what
is owed to each payer.
"""
import sys
from pathlib import Path

from borders import files_of

TABLE = Path(__file__).with_name("budgets.txt")
PAYERS = ("methods", "house", "build", "tests", "repairs")
REPAIRS = 2000


def rows_of(text):
    """(folder, lines, lines owed by payer) of each row; a row of another form ends the run."""
    for number, line in enumerate(text.splitlines(), 1):
        folder, *words = line.split("#")[0].split() or [""]
        if not folder:
            continue
        amounts, payers = words[:1] + words[1::2], words[2::2]
        if len(amounts) != len(payers) + 1 or not all(word.isdecimal() for word in amounts):
            sys.exit(f"{TABLE.name}:{number}: expected FOLDER LINES [OWED PAYER]...")
        if len(set(payers)) < len(payers) or not set(payers) <= set(PAYERS):
            sys.exit(f"{TABLE.name}:{number}: expected each payer once, of: {', '.join(PAYERS)}")
        yield folder, int(amounts[0]), dict(zip(payers, map(int, amounts[1:])))


def lines_of(file):
    """Lines of a text file; 0 of one that holds a zero byte, which is none."""
    content = file.read_bytes()
    if b"\0" in content:
        return 0
    return content.count(b"\n") + (not content.endswith(b"\n") and bool(content))


def folder_of(path, table):
    """The innermost folder with a row that holds a file; `.` holds what no other does."""
    return next((folder.as_posix() for folder in Path(path).parents if folder.as_posix() in table), ".")


def owed_to(payer, table):
    """The lines that all folders owe a payer."""
    return sum(owed.get(payer, 0) for _, owed in table.values())


def violations(counts, table, total):
    """The messages about a table, and about the folders that are above it."""
    allowed = sum(lines for lines, _ in table.values())
    if allowed > total:
        yield f"{TABLE.name}: the folders have {allowed} lines, `all` allows {total}: another folder must give them"
    for folder, (lines, owed) in table.items():
        most = lines + sum(owed.values())
        if counts.get(folder, 0) > most:
            yield f"{folder}: {counts[folder]} lines, its budget is {most}"
    if owed_to("repairs", table) > REPAIRS:
        yield f"{TABLE.name}: repairs have {owed_to('repairs', table)} lines, at most {REPAIRS}"


def main(root, *options):
    rows = list(rows_of(TABLE.read_text(encoding="utf-8")))
    table = {folder: (lines, owed) for folder, lines, owed in rows if folder != "all"}
    counts = dict.fromkeys(table, 0)
    for path in files_of(Path(root)):
        counts[folder_of(path, table)] += lines_of(Path(root, path))
    if "--print" in options:
        for folder, lines in counts.items():
            print(f"{folder:32} {lines:7} of {table[folder][0]:7} + {sum(table[folder][1].values())}")
        print(f"{'all':32} {sum(counts.values()):7}; owed: "
              + ", ".join(f"{payer} {owed_to(payer, table)}" for payer in PAYERS))
    found = list(violations(counts, table, next((lines for folder, lines, _ in rows if folder == "all"), 0)))
    for message in found:
        print(message)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
