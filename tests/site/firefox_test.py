#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""firefox_test.py GLOAM FOLDER: the page of `gloam demo` in Firefox works, and its occlusion is that of `gloam render`.

A copy of the page has one script more, which sends what it finds to this test. Left with status 77 where there is no
firefox-esr, xvfb-run or xauth: without a display Firefox has no WebGL."""
import json
import os
import shutil
import signal
import subprocess
import tempfile
import unittest
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path

from site_case import PAGE, assert_is_rendered, floats_of, main, shade_script

SECONDS = 60
# WebGL in software counts as too slow unless it is asked for. Without names of hosts nothing is sent anywhere.
PREFERENCES = """user_pref("webgl.force-enabled", true);
user_pref("webgl.disable-fail-if-major-performance-caveat", true);
user_pref("network.dns.disabled", true);
"""
SCRIPT = """
const problems = [];
addEventListener("error", ({message}) => problems.push(message));
addEventListener("unhandledrejection", ({reason}) => problems.push(String(reason)));
addEventListener("load", async () => {
    const text = (selector) => document.querySelector(selector).textContent;
    while (!/^WebGL2: .* ms from frame to frame/.test(text("#timing")) && !document.querySelector("#told.bad"))
        await new Promise((resolve) => setTimeout(resolve, 50));
    document.querySelector("#stop").click();
    const rows = document.querySelectorAll("tbody tr").length;
    const found = {told: text("#told"), stop: text("#stop"), rows, counted: text(".filter output"), problems,
        balanced: await BALANCED.catch(String), quality: await QUALITY.catch(String)};
    fetch("ADDRESS", {method: "POST", mode: "no-cors", body: JSON.stringify(found)});
});
"""


class Answer(BaseHTTPRequestHandler):
    def do_POST(self):
        self.server.answer = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        self.send_response(204)
        self.end_headers()


def found_in(folder):
    """What the script has found in a copy of the page."""
    copy = shutil.copytree(PAGE.parent, Path(folder, "page"))
    profile = Path(folder, "profile")
    profile.mkdir()
    (profile / "user.js").write_text(PREFERENCES, encoding="utf-8")
    with HTTPServer(("127.0.0.1", 0), Answer) as server:
        server.timeout, server.answer = SECONDS, None
        script = SCRIPT.replace("ADDRESS", "http://127.0.0.1:%d" % server.server_port)
        for preset in ("balanced", "quality"):
            script = script.replace(preset.upper(), shade_script(preset))
        (copy / "test.js").write_text(script, encoding="utf-8")
        page = PAGE.read_text(encoding="utf-8")
        for one, other in (("default-src 'none'", "default-src 'none'; connect-src http:"),
                           ('<script src="live.js"', '<script src="test.js"></script><script src="live.js"')):
            page = page.replace(one, other)
        (copy / PAGE.name).write_text(page, encoding="utf-8")
        with subprocess.Popen(["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", "firefox-esr", "--no-remote",
                               "--profile", profile, (copy / PAGE.name).as_uri()], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, start_new_session=True,
                              env={**os.environ, "HOME": folder, "LIBGL_ALWAYS_SOFTWARE": "1"}) as process:
            server.handle_request()
            os.killpg(process.pid, signal.SIGTERM)
        return server.answer


class FirefoxTest(unittest.TestCase):
    def test_the_page_works_and_its_occlusion_is_that_of_the_program(self):
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
            found = found_in(folder)
        self.assertIsNotNone(found, f"no answer of the page within {SECONDS} s")
        self.assertEqual(("", "Go on", []), (found["told"], found["stop"], found["problems"]))
        self.assertEqual(f"{found['rows']} of {found['rows']} rows", found["counted"])
        for preset in ("balanced", "quality"):
            with self.subTest(preset):
                assert_is_rendered(self, floats_of(found[preset]), preset)


if __name__ == "__main__":
    main(None if all(map(shutil.which, ("firefox-esr", "xvfb-run", "xauth"))) else "no firefox-esr, xvfb-run or xauth")
