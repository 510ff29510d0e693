# SPDX-License-Identifier: MIT
"""Tests in one browser, most of them of the page that `gloam demo` has written (demo_test.py)."""
import array
import base64
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser, program

GLOAM = sys.argv[1]
PAGE = Path(sys.argv[2]) / "index.html"
SIZE = (192, 108)

# Renders the first frames of the path in columns, and gives the occlusion of the last one as base64.
SHADE = """(async () => {{
    gloam.live.state.failed = true;  // ends the page's own loop
    const picture = new gloam.Picture(new OffscreenCanvas(1, 1), {width}, {height});
    const scene = await gloam.scene("columns");
    picture.set(scene, "{preset}", scene.radius);
    for (let i = 0; i < {frames}; ++i) picture.frame(gloam.cameraAt(scene, i));
    const bytes = new Uint8Array(picture.occlusion.readShown().buffer);
    picture.passes.gl.getExtension("WEBGL_lose_context").loseContext();
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
}})()"""


def shade_script(preset, frames=4, size=SIZE):
    """What the page makes of the first frames in columns."""
    return SHADE.format(width=size[0], height=size[1], preset=preset, frames=frames)


def floats_of(text):
    return array.array("f", base64.b64decode(text))


def read_pfm(file):
    """The floats of a picture of one channel, upper row first."""
    head, size, scale, data = Path(file).read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    assert head == b"Pf" and float(scale) < 0
    values = array.array("f", data)
    return [v for y in reversed(range(height)) for v in values[y * width:(y + 1) * width]]


def assert_is_rendered(test, got, preset, frames=4, size=SIZE):
    """That the occlusion is what `gloam render` makes of these frames. The G-buffers are of a rasterizer and of rays,
    and drivers round a depth of 16 bits or cut it, so some pixels may differ at all: means and percentiles are
    compared, of 8 bits. The filter's tolerance is near to that rounding."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([GLOAM, "render", "columns", "--size", "{}x{}".format(*size), "--frames", str(frames),
                        "--preset", preset, "--out", folder, "--quiet"], check=True)
        want = read_pfm(f"{folder}/f{frames - 1:04}_ao.pfm")
    test.assertEqual(len(want), len(got))
    test.assertGreater(max(want) - min(want), 0.5)
    errors = sorted(abs(a - b) for a, b in zip(got, want))
    test.assertLess(sum(errors) / len(errors), 0.002)
    test.assertLess(errors[len(errors) // 2], 2e-5)
    test.assertLess(errors[len(errors) * 95 // 100], 2.5 / 255)


class BrowserCase(unittest.TestCase):
    """Tests that share a browser."""

    @classmethod
    def setUpClass(cls):
        cls.browser = cls.enterClassContext(Browser())

    def ask(self, script):
        return self.browser.evaluate(script)


class PageCase(BrowserCase):
    def open(self):
        """Opens the page, and waits until the live effect has drawn."""
        self.browser.open(PAGE)
        self.browser.wait("gloam.live.state.picture?.occlusion.frames > 1")


def skip(reason):
    print(reason)
    sys.exit(77)


UNREACHABLE = ("EAI_AGAIN", "ECONNREFUSED", "ECONNRESET", "ENETUNREACH", "ENOTFOUND", "ETIMEDOUT", "EHOSTUNREACH",
               "E429", "E500", "E502", "E503", "E504")  # the last are answers of a registry that is not well


def install(folder, *packages):
    """Installs packages of npm, and those that package.json in the folder names. Skips the tests where there is no npm,
    or its registry is not within reach."""
    if shutil.which("npm") is None:
        skip("no npm")
    command = ["npm", "install", "--no-audit", "--no-fund", "--no-package-lock", "--fetch-retries=0",
               "--fetch-timeout=20000", "--prefix", folder, *packages]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode != 0 and any(word in done.stderr for word in UNREACHABLE):
        skip("npm reaches no registry")
    if done.returncode != 0:
        raise RuntimeError(done.stderr)


def main(missing=None if program() else "no Chromium"):
    """Runs the tests of the script, which takes two arguments; skips them where what they need is missing."""
    if missing:
        skip(missing)
    unittest.main("__main__", argv=sys.argv[:1] + sys.argv[3:])
