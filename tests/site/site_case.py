# SPDX-License-Identifier: MIT
"""Tests of a site that `gloam site` writes once for all of them, in one browser."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser

GLOAM = sys.argv[1]

# Renders the first frames of the path on the first page, and gives what `read` reads of the last one as base64.
SHADE = """(async () => {{
    const {{effect}} = gloam.live.state;
    gloam.live.state.failed = true;  // ends the page's own loop
    effect.setSize({width}, {height});
    effect.setMethod(await gloam.method("{method}", effect.api), "{preset}", effect.scene.radius);
    for (let i = 0; i < {frames}; ++i) effect.frame(gloam.camera.at(effect.scene.cameras, {moves} ? i : 0));
    const bytes = new Uint8Array((await effect.{read}()).buffer);
    let text = "";
    for (const byte of bytes) text += String.fromCharCode(byte);
    return btoa(text);
}})()"""


class SiteCase(unittest.TestCase):
    open_browser = Browser

    @classmethod
    def words(cls):
        """What `gloam site` takes behind the folder and the one equation."""
        return ["--method", "sweep", "--no-pictures"]

    @classmethod
    def setUpClass(cls):
        owner = tempfile.TemporaryDirectory()
        cls.addClassCleanup(owner.cleanup)
        cls.folder = Path(owner.name)
        cls.site = cls.folder / "site"
        subprocess.run([GLOAM, "site", cls.site, "TSSAO-5", "--quiet", *cls.words()], check=True)
        cls.browser = cls.open_browser()
        cls.addClassCleanup(cls.browser.__exit__)
