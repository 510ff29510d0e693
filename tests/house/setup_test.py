#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tools/setup against a pretended Debian: what it installs, and what it says when it cannot."""
import contextlib
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SETUP = Path(__file__).resolve().parents[2] / "tools" / "setup"
AS_NOBODY = {"user": 65534, "group": 65534, "extra_groups": []} if os.geteuid() == 0 else {}
PROGRAMS = ("awk", "bash", "cat", "dirname", "env", "grep", "mktemp", "rm", "sed", "tail", "tr", "true")

# Each reads and writes plain files of the pretended machine: installed, offered, log.
PRETENDED = {
    "dpkg-query": 'cd "$MACHINE"\nfor p; do if grep -qx -- "$p" installed; then echo "$p installed"; fi; done',
    "dpkg": ":",
    "sudo": '[ "$1" != -n ] || shift; [ "$1" = -v ] || exec "$@"',
    "apt-cache": 'cd "$MACHINE"; shift\n'
                 'for p; do if grep -qx -- "$p" offered; then printf "%s:\\n  Candidate: 1.0\\n" "$p"; fi\n'
                 'if grep -qx -- "$p" snaps; then printf "%s:\\n  Candidate: 2:1snap1-0\\n" "$p"; fi; done',
    "apt-get": 'cd "$MACHINE"; echo "$*" >>log\n'
               'case "$*" in\n*" update") exit 0 ;;\n'
               '*) [ ! -e broken ] || { echo "E: disk full"; exit 100; } ;;\nesac\n'
               'for p; do if grep -qx -- "$p" offered; then echo "$p" >>installed; fi; done',
}


class Machine:
    """A folder that plays a machine: its packages, its programs, and a copy of tools/setup with a list of its own."""

    def __init__(self, folder, wanted=("g++", "libfmt-dev"), installed=(), offered=("g++", "libfmt-dev"), without=(),
                 tests=()):
        self.folder = Path(folder)
        self.folder.chmod(0o777)
        for name in ("bin", "tools"):
            (self.folder / name).mkdir()
        shutil.copy(SETUP, self.folder / "tools" / "setup")
        self.write("tools/packages.txt", ["# the list", *(f"{name}   # why" for name in wanted)])
        self.write("tools/packages-tests.txt", ["# the tests' list", *(f"{name} # why" for name in tests)])
        self.write("installed", installed)
        self.write("offered", offered)
        self.write("snaps", ())
        self.write("log", ())
        for name in PROGRAMS:
            (self.folder / "bin" / name).symlink_to(shutil.which(name))
        for name, body in PRETENDED.items():
            if name not in without:
                self.write(f"bin/{name}", ["#!/bin/bash", body])
                (self.folder / "bin" / name).chmod(0o755)

    def write(self, name, lines):
        (self.folder / name).write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
        (self.folder / name).chmod(0o666)

    def log(self):
        return (self.folder / "log").read_text(encoding="utf-8").splitlines()

    def setup(self, *arguments, **options):
        environment = {"PATH": str(self.folder / "bin"), "MACHINE": str(self.folder)}
        return subprocess.run([self.folder / "tools" / "setup", *arguments], env=environment, capture_output=True,
                              text=True, check=False, **options)


BOTH = ("g++", "libfmt-dev")
ONE_WANTED = {"wanted": ("g++", "browser?"), "installed": ("g++",), "offered": ("g++", "browser")}  # the browser
NOBODY_OFFERS = {**ONE_WANTED, "installed": (), "offered": ("g++",)}
WITH_TESTS = {"tests": ("clang-format", "browser?"), "offered": (*BOTH, "clang-format", "browser")}
INSTALLING = "tools/setup: installing "
WITHOUT = "tools/setup: going on without browser: "

