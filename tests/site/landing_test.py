#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""landing_test.py GLOAM: the first page of the site in headless Chromium: what it loads, its camera, its address.

Left with status 77 where there is no Chromium."""
import json
import subprocess
import tempfile
from pathlib import Path
from urllib.parse import unquote, urlparse

from site_case import GLOAM, SiteCase, main

MOST_BYTES = 300_000  # of files, without compression, before the first interaction
NUMBERS = "gloam.live.state.orbit.numbers"
SMALL = "#size=320x180"


class LandingTest(SiteCase):
    @classmethod
    def words(cls):
        return ["TSSAO-5", "--method", "sweep", "gtao", "--address", "https://example.org/gloam/", "--no-pictures"]

    def open(self, behind=SMALL):
        self.browser.look(1000, 900)
        self.browser.open(self.site / "index.html", behind)
        self.browser.wait("gloam.live.state.effect?.frames > 1")

    def middle(self):
        return self.browser.evaluate("(({left, top, width, height}) => [left + width / 2, top + height / 2])"
                                     "(document.getElementById('canvas').getBoundingClientRect())")

    def numbers(self):
        """Yaw, pitch, distance and target of the camera that the person has taken."""
        self.browser.wait("gloam.live.state.turned")
        return self.browser.evaluate(NUMBERS)

    def test_it_loads_little_before_the_first_interaction(self):
        already = len(self.browser.requests())
        self.open("")
        asked = self.browser.requests()[already:]
        files = {Path(unquote(urlparse(url).path)) for url in asked if url.startswith("file:")}
        self.assertIn(self.site / "scene-room.js", files)
        self.assertIn(self.site / "method-sweep.js", files)
        self.assertEqual([], [url for url in asked if not url.startswith(("file:", "data:", "about:"))])
        self.assertLessEqual(sum(file.stat().st_size for file in files), MOST_BYTES,
                             {file.name: file.stat().st_size for file in files})

    def test_the_mouse_turns_moves_and_zooms(self):
        self.open()
        x, y = self.middle()
        self.browser.mouse((x, y), (x + 40, y), (x + 80, y + 20))
        turned = self.numbers()
        self.assertFalse(self.browser.evaluate("document.getElementById('moves').checked"))
        self.browser.mouse((x, y), (x + 40, y), (x + 80, y), modifiers=8)
        moved = self.numbers()
        self.assertEqual(turned[:3], moved[:3])
        self.assertGreater(max(abs(a - b) for a, b in zip(turned[3:], moved[3:])), 0.01)
        self.browser.mouse((x, y), (x + 30, y))
        again = self.numbers()
        self.assertLess(again[0], moved[0])
        self.assertEqual(moved[3:], again[3:])
        self.browser.wheel(x, y, -120)  # the press has given the picture the focus
        self.browser.wait(f"{NUMBERS}[2] < {again[2]}")

    def test_the_wheel_scrolls_the_page_until_the_picture_has_the_focus(self):
        self.open()
        self.browser.look(1000, 400)
        self.browser.wheel(*self.middle(), 100)
        self.browser.wait("scrollY > 0")
        self.assertFalse(self.browser.evaluate("gloam.live.state.turned"))

    def test_the_keys_turn_move_and_zoom(self):
        self.open()
        self.browser.evaluate("document.getElementById('canvas').focus()")
        self.browser.key("ArrowRight", until="gloam.live.state.turned")
        first = self.numbers()
        self.browser.key("ArrowUp", until=f"{NUMBERS}[1] > {first[1]}")
        self.browser.key("ArrowRight", until=f"{NUMBERS}[0] > {first[0]}")
        self.browser.key("Minus", until=f"{NUMBERS}[2] > {first[2]}")
        before = self.numbers()
        self.browser.key("ArrowRight", until=f"{NUMBERS}[3] !== {before[3]}", modifiers=8)
        self.assertEqual(before[:3], self.numbers()[:3])

    def test_two_fingers_zoom(self):
        self.open()
        x, y = self.middle()
        self.browser.touch([(x - 20, y), (x + 20, y)], [(x - 25, y), (x + 25, y)])
        before = self.numbers()
        self.browser.touch([(x - 20, y), (x + 20, y)], [(x - 25, y), (x + 25, y)], [(x - 30, y), (x + 30, y)])
        self.assertAlmostEqual(before[2] * 20 / 30, self.numbers()[2], 4)

    def test_a_camera_that_is_taken_goes_on_from_where_it_was(self):
        self.open()
        difference = self.browser.evaluate("""(() => {
            const {effect, orbit, number} = gloam.live.state;
            const path = gloam.camera.at(effect.scene.cameras, number);
            orbit.take(path);
            const all = (camera) => [...camera.rotation, ...camera.eye];
            return Math.max(...all(orbit.camera).map((x, i) => Math.abs(x - all(path)[i])));
        })()""")
        self.assertLess(difference, 1e-12)

    def test_the_address_holds_the_state(self):
        asked = ("#scene=knot&preset=quality&method=gtao&radius=2&view=visibility&size=320x180&left=hbao&split=25"
                 "&camera=0.5,0.25,3,0,0.5,0")
        self.open(asked)
        self.assertEqual("", self.browser.text("told"))
        settings = self.browser.evaluate("gloam.live.state.effect.settings")
        self.assertEqual(("gtao", 24), (settings["method"], settings["samples"]))
        self.assertEqual("hbao", self.browser.evaluate("gloam.live.state.effect.left.settings.method"))
        self.assertEqual([0.5, 0.25, 3, 0, 0.5, 0], self.numbers())
        self.assertEqual(asked, self.browser.evaluate("location.hash"))
        self.browser.evaluate("document.getElementById('view').value = 'normals'")
        self.browser.wait("location.hash.includes('view=normals')")
        self.browser.evaluate("location.hash = '#scene=room&size=320x180&view=lit'")
        self.browser.wait("gloam.live.state.effect.scene.name === 'room' && !gloam.live.state.turned")

    def test_what_the_address_cannot_have_is_told_and_left_out(self):
        self.open()
        for part, words in (("scene=../secret", 'scene the value "../secret"'), ("radius=1e9", "radius the value"),
                            ("left=truth", "left the value"),
                            ("camera=1,2,3", "camera the value"),
                            ("__proto__=1", '"__proto__", which is unknown'), ("camera=NaN,0,1,0,0,0", "camera the"),
                            ("x=" + "9" * 500, "more than 400 characters")):
            with self.subTest(part=part[:30]):
                self.browser.evaluate(f"location.hash = {json.dumps(SMALL + '&' + part)}")
                self.browser.wait(f"document.getElementById('told').textContent.includes({json.dumps(words)})")
                self.assertEqual("room", self.browser.evaluate("gloam.live.state.effect.scene.name"))
        self.open(f"{SMALL}&radius=7")
        self.assertIn("radius the value", self.browser.text("told"))
        self.assertEqual([], self.browser.problems())

    def test_nothing_moves_for_who_wants_no_motion(self):
        self.browser.call("Emulation.setEmulatedMedia",
                          features=[{"name": "prefers-reduced-motion", "value": "reduce"}])
        self.browser.open(self.site / "index.html", SMALL)
        self.browser.wait("gloam.live.state.effect?.frames > 3")
        self.assertEqual((False, 0), (self.browser.evaluate("document.getElementById('moves').checked"),
                                      self.browser.evaluate("gloam.live.state.number")))

    def test_the_source_text_stands_beside_the_picture(self):
        self.open()
        self.browser.evaluate("document.getElementById('source').open = true")
        self.browser.wait("document.querySelector('.source').textContent.includes('gloam_sweep')")
        languages = self.browser.evaluate("[...document.querySelector('#source select').options].map((o) => o.value)")
        self.assertEqual(["GLSL 3.30", "GLSL 4.50", "GLSL ES 3.00", "HLSL", "MSL"], languages)
        for language, words in (("HLSL", "gloam_sweep("), ("GLSL ES 3.00", "#version 300 es")):
            self.browser.evaluate(f"document.querySelector('#source select').value = '{language}';"
                                  "document.querySelector('#source select').dispatchEvent(new Event('change'))")
            self.assertIn(words, self.browser.evaluate("document.querySelector('.source').textContent"))
        self.browser.call("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
        self.browser.evaluate("document.querySelector('#source button').click()")
        self.browser.wait("document.querySelector('#source [role=status]').textContent === 'copied'")
        copied = self.browser.evaluate("navigator.clipboard.readText()")
        self.assertEqual(copied, self.browser.evaluate("document.querySelector('.source').textContent"))

    def test_the_size_follows_the_speed_where_none_is_chosen(self):
        self.open("")
        width = "document.getElementById('canvas').width"
        self.assertEqual(480, self.browser.evaluate(width))  # SwiftShader is not smooth
        self.browser.evaluate("Object.defineProperty(gloam.live.state, 'ms', {get: () => 10, set() {}});"
                              "gloam.live.state.times = Array(31).fill(performance.now())")
        self.browser.wait(f"{width} === 960")
        self.browser.evaluate("document.getElementById('size').value = '320x180';"
                              "document.getElementById('size').dispatchEvent(new Event('change'))")
        self.browser.wait(f"{width} === 320")

    def test_the_commands_of_the_doors_run(self):
        self.open()
        commands = self.browser.evaluate("[...document.querySelectorAll('pre.command')].map((one) => one.textContent)")
        self.assertEqual(3, len(commands))
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "luminance.glsl").write_text(self.browser.text("luminance"), encoding="utf-8")
            for command in commands:
                name, *words = command.split()
                self.assertEqual("gloam", name)
                done = subprocess.run([GLOAM, *words], check=True, capture_output=True, text=True, cwd=folder)
                self.assertIn("gloam_sweep" if "pack" in words else " 0 failed", done.stdout)

    def test_previews_have_the_address_of_the_site(self):
        text = (self.site / "methods.html").read_text(encoding="utf-8")
        self.assertIn('<meta property="og:url" content="https://example.org/gloam/methods.html">', text)
        self.assertIn('<meta property="og:title" content="gloam: methods', text)

    def test_wrong_options_write_nothing(self):
        for option, value, words in (("--address", "example.org", '"example.org": expected an address like'),
                                     ("--method", "no_such", 'no_such')):
            wrong = subprocess.run([GLOAM, "site", self.site.parent / "wrong", option, value, "--no-pictures"],
                                   check=False, capture_output=True, text=True)
            self.assertNotEqual(0, wrong.returncode)
            self.assertIn(words, wrong.stderr)
            self.assertFalse((self.site.parent / "wrong").exists())


if __name__ == "__main__":
    main()
