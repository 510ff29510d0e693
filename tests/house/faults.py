#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""faults.py [--texts] [NUMBER|FILE]...: whether the tests notice the faults of faults.txt, by number or part of a path.

Plants each fault, builds what its tests need in build/release, runs them until one fails, and restores the file; build
again before other tests. Exits with 1 if one is not noticed. --texts: plants none, and fails unless the text of each
row is once in its file.
"""
import json
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "release"


def rows_of(text):
    """(file, text, text with the fault, tests) of each row."""
    for section in re.split(r"^\[", text, flags=re.M)[1:]:
        folder, tests = re.match(r"(\S+) (\S+)\]", section).groups()
        for file, *texts in re.findall(r"^(\S+): (.+) => (.+)$", section, re.M):
            yield ROOT / folder / file, *texts, tests


def output_of(*command):
    return subprocess.run(command, cwd=ROOT, text=True, capture_output=True, check=False).stdout


def what_notices(tests):
    """Which test fails first."""
    ctest = ("ctest", "--test-dir", BUILD, "-R", tests)
    words = {Path(word) for test in json.loads(output_of(*ctest, "--show-only=json-v1"))["tests"]
             for word in test.get("command", [])}
    programs = [word.relative_to(BUILD) for word in words if word.parent == BUILD / "bin"]
    built = output_of("ninja", "-C", BUILD, *programs)
    if "ninja: build stopped" in built:
        return "NOT BUILT\n" + built[-2000:]
    text = output_of(*ctest, "--stop-on-failure", "--output-on-failure")
    test = re.search(r"^\[  FAILED  \] (\S+?),? ", text, re.M) or re.search(r"^\s*\d+ - (\S+) \(", text, re.M)
    return f"noticed by {test[1]}" if test else "NOT NOTICED"


def planted(file, text, fault, tests):
    """What notices the fault. Nothing that is made with it stays in the cache."""
    source, begin = file.read_text("utf-8"), time.time()
    try:
        file.write_text(source.replace(text, fault), "utf-8")
        return what_notices(tests)
    finally:
        file.write_text(source, "utf-8")
        for made in (BUILD / "cache").rglob("*.*"):
            if made.stat().st_mtime > begin:
                made.unlink()


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    only, all_noticed = sys.argv[1:] or [""], True
    for number, (path, *row) in enumerate(rows_of(Path(__file__).with_suffix(".txt").read_text("utf-8")), 1):
        result = "" if path.read_text("utf-8").count(row[0]) == 1 else f"EXPECTED ONCE: {row[0]}"
        if not result and any(name == str(number) or name in str(path) for name in only):
            clean = not output_of("git", "status", "--porcelain", path)
            result = planted(path, *row) if clean else "HAS CHANGES that are not committed"
        print(f"{number} {path.relative_to(ROOT)}: {result}\n" if result else "", end="", flush=True)
        all_noticed &= not result or result.startswith("noticed")
    sys.exit(not all_noticed)
