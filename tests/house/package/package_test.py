#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""package_test.py SOURCE BUILD: another project finds the installed package, or includes gloam's tree, and tests a shader
of its own."""
import re
import shutil
import unittest
from pathlib import Path

from run import BUILD, CONSUMER, SOURCE, VERSION, configured, run

CACHE = dict(re.findall(r"^(\w+):\w+=(.*)$", (BUILD / "CMakeCache.txt").read_text(encoding="utf-8"), re.M))
COMPILER = f"-DCMAKE_CXX_COMPILER={CACHE['CMAKE_CXX_COMPILER']}"
OPTIONS = (COMPILER, f"-DCMAKE_BUILD_TYPE={CACHE['CMAKE_BUILD_TYPE']}",
           "-DCMAKE_CXX_FLAGS=" + ("-fsanitize=address,undefined" if CACHE["GLOAM_SANITIZE"] == "ON" else ""))
ONLY_THE_PROGRAM_NEEDS = ("embree", "assimp", "OpenEXR", "CLI11", "SQLite3", "rapidcheck", "benchmark")


class InFolder(unittest.TestCase):
    def setUp(self):
        self.work = BUILD / "tests/house/package" / self._testMethodName  # not another each time: ccache knows it
        shutil.rmtree(self.work, ignore_errors=True)
        self.work.mkdir(parents=True)
        self.addCleanup(shutil.rmtree, self.work)


class Installed(InFolder):
    def assert_fails(self, pattern, *command):
        with self.assertRaisesRegex(AssertionError, f"(?s){pattern}"):
            run(*command)

    def test_the_framework_alone_has_nothing_of_ambient_occlusion(self):
        prefix = self.work / "framework"
        for component in ("common", "shader_test"):
            run("cmake", "--install", BUILD, "--component", component, "--prefix", prefix)
        self.assertEqual([], [*prefix.rglob("*.glsl"), *prefix.rglob("*.comp"), *prefix.rglob("bin/*")])
        self.assert_fails(r"without its component glsl;\s+it\s+has:\s+shader_test", "cmake", "-S", CONSUMER, "-B",
                          self.work / "build", COMPILER, f"-DCMAKE_PREFIX_PATH={prefix}")

    def test_each_minor_version_is_another(self):
        run("cmake", "--install", BUILD, "--component", "common", "--prefix", self.work)
        run("cmake", "--install", BUILD, "--component", "glsl", "--prefix", self.work)
        project = ('cmake_minimum_required(VERSION 3.25)\nproject(asks LANGUAGES NONE)\n'
                   'find_package(gloam {} COMPONENTS glsl)\nmessage("found ${{gloam_VERSION}}.")\n')
        for asked in ("0.2", "0.3", "0.4", "1.0"):
            (self.work / "CMakeLists.txt").write_text(project.format(asked), encoding="utf-8")
            found = run("cmake", "-S", self.work, "-B", self.work / asked, f"-DCMAKE_PREFIX_PATH={self.work}")
            self.assertEqual(VERSION.startswith(asked + "."), f"found {VERSION}." in found, found)

    def test_a_shader_passes_and_a_broken_one_fails_with_a_verdict(self):
        """In a package that was moved, by GoogleTest, and by doctest where that is installed."""
        run("cmake", "--install", BUILD, "--prefix", self.work / "installed")
        prefix = (self.work / "installed").rename(self.work / "moved here")
        consumer = Path(shutil.copytree(CONSUMER, self.work / "own_function"))
        options = (f"-DCMAKE_PREFIX_PATH={prefix}", *OPTIONS)
        self.assert_fails("expected GoogleTest with", "cmake", "-S", consumer, "-B", self.work / "alone", *options,
                          "-DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON")
        misspelt = Path(shutil.copytree(CONSUMER, self.work / "misspelt")) / "CMakeLists.txt"
        misspelt.write_text(misspelt.read_text(encoding="utf-8").replace(" SOURCES ", " SOURCE "), encoding="utf-8")
        self.assert_fails(r'not\s+"SOURCE,', "cmake", "-S", misspelt.parent, "-B", self.work / "b", *options)
        users = [(consumer, consumer / "build" / "own_function_test",
                  "tone_reinhard.*outside.*FAILED  . Tone.MatchesReinhard.*1 FAILED TEST")]
        if Path("/usr/include/doctest/doctest.h").exists():
            users.append((Path(__file__).with_name("doctest"), self.work / "doctest" / "doctest_user",
                          "answer.passed.*tone_reinhard.*outside"))
        for source, program, _ in users:
            configured(source, program.parent, *options, f"-DSHADERS={consumer}/shaders")
            run("cmake", "--build", program.parent)
            self.assertRegex(run(program), r"\[  PASSED  \] 2 tests|SUCCESS!")
        shader = consumer / "shaders" / "tone.glsl"
        text = shader.read_text(encoding="utf-8")
        self.assertIn("1.0 + x", text)
        shader.write_text(text.replace("1.0 + x", "1.5 + x"), encoding="utf-8")
        for _, program, verdict in users:
            self.assert_fails(verdict, program)


class Included(InFolder):
    def test_it_is_the_framework_alone(self):
        """Without the packages that only the program needs, without gloam's tests, and without its warnings. The project's
        test compiles against the headers by their installed names."""
        without = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON" for name in ONLY_THE_PROGRAM_NEEDS]
        targets = configured(CONSUMER, self.work, f"-DGLOAM_SOURCE={SOURCE}", COMPILER, "-DCMAKE_BUILD_TYPE=Debug",
                             *without)
        self.assertNotRegex(targets, "gloam_(catalogue|effect|scene|record):|bin/gloam|_tests:")
        self.assertIn("gloam_judge:", targets)
        run("ninja", "-C", self.work, "CMakeFiles/own_function_test.dir/shader_test.cpp.o")
        self.assertNotIn("-Werror", (self.work / "compile_commands.json").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main(argv=["package_test.py"])
