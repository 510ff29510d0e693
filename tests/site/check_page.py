# SPDX-License-Identifier: MIT
"""The page of the site that checks the browser, and the program that writes it."""
import json
import shutil
import subprocess
import tempfile
from pathlib import Path

from site_case import GLOAM, SiteCase

NATIVE = "es:llvmpipe-3.0"  # the device whose verdicts a browser's must be


def run(*arguments):
    """The program with these arguments."""
    return subprocess.run([GLOAM, *map(str, arguments)], capture_output=True, text=True, check=False)


class Spoiled:
    """Copies of a small site in which the kernel of a function of the filters is changed in one place: call it with the
    old and the new text."""

    def __init__(self, folder):
        self.folder = folder
        self.site = folder / "few"
        written = run("site", self.site, "TSSAO-10", "TSSAO-10-g", "TSSAO-11", "GTAO-arc", "--method", "sweep",
                      "--no-pictures")
        assert written.returncode == 0, written.stderr

    def __call__(self, old, new):
        copy = Path(tempfile.mkdtemp(dir=self.folder)) / "site"
        shutil.copytree(self.site, copy)
        file = copy / "checks-filter.js"
        text = file.read_text(encoding="utf-8")
        assert old in text, f"{old} is not in {file}"
        file.write_text(text.replace(old, new, 1), encoding="utf-8")
        return copy


def compare(test, known, rows):
    """Fails where rows of the page differ from those of the program, by equation, in what does not depend on the
    driver."""
    test.assertEqual(sorted(known), sorted(row["equation"] for row in rows))
    for row in rows:
        there = known[row["equation"]]
        for member in ("function", "file", "variant", "verdict", "inputs", "outside", "recorded", "classes", "budget"):
            test.assertEqual(there[member], row[member], f"{row['equation']}: {member}")
        test.assertEqual(set(there), set(row))


class CheckPage:
    """The page that checks the browser, once it can run checks."""

    READY = "!document.getElementById('run').disabled"

    def __init__(self, browser, folder, again=True):
        self.browser = browser
        file = folder / "check.html"
        if again or browser.evaluate("location.href") != file.as_uri():
            browser.open(file)
        browser.wait(self.READY)

    def text(self, identifier):
        return self.browser.text(identifier)

    def click(self, identifier):
        self.browser.evaluate(f"document.getElementById('{identifier}').click()")

    def finish(self):
        self.browser.wait("/finished|stopped/.test(document.getElementById('told').textContent)")

    def in_worker(self, script):
        """Adds a script to those of the worker in which the kernels run, and starts a new worker."""
        self.browser.evaluate(f"gloam.workerText += {json.dumps(script)}; gloam.checkPage.state.runner.end()")

    def before_run(self, function, script):
        """Makes the worker run a script before the kernel of a function; it sees `passes`, `check` and `data`."""
        self.in_worker(f"""{{
            const {{run}} = gloam.kernel;
            gloam.kernel.run = (passes, program, check, data) => {{
                if (check.text.includes("gloam_kernel_result = {function}(")) {{ {script} }}
                return run(passes, program, check, data);
            }};
        }}""")

    def rows(self):
        return self.browser.evaluate("gloam.checkPage.state.rows")

    def shown(self, column):
        """The texts of a column in the rows that are not hidden."""
        return self.browser.evaluate(
            "[...document.querySelectorAll('tbody tr:not(.more)')].filter((row) => !row.hidden)"
            f".map((row) => row.cells[{column}].textContent)")


class CheckCase(SiteCase):
    """Tests of the page on the checks of EQUATIONS."""

    @classmethod
    def words(cls):
        return [*cls.EQUATIONS, "--method", "sweep", "--no-pictures"]

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.spoiled = Spoiled(cls.folder)
