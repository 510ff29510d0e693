#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""mutants.py JOURNAL [FILE|FOLDER... --count N --seed S] [--minutes M] [--seconds T] [--again]
mutants.py --plant FILE:LINE OLD NEW

How many faults the tests notice that are planted in GLSL files, one at a time. A fault is another operator, comparison,
constant, function, swizzle, member or condition, or a statement less. N of them are drawn from the files and written to
JOURNAL with what became of each:

    invalid   it does not compile
    same      the optimised SPIR-V is that of the file as it is
    killed    a test failed whose kind passes without it; the journal names the test
    survived  every test passed that read the file when it last ran (build/release/seen, which tools/test writes)
    cut       --seconds ended the trial before all of them had run; those that had run passed
    known     tests/glsl/equivalent_mutants.txt says why no test can notice it; it is not tried
    gone      the file no longer has that line

A run that ends early goes on with the same JOURNAL. --minutes ends it after so many. --seconds ends a trial: its tests
took so long when they last ran. --again tries again what survived or was cut. --plant tries one fault: the first OLD
of a line becomes NEW.
The kinds of tests that have noticed a fault run first, and of these the tests that read the fewest files. The first
failure ends a trial. The files are restored whenever the script ends; after a kill -9, by its next run. Nothing else
may build or test the checkout meanwhile.
Exit status: 0 no survivors, 1 survivors, 2 it could not run.
"""
import argparse
import contextlib
import fcntl
import json
import random
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from faults import faults_of
from modules import BUILD, ROOT, Modules, Unable, closure
from tests import Tests, kind_of

EQUIVALENT = ROOT / "tests" / "glsl" / "equivalent_mutants.txt"  # FILE | LINE WITH THE FAULT | REASON


def files_under(paths):
    files = []
    for path in paths:
        if not path.exists():
            raise Unable(f"{path}: no such file or folder")
        files += [path] if path.is_file() else sorted(one for one in path.rglob("*") if one.is_file())
    return files


def drawn(files, count, seed):
    """So many faults of the files: one at each of as many places."""
    chance = random.Random(seed)
    places = []
    for file in files:
        text = file.read_text(encoding="utf-8")
        places += [(file, text, place) for place in faults_of(text, closure(file, ROOT / "glsl"))]
    if not places:
        raise Unable("the files have no place for a fault")
    chosen = chance.sample(places, min(count, len(places)))
    return [described(file, text, *chance.choice(place)) for file, text, place in chosen]


def described(file, text, start, end, new):
    begin = text.rfind("\n", 0, start) + 1
    stop = text.find("\n", end)
    return {"file": str(file.resolve().relative_to(ROOT)), "line": text.count("\n", 0, start) + 1,
            "column": start - begin, "of": text[begin:stop if stop >= 0 else len(text)], "old": text[start:end],
            "new": new, "verdict": None}


def planted(fault, text):
    """The text with the fault, its line, and where it begins; None where the text no longer has the line."""
    places = [m.start() for m in re.finditer(re.escape(fault["of"]), text)]
    if not places:
        return None
    nearest = min(places, key=lambda at: abs(text.count("\n", 0, at) + 1 - fault["line"]))
    start = nearest + fault["column"]
    changed = text[:start] + fault["new"] + text[start + len(fault["old"]):]
    return changed, changed[nearest:nearest + len(fault["of"]) + len(fault["new"]) - len(fault["old"])], start


class Bench:
    """Plants faults in the checkout, one at a time, and tells what becomes of each."""

    def __init__(self, scratch, seconds):
        self.seconds = seconds
        self.modules = Modules(Path(scratch))
        self.tests = Tests()
        self.stash = BUILD / "mutants.original"
        self.restore()
        lines = EQUIVALENT.read_text(encoding="utf-8").splitlines() if EQUIVALENT.exists() else []
        rows = [[word.strip() for word in line.split(" | ")] for line in lines if " | " in line]
        self.known = {(row[0], row[1]): row[2] for row in rows}

    def restore(self):
        if self.stash.exists():
            kept = json.loads(self.stash.read_text(encoding="utf-8"))
            Path(kept["file"]).write_text(kept["text"], encoding="utf-8")
            self.stash.unlink()

    @contextlib.contextmanager
    def with_text(self, file, text):
        """The file has this text."""
        original = file.read_text(encoding="utf-8")
        if not self.stash.exists():
            aside = self.stash.with_suffix(".new")
            aside.write_text(json.dumps({"file": str(file), "text": original}), encoding="utf-8")
            aside.rename(self.stash)
        try:
            file.write_text(text, encoding="utf-8")
            yield
        finally:
            file.write_text(original, encoding="utf-8")
            if json.loads(self.stash.read_text(encoding="utf-8"))["text"] == original:
                self.stash.unlink()

    def verdict(self, fault):
        file = ROOT / fault["file"]
        text = file.read_text(encoding="utf-8")
        change = planted(fault, text)
        if change is None:
            return {"verdict": "gone"}
        changed, line, start = change
        kind = self.modules.change(str(file.relative_to(ROOT / "glsl")), text, changed, start)
        if kind != "other":
            return {"verdict": kind}
        if reason := self.known.get((fault["file"], line.strip())):
            return {"verdict": "known", "reason": reason}
        began = time.time()
        with self.with_text(file, changed):
            test, left = self.tests.failing(file, lambda: self.with_text(file, text), self.seconds)
        self.forget_compiled(began)
        if test:
            return {"verdict": "killed", "by": test}
        return {"verdict": "cut", "tests_left": left} if left else {"verdict": "survived"}

    @staticmethod
    def forget_compiled(began):
        """Shaders with a fault would only fill the cache."""
        for entry in (BUILD / "cache" / "spirv").glob("*"):
            with contextlib.suppress(FileNotFoundError):
                if entry.is_file() and entry.stat().st_mtime >= began:
                    entry.unlink()


def room(path):
    return "/".join(path.split("/")[1:3]) if path.startswith("glsl/gloam/") else "passes"


def report(faults):
    """Prints the table and the survivors; returns the number of these."""
    verdicts = ("killed", "survived", "cut", "known", "same", "invalid", "gone", None)
    print(f"| {'folder':<18} | " + " | ".join(f"{one or 'left':>8}" for one in verdicts) + " | share |")
    print("| --- |" + " ---: |" * (len(verdicts) + 1))
    rooms = sorted({room(fault["file"]) for fault in faults})
    for name in [*rooms, "all"]:
        of = [fault["verdict"] for fault in faults if name in ("all", room(fault["file"]))]
        counts = [of.count(one) for one in verdicts]
        share = f"{100.0 * counts[0] / (counts[0] + counts[1]):5.1f}" if counts[0] + counts[1] else "    -"
        print(f"| {name:<18} | " + " | ".join(f"{count:>8}" for count in counts) + f" | {share} |")
    for fault in faults:
        if fault["verdict"] in ("survived", "known"):
            print(f"{fault['verdict']}: {fault['file']}:{fault['line']}: {' '.join(fault['old'].split())!r} -> "
                  f"{fault['new']!r} in {fault['of'].strip()}" + (f": {fault['reason']}" if "reason" in fault else ""))
    return sum(fault["verdict"] == "survived" for fault in faults)


def written(path, faults):
    aside = path.with_name(path.name + ".new")
    aside.write_text("[\n" + ",\n".join(json.dumps(fault) for fault in faults) + "\n]\n", encoding="utf-8")
    aside.rename(path)


def run(options, bench):
    journal = options.journal
    if journal.exists():
        faults = json.loads(journal.read_text(encoding="utf-8"))
    else:
        if not options.paths:
            raise Unable(f"{journal}: no such journal, and no files to draw faults from")
        faults = drawn(files_under(options.paths), options.count, options.seed)
        written(journal, faults)
    bench.tests.useful |= {kind_of(fault["by"]) for fault in faults if "by" in fault}
    end = time.monotonic() + 60.0 * options.minutes
    left = [fault for fault in faults
            if fault["verdict"] is None or (options.again and fault["verdict"] in ("survived", "cut", "known", "gone"))]
    for fault in left:
        if time.monotonic() > end:
            break
        began = time.monotonic()
        fault.update(bench.verdict(fault), seconds=round(time.monotonic() - began, 1))
        written(journal, faults)
        print(f"{fault['verdict']:<8} {fault['seconds']:6.1f} s {fault['file']}:{fault['line']} "
              f"{' '.join(fault['old'].split())!r} -> {fault['new']!r} {fault.get('by', '')}", flush=True)
    return 1 if report(faults) else 0


def plant(place, old, new, bench):
    file, _, line = place.rpartition(":")
    text = (ROOT / file).read_text(encoding="utf-8")
    lines = text.splitlines(keepends=True)
    if not line.isdigit() or not 1 <= int(line) <= len(lines) or old not in lines[int(line) - 1]:
        raise Unable(f"--plant {place}: expected FILE:LINE of a line with {old!r}")
    start = sum(map(len, lines[:int(line) - 1])) + lines[int(line) - 1].index(old)
    found = bench.verdict(described(ROOT / file, text, start, start + len(old), new))
    print(f"{found['verdict']}: {place}: {old!r} -> {new!r} {found.get('by', found.get('reason', ''))}")
    return 1 if found["verdict"] == "survived" else 0


def main():
    parser = argparse.ArgumentParser(usage=__doc__, add_help=True)
    parser.add_argument("journal", type=Path, nargs="?")
    parser.add_argument("paths", type=Path, nargs="*")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=1e9)
    parser.add_argument("--seconds", type=float, default=1e9)
    parser.add_argument("--again", action="store_true")
    parser.add_argument("--plant", nargs=3, metavar=("FILE:LINE", "OLD", "NEW"))
    options = parser.parse_args()
    if not options.plant and not options.journal:
        parser.error("expected JOURNAL or --plant")
    for number in (signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda *_: sys.exit(2))
    with tempfile.TemporaryDirectory() as scratch, open(BUILD / "mutants.lock", "w", encoding="utf-8") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            raise Unable(f"{BUILD / 'mutants.lock'}: another run plants faults in this checkout") from None
        bench = Bench(scratch, options.seconds)
        return plant(*options.plant, bench) if options.plant else run(options, bench)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (Unable, OSError, subprocess.SubprocessError) as error:
        print(f"mutants.py: {error}", file=sys.stderr)
        sys.exit(2)
