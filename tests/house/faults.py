#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""faults.py [--texts] [NUMBER|FILE]...: whether the tests notice the faults of faults.txt, by number or part of a path.

Plants each fault, builds what its tests need in build/release, runs them until one fails, and restores the file; build
again before other tests. First the tests must pass without a fault. Exits with 1 if one is not noticed, or an argument
names none. --texts: plants none, and fails unless the text of each row is once in its file.
"""
import json
import re
import signal
import subprocess
import sys
import time
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "release"


def rows_of(text):
    """(path, text, text with the fault, tests) of each row; a line of another form ends the run."""
    for number, line in enumerate(text.splitlines(), 1):
        if heading := re.fullmatch(r"\[(\S+) (\S+)\]", line):
            folder, tests = heading.groups()
        elif row := re.fullmatch(r"(\S+): (.+) => (.+)", line):
            yield f"{folder}/{row[1]}", row[2], row[3], tests
        elif line and not line.startswith("#"):
            sys.exit(f"faults.txt:{number}: expected FILE: TEXT => FAULT")


def run(*command):
    return subprocess.run(command, cwd=ROOT, text=True, capture_output=True, check=False)


def what_notices(tests):
    """Which test fails first, or why that is not known."""
    ctest = ("ctest", "--test-dir", BUILD, "-R", tests)
    words = {Path(word) for test in json.loads(run(*ctest, "--show-only=json-v1").stdout)["tests"]
             for word in test.get("command", [])}
    built = run("ninja", "-C", BUILD, *(word.relative_to(BUILD) for word in words if word.parent == BUILD / "bin"))
    if built.returncode:
        return "NOT BUILT\n" + (built.stdout + built.stderr)[-2000:]
    ran = run(*ctest, "--stop-on-failure", "--output-on-failure", "--no-tests=error")
    test = re.search(r"^\[  FAILED  \] (\S+?),? |^\s*\d+ - (\S+) \((?!Not Run|Skipped|Disabled)", ran.stdout, re.M)
    return (f"noticed by {test[1] or test[2]}" if test else "NOT NOTICED" if not ran.returncode else
            "NOT RUN\n" + (ran.stdout + ran.stderr)[-2000:])


def planted(file, text, fault, tests):
    """What notices the fault. Nothing that is made with it stays in the cache."""
    source, begin = file.read_text("utf-8"), time.time()
    try:
        file.write_text(source.replace(text, fault), "utf-8")
        return what_notices(tests)
    finally:
        file.write_text(source, "utf-8")
        for made in [one for one in (BUILD / "cache").rglob("*.*") if one.stat().st_mtime > begin]:
            made.unlink()


if __name__ == "__main__":
    for end in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(end, lambda *_: sys.exit(1))
    rows = [(str(i), *row) for i, row in enumerate(rows_of(Path(__file__).with_suffix(".txt").read_text("utf-8")), 1)]
    names = [word for word in sys.argv[1:] if word != "--texts"] or [""]
    if none := [name for name in names if not any(name == number or name in path for number, path, *_ in rows)]:
        sys.exit(f"faults.txt: no row of {none}")
    without_fault, all_noticed = cache(what_notices), True
    for number, path, *row in rows:
        result = "" if (ROOT / path).read_text("utf-8").count(row[0]) == 1 else f"EXPECTED ONCE: {row[0]}"
        if not result and "--texts" not in sys.argv and any(name == number or name in path for name in names):
            before = run("git", "status", "--porcelain", path).stdout or without_fault(row[2])
            result = planted(ROOT / path, *row) if before == "NOT NOTICED" else f"NOT PLANTED: {before}"
        print(f"{number} {path}: {result}\n" if result else "", end="", flush=True)
        all_noticed &= not result or result.startswith("noticed")
    sys.exit(not all_noticed)
