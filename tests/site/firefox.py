# SPDX-License-Identifier: MIT
"""Firefox in Xvfb, driven through Marionette, its own protocol: without a display it has no WebGL. It needs no package
of Python."""
import json
import os
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from pathlib import Path

from browser import BrowserError, Page

# WebGL in software counts as too slow unless it is asked for; nothing is sent anywhere.
PREFERENCES = {
    "marionette.port": 0, "webgl.force-enabled": True, "webgl.disable-fail-if-major-performance-caveat": True,
    "app.update.enabled": False, "browser.shell.checkDefaultBrowser": False, "browser.startup.page": 0,
    "datareporting.policy.dataSubmissionEnabled": False, "toolkit.telemetry.enabled": False,
    "network.captive-portal-service.enabled": False, "network.connectivity-service.enabled": False,
    "services.settings.server": "data:,#remote-settings-dummy/v1", "browser.safebrowsing.update.enabled": False,
    "extensions.getAddons.cache.enabled": False}
# What scripts of pages have thrown, and what Firefox says of their files.
PROBLEMS = """return Services.console.getMessageArray().filter((one) => one instanceof Ci.nsIScriptError
    && one.sourceName.startsWith("file:") && !(one.flags & Ci.nsIScriptError.warningFlag)).map(String)"""


def program():
    """The path of Firefox, or None where it or Xvfb is missing."""
    return shutil.which("firefox-esr") if shutil.which("Xvfb") else None


class Firefox(Page):
    """One browser with one page. Use it in a `with` statement."""

    def __init__(self, timeout=90):
        self.timeout = timeout
        self.profile = tempfile.mkdtemp(prefix="gloam-firefox-")
        lines = [f"user_pref({json.dumps(name)}, {json.dumps(value)});" for name, value in PREFERENCES.items()]
        Path(self.profile, "user.js").write_text("\n".join(lines) + "\n", encoding="utf-8")
        self.number = 0
        self.socket = None
        self.processes = []
        try:
            display = self._screen()
            self._run([program(), "--marionette", "--remote-allow-system-access", "--no-remote", "--profile",
                       self.profile], env={**os.environ, "HOME": self.profile, "DISPLAY": display,
                                           "LIBGL_ALWAYS_SOFTWARE": "1"})
            self._connect()
        except BaseException:
            self.__exit__()
            raise

    def __exit__(self, *_):
        if self.socket:
            self.socket.close()
        for process in reversed(self.processes):
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
        shutil.rmtree(self.profile, ignore_errors=True)

    def _run(self, command, **options):
        self.processes.append(subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                               start_new_session=True, **options))

    def _screen(self):
        """Starts a display that nobody sees, and gives its name."""
        to_read, to_write = os.pipe()
        self._run(["Xvfb", "-displayfd", str(to_write), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"],
                  pass_fds=[to_write])
        os.close(to_write)
        with os.fdopen(to_read) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise BrowserError("Xvfb has opened no display")
        return ":" + number

    def _connect(self):
        file = Path(self.profile, "MarionetteActivePort")
        deadline = time.monotonic() + self.timeout
        while not (file.is_file() and file.read_text(encoding="ascii").strip()):
            if time.monotonic() > deadline or self.processes[-1].poll() is not None:
                raise BrowserError("Firefox has opened no port")
            time.sleep(0.05)
        self.socket = socket.create_connection(("127.0.0.1", int(file.read_text(encoding="ascii"))), self.timeout)
        self._message()  # its greeting
        self.call("WebDriver:NewSession", {"pageLoadStrategy": "normal"})
        self.call("WebDriver:SetTimeouts", {"script": 1000 * self.timeout})

    def _message(self):
        head = b""
        while not head.endswith(b":"):
            head += self._bytes(1)
        return json.loads(self._bytes(int(head[:-1])))

    def _bytes(self, count):
        data = b""
        while len(data) < count:
            part = self.socket.recv(count - len(data))
            if not part:
                raise BrowserError("Firefox ended")
            data += part
        return data

    def call(self, command, parameters=None):
        self.number += 1
        text = json.dumps([0, self.number, command, parameters or {}]).encode()
        self.socket.sendall(b"%d:" % len(text) + text)
        _, _, error, result = self._message()
        if error:
            raise BrowserError(f"{command}: {error.get('message')}")
        return result

    def open(self, file):
        self.call("WebDriver:Navigate", {"url": Path(file).resolve().as_uri()})

    def evaluate(self, script):
        """The value of an expression in the page; a promise is awaited."""
        text = (f"const done = arguments[arguments.length - 1]; (async () => ({script}))()"
                ".then((value) => done([true, value ?? null]), (error) => done([false, String(error)]))")
        asked = {"script": text, "args": [], "sandbox": None}
        fine, value = self.call("WebDriver:ExecuteAsyncScript", asked)["value"]
        if not fine:
            raise BrowserError(value)
        return value

    def problems(self):
        """Errors of the pages' scripts so far."""
        self.call("Marionette:SetContext", {"value": "chrome"})
        found = self.call("WebDriver:ExecuteScript", {"script": PROBLEMS, "args": []})["value"]
        self.call("Marionette:SetContext", {"value": "content"})
        return found
