#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""tools/setup against a pretended Debian: what it installs, and what it says when it cannot."""
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


class Setup(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.addCleanup(self.place.cleanup)

    def machine(self, **kinds):
        return Machine(self.place.name, **kinds)

    def assert_one_line(self, result, *parts):
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        last = result.stderr.splitlines()[-1]
        self.assertTrue(last.startswith("tools/setup: "), result.stderr)
        for part in parts:
            self.assertIn(part, last)

    def test_nothing_missing_is_silent_and_calls_nothing(self):
        machine = self.machine(installed=("libfmt-dev", "g++"))
        result = machine.setup()
        self.assertEqual((result.returncode, result.stdout, result.stderr, machine.log()), (0, "", "", []))

    def test_no_package_manager(self):
        result = self.machine(without=("apt-get",)).setup()
        self.assert_one_line(result, "no apt-get", "g++ libfmt-dev")
        self.assertEqual(result.stderr.count("\n"), 1)

    def test_installs_what_is_missing_only_and_only_once(self):
        machine = self.machine(installed=("g++",))
        result = machine.setup()
        self.assertEqual((result.returncode, result.stderr), (0, "tools/setup: installing libfmt-dev\n"))
        self.assertEqual(len(machine.log()), 2)
        self.assertTrue(machine.log()[1].endswith("install --no-install-recommends libfmt-dev"), machine.log())
        again = machine.setup()
        self.assertEqual((again.returncode, again.stderr, len(machine.log())), (0, "", 2))

    def test_the_program_needs_less_than_its_tests(self):
        machine = self.machine(tests=("clang-format", "browser?"),
                               offered=("g++", "libfmt-dev", "clang-format", "browser"))
        program = machine.setup("program")
        self.assertEqual((program.returncode, program.stderr), (0, "tools/setup: installing g++ libfmt-dev\n"))
        tests = machine.setup()
        self.assertEqual((tests.returncode, tests.stderr),
                         (0, "tools/setup: installing clang-format\ntools/setup: installing browser\n"))
        self.assertEqual((machine.setup().stderr, machine.setup("program").stderr), ("", ""))

    def test_an_unknown_list(self):
        self.assert_one_line(self.machine().setup("everything"), "'everything'", "expected program or nothing")

    def test_installs_with_sudo(self):
        machine = self.machine(installed=("g++",))
        result = machine.setup(**AS_NOBODY)
        self.assertEqual((result.returncode, result.stderr), (0, "tools/setup: installing libfmt-dev\n"))
        self.assertEqual(machine.setup(**AS_NOBODY).stderr, "")

    def test_a_package_that_no_source_offers(self):
        self.assert_one_line(self.machine(offered=("g++",)).setup(), "offers: libfmt-dev")

    def test_an_installation_that_fails_shows_why(self):
        machine = self.machine()
        machine.write("broken", ())
        result = machine.setup()
        self.assert_one_line(result, "could not install: g++ libfmt-dev")
        self.assertIn("E: disk full", result.stderr)

    def test_neither_root_nor_sudo(self):
        result = self.machine(installed=("g++",), without=("sudo",)).setup(**AS_NOBODY)
        self.assert_one_line(result, "neither root nor sudo", "apt-get install --no-install-recommends libfmt-dev")


class Optional(unittest.TestCase):
    """A package marked with ?: browser? is wanted, g++ is needed."""

    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.addCleanup(self.place.cleanup)

    def machine(self, installed=("g++",), offered=("g++", "browser"), **kinds):
        return Machine(self.place.name, wanted=("g++", "browser?"), installed=installed, offered=offered, **kinds)

    def assert_goes_on(self, result, *lines):
        self.assertEqual((result.returncode, result.stdout), (0, ""))
        self.assertEqual(result.stderr.splitlines(), list(lines))

    def test_is_installed_where_it_is_offered_and_only_once(self):
        machine = self.machine(installed=())
        self.assert_goes_on(machine.setup(), "tools/setup: installing g++", "tools/setup: installing browser")
        calls = len(machine.log())
        self.assert_goes_on(machine.setup())
        self.assertEqual(len(machine.log()), calls)

    def test_is_installed_later_too(self):
        machine = self.machine()
        self.assert_goes_on(machine.setup(), "tools/setup: installing browser")
        self.assert_goes_on(machine.setup())

    def test_is_done_without_where_nobody_offers_it(self):
        machine = self.machine(installed=(), offered=("g++",))
        self.assert_goes_on(machine.setup(), "tools/setup: installing g++",
                            "tools/setup: going on without browser: no package source of this machine offers it")
        calls = len(machine.log())
        self.assert_goes_on(machine.setup())
        self.assertEqual(len(machine.log()), calls)

    def test_a_snap_is_not_installed(self):
        machine = self.machine(installed=(), offered=("g++",))
        machine.write("snaps", ("browser",))
        self.assert_goes_on(machine.setup(), "tools/setup: installing g++",
                            "tools/setup: going on without browser: no package source of this machine offers it")
        self.assertNotIn("browser", " ".join(machine.log()))

    def test_one_that_cannot_be_installed_does_not_stop_the_rest(self):
        machine = self.machine()
        machine.write("broken", ())
        self.assert_goes_on(machine.setup(), "tools/setup: installing browser",
                            "tools/setup: going on without browser: E: disk full")

    def test_is_installed_with_a_sudo_that_asks_nothing(self):
        machine = self.machine()
        self.assert_goes_on(machine.setup(**AS_NOBODY), "tools/setup: installing browser")
        self.assert_goes_on(machine.setup(**AS_NOBODY))

    def test_nobody_is_asked_for_a_password(self):
        machine = self.machine(without=("sudo",))
        self.assert_goes_on(machine.setup(**AS_NOBODY),
                            "tools/setup: going on without browser: not root, and no sudo without a password")
        self.assertEqual(machine.log(), [])


if __name__ == "__main__":
    unittest.main()