# A machine, the arguments, and what is then said; once more, all is silent and nothing is called.
GOES_ON = {
    "nothing is missing": ({"installed": BOTH}, (), {}, ()),
    "what is missing only": ({"installed": ("g++",)}, (), {}, (INSTALLING + "libfmt-dev",)),
    "with sudo": ({"installed": ("g++",)}, (), AS_NOBODY, (INSTALLING + "libfmt-dev",)),
    "the program alone": (WITH_TESTS, ("program",), {}, (INSTALLING + "g++ libfmt-dev",)),
    "its tests too": ({**WITH_TESTS, "installed": BOTH}, (), {}, (INSTALLING + "clang-format", INSTALLING + "browser")),
    "one that is wanted": ({**ONE_WANTED, "installed": ()}, (), {}, (INSTALLING + "g++", INSTALLING + "browser")),
    "with a sudo that asks nothing": (ONE_WANTED, (), AS_NOBODY, (INSTALLING + "browser",)),
}
# What is wanted stays away: a machine, what happens to it, and what is then said.
GOES_ON_WITHOUT = {
    "nobody offers it": (NOBODY_OFFERS, None, {}, (INSTALLING + "g++", WITHOUT +
                                                   "no package source of this machine offers it")),
    "a snap": (NOBODY_OFFERS, ("snaps", ("browser",)), {}, (INSTALLING + "g++", WITHOUT +
                                                            "no package source of this machine offers it")),
    "it cannot be installed": (ONE_WANTED, ("broken", ()), {}, (INSTALLING + "browser", WITHOUT + "E: disk full")),
    "a password would be asked for": ({**ONE_WANTED, "without": ("sudo",)}, None, AS_NOBODY,
                                      (WITHOUT + "not root, and no sudo without a password",)),
}
# And what stops it, with parts of its last line.
STOPS = {
    "no package manager": ({"without": ("apt-get",)}, None, (), {}, ("no apt-get", "g++ libfmt-dev")),
    "an unknown list": ({}, None, ("everything",), {}, ("'everything'", "expected program, engines or nothing")),
    "no source offers it": ({"offered": ("g++",)}, None, (), {}, ("offers: libfmt-dev",)),
    "a full disk": ({}, ("broken", ()), (), {}, ("could not install: g++ libfmt-dev",)),
    "neither root nor sudo": ({"installed": ("g++",), "without": ("sudo",)}, None, (), AS_NOBODY,
                              ("neither root nor sudo", "apt-get install --no-install-recommends libfmt-dev")),
}


class Setup(unittest.TestCase):
    @contextlib.contextmanager
    def machine(self, what, kinds, change=None):
        with self.subTest(what), tempfile.TemporaryDirectory() as folder:
            machine = Machine(folder, **kinds)
            if change:
                machine.write(*change)
            yield machine

    def assert_goes_on(self, result, *lines):
        self.assertEqual((result.returncode, result.stdout, result.stderr.splitlines()), (0, "", list(lines)))

    def test_installs_what_is_missing_alone_and_only_once(self):
        for what, (kinds, arguments, options, lines) in GOES_ON.items():
            with self.machine(what, kinds) as machine:
                self.assert_goes_on(machine.setup(*arguments, **options), *lines)
                calls = machine.log()
                installed = [call.partition("install --no-install-recommends ")[2] for call in calls]
                self.assertEqual([line.removeprefix(INSTALLING) for line in lines], list(filter(None, installed)))
                self.assert_goes_on(machine.setup(*arguments, **options))
                self.assertEqual(machine.log(), calls)

    def test_goes_on_without_what_is_only_wanted(self):
        for what, (kinds, change, options, lines) in GOES_ON_WITHOUT.items():
            with self.machine(what, kinds, change) as machine:
                self.assert_goes_on(machine.setup(**options), *lines)
                self.assertTrue(change and change[0] == "broken" or "browser" not in " ".join(machine.log()))

    def test_says_what_stops_it_in_its_last_line(self):
        for what, (kinds, change, arguments, options, parts) in STOPS.items():
            with self.machine(what, kinds, change) as machine:
                result = machine.setup(*arguments, **options)
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                last = result.stderr.splitlines()[-1]
                self.assertTrue(last.startswith("tools/setup: "), result.stderr)
                for part in parts:
                    self.assertIn(part, last)
                self.assertEqual("E: disk full" in result.stderr, change is not None)


if __name__ == "__main__":
    unittest.main()
