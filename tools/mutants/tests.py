# SPDX-License-Identifier: MIT
"""The tests of the build folder, and which files each of them reads."""
import contextlib
import json
import os
import re
import signal
import subprocess

from modules import BUILD, Unable

STAGES = (1.5, 8.0, 40.0, 1e9)  # seconds of the tests that run together, in one process a program
START = 0.5  # seconds that a process takes besides its tests


def kind_of(test):
    """The name of a test without its parameter."""
    return "/".join(test.split("/")[:-1]) if test.count("/") > 1 else test


class Tests:
    """The tests of the build folder, and which files they read when they last ran."""

    def __init__(self):
        listing = subprocess.run(["ctest", "--test-dir", str(BUILD), "--show-only=json-v1"], capture_output=True,
                                 text=True, check=True).stdout
        self.groups = {}
        for test in json.loads(listing)["tests"]:
            environment = [p["value"] for p in test.get("properties", []) if p["name"] == "ENVIRONMENT"]
            variables = dict(one.split("=", 1) for one in (environment[0] if environment else []))
            if "GLOAM_DEPENDENCIES_OUTPUT" in variables and "--swiftshader" not in test["command"]:
                self.groups[test["name"].replace("/", ",")] = (test["command"][0], variables)
        self.lists = {}
        for file in (BUILD / "seen").glob("*:*"):
            *read, last = file.read_text(encoding="utf-8").splitlines() or [""]
            group, name = file.name.split(":", 1)
            if group in self.groups and last.startswith("seconds "):
                self.lists[(group, name.replace(",", "/"))] = (set(read), float(last.split()[1]))
        self.shared = {group: set((BUILD / "seen" / group).read_text(encoding="utf-8").splitlines())
                       for group in self.groups if (BUILD / "seen" / group).exists()}
        if not self.lists:
            raise Unable(f"{BUILD / 'seen'}: no lists of what the tests read; tools/test writes them")
        self.sound = {}  # by kind of test: whether one passes without the fault
        self.useful = set()  # kinds of tests that have noticed a fault

    def reading(self, file):
        """The tests that read a file, as (group, name, seconds): first the kinds that have noticed a fault, of these
        first the tests with the file's name in theirs, then those that read the fewest files."""
        found = [(kind_of(name) not in self.useful, file.stem not in name, len(read), seconds, group, name)
                 for (group, name), (read, seconds) in self.lists.items()
                 if str(file) in read or str(file) in self.shared.get(group, ())]
        return [(group, name, seconds) for *_, seconds, group, name in sorted(found)]

    def run(self, group, names, seconds):
        """The first of these tests of a group's program that fails, or None."""
        program, variables = self.groups[group]
        environment = {**os.environ, **variables}
        for name in ("GLOAM_DEPENDENCIES_OUTPUT", "GTEST_TOTAL_SHARDS", "GTEST_SHARD_INDEX"):
            environment.pop(name, None)
        command = [program, "--gtest_fail_fast", "--gtest_brief=1", f"--gtest_filter={':'.join(names)}"]
        process = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   text=True, errors="replace", start_new_session=True)
        try:
            output = process.communicate(timeout=60 + 10 * seconds)[0]
        except subprocess.TimeoutExpired:
            output = ""
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
        if process.returncode == 0:
            return None
        failed = re.search(r"^\[  FAILED  \] ([^\s,]+)", output, re.M)
        return failed[1] if failed else names[0]

    def stages(self, file, most):
        """The tests that read a file in stages of rising length, each as [group, names, seconds] by program; as many
        as take about `most` seconds."""
        left = self.reading(file)
        for limit in STAGES:
            stage = {}
            took = 0.0
            while left and took < min(limit, most):
                group, name, seconds = left.pop(0)
                program = self.groups[group][0]
                took += seconds + (0.0 if program in stage else START)
                known = stage.setdefault(program, [group, [], 0.0])
                known[1].append(name)
                known[2] += seconds
            most -= took
            yield stage.values()

    def failing(self, file, restored, most):
        """The first test that fails on what the file is now and passes on what it was, or None; and how many of the
        tests that read the file did not run.
        restored: makes a context in which the file is as it was. most: seconds that the tests take, about."""
        left = len(self.reading(file))
        for stage in self.stages(file, most):
            for group, names, seconds in stage:
                left -= len(names)
                names = list(names)
                while names and (test := self.run(group, names, seconds)):
                    kind = kind_of(test)
                    if kind not in self.sound:
                        with restored():
                            self.sound[kind] = self.run(group, [test], seconds) is None
                    if self.sound[kind]:
                        self.useful.add(kind)
                        return test, left
                    names = [name for name in names if name != test]
        return None, left
