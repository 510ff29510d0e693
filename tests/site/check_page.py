# SPDX-License-Identifier: MIT
"""The page of the site that checks the browser."""
import json


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

    def before_run(self, function, script):
        """Makes a new worker run a script before the kernel of a function; it sees `passes`, `check` and `data`."""
        script = f"""{{
            const {{run}} = gloam.kernel;
            gloam.kernel.run = (passes, program, check, data) => {{
                if (check.text.includes("gloam_kernel_result = {function}(")) {{ {script} }}
                return run(passes, program, check, data);
            }};
        }}"""
        self.browser.evaluate(f"gloam.workerText += {json.dumps(script)}; gloam.checkPage.state.runner.end()")

    def rows(self):
        return self.browser.evaluate("gloam.checkPage.state.rows")

    def shown(self, column):
        """The texts of a column in the rows that are not hidden."""
        return self.browser.evaluate(
            "[...document.querySelectorAll('tbody tr')].filter((row) => !row.hidden)"
            f".map((row) => row.cells[{column}].textContent)")
