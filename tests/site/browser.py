# SPDX-License-Identifier: MIT
"""Headless Chromium over SwiftShader, driven through its own protocol on a pipe. It needs no package of Python."""
import json
import os
import select
import shutil
import signal
import subprocess
import tempfile
import time
from pathlib import Path


class BrowserError(Exception):
    """The browser did not do what was asked, or the page threw."""


def program():
    """The path of Chromium, or None."""
    return shutil.which("chromium")


FLAGS = ["--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--ignore-gpu-blocklist", "--no-first-run", "--disable-extensions", "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--host-resolver-rules=MAP * ~NOTFOUND",
         "--remote-debugging-pipe", "about:blank"]


# The code that Windows has for each key, and its text.
KEYS = {"Tab": (9, None), "Space": (32, " "), "ArrowRight": (39, None), "ArrowUp": (38, None), "Minus": (189, "-")}


class Browser:
    """One browser with one page. Use it in a `with` statement."""

    def __init__(self, timeout=60):
        self.timeout = timeout
        self.folder = tempfile.mkdtemp(prefix="gloam-browser-")
        to_read, self.to_browser = os.pipe()
        self.from_browser, to_write = os.pipe()
        self.process = subprocess.Popen(
            ["sh", "-c", f'exec "$0" "$@" 3<&{to_read} 4>&{to_write}', program(),
             f"--user-data-dir={self.folder}", *FLAGS],
            pass_fds=(to_read, to_write), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            start_new_session=True)
        os.close(to_read)
        os.close(to_write)
        self.buffer = b""
        self.number = 0
        self.session = None
        self.events = []
        self._attach()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.call("Browser.close")
            self.process.wait(5)
        except (BrowserError, subprocess.TimeoutExpired, OSError):
            os.killpg(self.process.pid, signal.SIGKILL)
            self.process.wait()
        os.close(self.to_browser)
        os.close(self.from_browser)
        shutil.rmtree(self.folder, ignore_errors=True)

    def _attach(self):
        pages = self.call("Target.getTargets")["targetInfos"]
        page = next(target for target in pages if target["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=page["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")

    def _message(self, deadline):
        while b"\0" not in self.buffer:
            left = deadline - time.monotonic()
            if left <= 0 or not select.select([self.from_browser], [], [], left)[0]:
                raise BrowserError(f"no answer of the browser within {self.timeout} s")
            chunk = os.read(self.from_browser, 1 << 16)
            if not chunk:
                raise BrowserError("the browser ended")
            self.buffer += chunk
        text, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, **parameters):
        """Calls a method of the protocol and returns its result."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session and not method.startswith("Target."):
            message["sessionId"] = self.session
        os.write(self.to_browser, json.dumps(message).encode() + b"\0")
        deadline = time.monotonic() + self.timeout
        while True:
            answer = self._message(deadline)
            if answer.get("id") != self.number:
                self.events.append(answer)
                continue
            if "error" in answer:
                raise BrowserError(f"{method}: {answer['error']['message']}")
            return answer["result"]

    def open(self, file, fragment=""):
        """Opens a file and waits until its scripts have run."""
        self.call("Page.navigate", url="about:blank")
        self.call("Page.navigate", url=Path(file).resolve().as_uri() + fragment)
        self.wait("document.readyState === 'complete' && location.protocol === 'file:'")

    def evaluate(self, script):
        """The value of an expression in the page; a promise is awaited. $() and $$() find one element, and all."""
        answer = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True,
                           includeCommandLineAPI=True)
        if "exceptionDetails" in answer:
            details = answer["exceptionDetails"]
            raise BrowserError(details.get("exception", {}).get("description", details["text"]))
        return answer["result"].get("value")

    def wait(self, condition):
        """Waits until an expression in the page is true."""
        deadline = time.monotonic() + self.timeout
        while not self.evaluate(condition):
            if time.monotonic() > deadline:
                raise BrowserError(f"after {self.timeout} s still not: {condition}")
            time.sleep(0.05)

    def text(self, identifier):
        return self.evaluate(f"$('#{identifier}').textContent")

    def key(self, name):
        """Presses a key: one of KEYS."""
        code, text = KEYS[name]
        press = {"key": text or name, "code": name, "windowsVirtualKeyCode": code}
        self.call("Input.dispatchKeyEvent", type="keyDown", **press, **({"text": text} if text else {}))
        self.call("Input.dispatchKeyEvent", type="keyUp", **press)

    def mouse(self, *steps):
        """Moves the mouse through points of the window, with its button down from the first on."""
        kinds = ["mousePressed", *["mouseMoved"] * (len(steps) - 1)]
        for kind, (x, y) in [*zip(kinds, steps), ("mouseReleased", steps[-1])]:
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1,
                      buttons=0 if kind == "mouseReleased" else 1)

    def wheel(self, x, y, delta):
        self.call("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=delta)

    def problems(self):
        """Exceptions and errors that the pages have reported so far."""
        self.evaluate("0")
        events = [(event.get("method"), event.get("params", {})) for event in self.events]
        return [json.dumps(parameters)[:500] for method, parameters in events
                if method == "Runtime.exceptionThrown"
                or method == "Log.entryAdded" and parameters["entry"]["level"] == "error"
                or method == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "assert")]

    def requests(self):
        """The addresses that the pages have asked for so far."""
        self.evaluate("0")
        return [event["params"]["request"]["url"] for event in self.events
                if event.get("method") == "Network.requestWillBeSent"]

    def look(self, width, height, dark=False):
        """Sets the size of the window and its colours."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                  mobile=width < 600)
        self.call("Emulation.setEmulatedMedia",
                  features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
