#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""release_test.py SOURCE BUILD: what a release consists of, but for the Debian packages (debian_test.py).

One version everywhere, the source archive, the recipe for vcpkg, the commits since the last release.
"""
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from run import BUILD, CONSUMER, SOURCE, VERSION, configured, run

LONGEST_SUBJECT = 72


def text(*parts):
    return SOURCE.joinpath(*parts).read_text(encoding="utf-8")


RELEASED = re.findall(r"^## (\d+\.\d+\.\d+), (\d{4}-\d\d-\d\d)$", text("CHANGELOG.md"), re.M)


class Versions(unittest.TestCase):
    def test_the_change_log_begins_with_the_version(self):
        self.assertEqual(VERSION, RELEASED[0][0])
        self.assertEqual(sorted(RELEASED, key=lambda one: [int(n) for n in one[0].split(".")], reverse=True), RELEASED)

    def test_every_other_place_has_it(self):
        minor = VERSION.rsplit(".", 1)[0]
        self.assertIn(f'CPACK_PACKAGE_VERSION "{VERSION}"', (BUILD / "CPackConfig.cmake").read_text(encoding="utf-8"))
        self.assertEqual(VERSION, json.loads(text("packaging", "vcpkg", "vcpkg.json"))["version"])
        self.assertIn(f"find_package(gloam {minor} ", (CONSUMER / "CMakeLists.txt").read_text(encoding="utf-8"))


class SourceArchive(unittest.TestCase):
    def test_it_builds_outside_git(self):
        with tempfile.TemporaryDirectory() as folder:
            run("cpack", "--config", BUILD / "CPackSourceConfig.cmake", "-B", folder)
            name = f"gloam-{VERSION}"
            run("tar", "-xzf", f"{folder}/{name}.tar.gz", "-C", folder)
            tree = Path(folder) / name
            for left_out in (".git", "build", "compile_commands.json"):
                self.assertFalse((tree / left_out).exists(), left_out)
            targets = configured(tree, Path(folder) / "build", "-DBUILD_TESTING=ON")
            self.assertIn("bin/gloam", targets)
            self.assertIn("bin/cli_tests", targets)


class Recipe(unittest.TestCase):
    """vcpkg need not be here: what it would run is run, with the options that its recipe gives."""

    def test_vcpkg_configures_with_a_static_spirv_cross(self):
        options = re.findall(r"-DGLOAM_\w+=\w+", text("packaging", "vcpkg", "portfile.cmake"))
        with tempfile.TemporaryDirectory() as build:
            targets = configured(SOURCE, build, *options, "-DCMAKE_DISABLE_FIND_PACKAGE_spirv_cross_c_shared=ON")
            self.assertIn("libgloam_judge.a", targets)
            self.assertNotIn("bin/gloam", targets)
            config = (Path(build) / "package" / "gloam-config.cmake").read_text(encoding="utf-8")
            self.assertIn("spirv_cross_reflect spirv_cross_c ", config)


class Commits(unittest.TestCase):
    @unittest.skipUnless(shutil.which("git"), "no git here")
    def test_those_since_the_last_release_have_none(self):
        listed = subprocess.run(["git", "-C", SOURCE, "log", "--no-merges", f"--since={RELEASED[0][1]} 23:59",
                                 "--format=%s%x01%b%x02"], capture_output=True, text=True, check=False)
        if listed.returncode:
            self.skipTest("no repository here")
        commits = [one.strip("\n").split("\x01") for one in listed.stdout.split("\x02") if "\x01" in one]
        for subject, body in commits:
            self.assertLessEqual(len(subject), LONGEST_SUBJECT, subject)
            self.assertTrue(body.strip(), f"no body that says why: {subject}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
