# SPDX-License-Identifier: MIT
"""ci_test.py GLOAM WORKFLOW: the commands of the workflow's steps, run on shaders as a repository has them."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

GLOAM, WORKFLOW = sys.argv[1], pathlib.Path(sys.argv[2]).read_text(encoding="utf-8")
GOOD = "// x in [0, 4]\nfloat tone(float x) { return x / (1.0 + x); }\n"
BAD = "// x in [0, 4]\nfloat root(float x) { return sqrt(x - 1.0); }\n"


def step(name):
    """The lines behind `run:` of the step with this name."""
    text = WORKFLOW.split(f"- name: {name}\n", 1)[1].split("\n      - ", 1)[0]
    return "\n".join(line.strip() for line in text.split("run: |\n", 1)[1].split("\n"))


class Workflow(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        program = self.folder / "gloam/build/release/bin/gloam"
        program.parent.mkdir(parents=True)
        program.symlink_to(GLOAM)
        (self.folder / "shaders").mkdir()

    def run_step(self, name):
        return subprocess.run(["bash", "-e", "-c", step(name)], cwd=self.folder, capture_output=True, text=True,
                              env=dict(os.environ, SHADERS="shaders/*.glsl"), check=False)

    def test_sound_shaders_pass_and_leave_pages(self):
        for file in "tone", "curve":
            (self.folder / f"shaders/{file}.glsl").write_text(GOOD, encoding="utf-8")
        for name in ("check", "audit"):
            done = self.run_step(name)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertLessEqual({"tone.glsl.xml", "curve.glsl.check.html", "tone.glsl.html"},
                             {file.name for file in (self.folder / "results").iterdir()})

    def test_a_faulty_shader_ends_the_job(self):
        (self.folder / "shaders/root.glsl").write_text(BAD, encoding="utf-8")
        (self.folder / "results").mkdir()
        self.assertEqual(self.run_step("audit").returncode, 1)

    def test_it_is_what_it_says(self):
        self.assertIn("container: debian:13", WORKFLOW)
        self.assertIn("--device all", step("check"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
