# SPDX-License-Identifier: MIT
"""Tests in one browser, most of them of a site that `gloam site` writes once for all of them."""
import array
import base64
import subprocess
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
    const bytes = new Uint8Array(picture.occlusion.readOcclusion().buffer);
    picture.passes.gl.getExtension("WEBGL_lose_context").loseContext();
    return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
}})()"""


def read_pfm(file):
    """The floats of a picture, upper row first, and its channels."""
    head, size, scale, data = Path(file).read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    assert float(scale) < 0
    channels = 3 if head == b"PF" else 1
    values = array.array("f", data)
    row = width * channels
    return [v for y in reversed(range(height)) for v in values[y * row:(y + 1) * row]], channels


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


class SiteCase(BrowserCase):
    @classmethod
    def words(cls):
        """What `gloam site` takes behind the folder."""
        return ["TSSAO-5", "--method", "sweep", "--no-pictures"]

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.site = cls.folder / "site"
        subprocess.run([GLOAM, "site", cls.site, "--quiet", *cls.words()], check=True)

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

    def shade(self, page, preset="balanced", frames=4, size=SIZE):
        """What a page of the site makes of the first frames in columns."""
        script = SHADE.format(width=size[0], height=size[1], preset=preset, frames=frames)
        return array.array("f", base64.b64decode(page.evaluate(script)))


def skip(reason):
    print(reason)
    sys.exit(77)


def main(arguments=1, missing=None):
    """Runs the tests of the script, which takes so many arguments; skips them where what they need is missing."""
    missing = missing or (None if program() else "no Chromium")
    if missing:
        skip(missing)
    unittest.main("__main__", argv=sys.argv[:1] + sys.argv[1 + arguments:])
