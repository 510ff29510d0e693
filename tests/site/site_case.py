# SPDX-License-Identifier: MIT
"""Tests in one browser, most of them of the page that `gloam demo` has written (demo_test.py)."""
import array
import base64
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser, program

GLOAM = sys.argv[1]
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


def read_pfm(file):
    """The floats of a picture of one channel, upper row first."""
    head, size, scale, data = Path(file).read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    assert head == b"Pf" and float(scale) < 0
    values = array.array("f", data)
    return [v for y in reversed(range(height)) for v in values[y * width:(y + 1) * width]]


class BrowserCase(unittest.TestCase):
    """Tests that share a browser and a folder."""
    open_browser = Browser

    @classmethod
    def setUpClass(cls):
        owner = tempfile.TemporaryDirectory()
        cls.addClassCleanup(owner.cleanup)
        cls.folder = Path(owner.name)
        cls.browser = cls.open_browser()
        cls.addClassCleanup(cls.browser.__exit__)


class PageCase(BrowserCase):
    """Tests of the page in the folder that is the script's second argument."""
    page = Path(sys.argv[2]) / "index.html"

    def open(self):
        """Opens the page, and waits until the live effect has drawn."""
        self.browser.open(self.page)
        self.browser.wait("gloam.live.state.picture?.occlusion.frames > 1")

    def compare(self, got, want, bounds=1):
        """The G-buffers are of a rasterizer and of rays, and drivers round a depth of 16 bits or cut it, so some pixels
        may differ at all: means and percentiles are compared, of 8 bits. The filter's tolerance is near to that
        rounding."""
        self.assertEqual(len(want), len(got))
        self.assertGreater(max(want) - min(want), 0.5)
        errors = sorted(abs(a - b) for a, b in zip(got, want))
        self.assertLess(sum(errors) / len(errors), 0.002 * bounds)
        self.assertLess(errors[len(errors) // 2], 2e-5 * bounds)
        self.assertLess(errors[len(errors) * 95 // 100], 2.5 / 255 * bounds)

    def shade(self, browser, preset="balanced", frames=4, size=SIZE):
        """What the open page makes of the first frames in columns."""
        script = SHADE.format(width=size[0], height=size[1], preset=preset, frames=frames)
        return array.array("f", base64.b64decode(browser.evaluate(script)))


def skip(reason):
    print(reason)
    sys.exit(77)


def main(missing=None if program() else "no Chromium"):
    """Runs the tests of the script, which takes two arguments; skips them where what they need is missing."""
    if missing:
        skip(missing)
    unittest.main("__main__", argv=sys.argv[:1] + sys.argv[3:])
