#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""effect_test.py GLOAM FOLDER: the live effect on the page of `gloam demo` in headless Chromium. Its occlusion is that
of `gloam render`, and what a person does with the picture and the controls has an effect.

Left with status 77 where there is no Chromium."""
from pathlib import Path
from urllib.parse import unquote, urlparse

from site_case import SIZE, PageCase, assert_is_rendered, floats_of, main, shade_script

MOST_BYTES = 600_000  # of scripts, without compression, before the first interaction
POSE = "gloam.live.state.orbit.pose"


class EffectTest(PageCase):
    def setUp(self):
        self.browser.look(390, 844)
        self.browser.call("Emulation.setEmulatedMedia", features=[])
        self.open()

    def test_the_occlusion_is_that_of_the_program(self):
        for preset, frames, size in (("balanced", 4, SIZE), ("quality", 9, SIZE), ("reference", 2, SIZE),
                                     ("fast", 4, (161, 99))):
            with self.subTest(preset=preset, size=size):
                shown = self.ask(shade_script(preset, frames, size))
                assert_is_rendered(self, floats_of(shown), preset, frames, size)

    def choose(self, **choices):
        """Sets controls by their identifiers, as a person does, and waits for the next frame."""
        for identifier, value in choices.items():
            self.ask(f"""$('#{identifier}').value = '{value}';
                ['input', 'change'].forEach((name) => $('#{identifier}').dispatchEvent(new Event(name)))""")
        told = self.browser.text("timing")
        self.browser.wait(f"$('#timing').textContent !== '{told}' || $('#told').textContent !== ''")

    def test_the_controls_choose(self):
        names = "[...$('#preset').options].map((one) => one.textContent)"
        self.assertEqual(["fast", "balanced", "quality", "reference"], self.ask(names))
        self.choose(preset="quality", radius=2)
        effect = "gloam.live.state.picture.occlusion"
        self.assertEqual(("quality", 8), tuple(self.ask(f"[{effect}.preset.name, {effect}.preset.steps]")))
        self.assertAlmostEqual(0.6, self.ask(f"{effect}.radius"), 6)
        self.choose(scene="knot")
        self.browser.wait("gloam.live.state.picture.scene.name === 'knot'")
        self.ask("$('#moves').click()")
        before = self.ask("gloam.live.state.number")
        self.choose(show="without")
        self.assertEqual(before, self.ask("gloam.live.state.number"))
        self.assertRegex(self.browser.text("timing"), "^WebGL2: .* ms from frame to frame")
        self.assertEqual([], self.browser.problems())

    def test_stop_stands_and_shows_what_is_chosen(self):
        numbers = "[gloam.live.state.number, gloam.live.state.picture.occlusion.frames]"
        self.ask("$('#stop').click()")
        self.assertEqual("Go on", self.browser.text("stop"))
        before, frames = self.ask(numbers)
        pictures = set()
        for shown in ("with occlusion", "without", "the occlusion alone"):
            self.ask(f"$('#show').value = '{shown}'; $('#show').dispatchEvent(new Event('input', {{bubbles: true}}))")
            self.browser.wait("!gloam.live.state.changed")
            pictures.add(self.ask(f"gloam.live.state.picture.show({len(pictures)}); $('#canvas').toDataURL()"))
        self.assertEqual(3, len(pictures))
        self.browser.wait("new Promise((resolve) => setTimeout(() => resolve(true), 300))")
        self.assertEqual([before, frames + 3], self.ask(numbers))
        self.ask("$('#stop').click()")
        self.assertEqual("Stop", self.browser.text("stop"))
        self.browser.wait(f"gloam.live.state.picture.occlusion.frames > {frames + 5}")

    def test_the_keyboard_is_enough_to_stop(self):
        self.ask("$('#scene').focus()")
        while self.ask("document.activeElement.id") != "stop":
            self.browser.key("Tab")
            self.assertTrue(self.ask("document.activeElement.matches('#controls *')"))
            self.assertRegex(self.ask("getComputedStyle(document.activeElement).outline"), "solid 2px")
        self.browser.key("Space")
        self.assertEqual("Go on", self.browser.text("stop"))

    def test_a_shader_that_does_not_compile_is_told(self):
        self.ask("gloam.effect.filter_of_tiles += 'no_such;'")
        self.choose(preset="quality")
        self.assertIn("filter_of_tiles does not compile", self.browser.text("told"))

    def test_it_loads_little_before_the_first_interaction(self):
        already = len(self.browser.requests())
        self.open()
        asked = self.browser.requests()[already:]
        files = {Path(unquote(urlparse(url).path)) for url in asked if url.startswith("file:") and url.endswith(".js")}
        self.assertEqual({"live.js", "scene-room.js"}, {file.name for file in files})
        self.assertEqual([], [url for url in asked if not url.startswith(("file:", "data:", "about:"))])
        self.assertLessEqual(sum(file.stat().st_size for file in files), MOST_BYTES,
                             {file.name: file.stat().st_size for file in files})

    def middle(self):
        """The point of the window where the middle of the picture is, once the page is scrolled there."""
        self.ask("$('#canvas').scrollIntoView({block: 'center'})")
        return self.ask("(({left, top, width, height}) => [left + width / 2, top + height / 2])"
                        "($('#canvas').getBoundingClientRect())")

    def test_mouse_and_keys_turn_and_zoom(self):
        x, y = self.middle()
        self.browser.mouse((x, y), (x + 40, y), (x + 80, y + 20))
        self.browser.wait(f"{POSE} !== null")
        self.assertFalse(self.ask("$('#moves').checked"))
        # The press has given the picture the focus.
        for act, member, sign in ((lambda: self.browser.mouse((x, y), (x + 30, y)), "yaw", "<"),
                                  (lambda: self.browser.mouse((x, y), (x, y + 30)), "pitch", ">"),
                                  (lambda: self.browser.wheel(x, y, -120), "distance", "<"),
                                  (lambda: self.browser.key("ArrowRight"), "yaw", ">"),
                                  (lambda: self.browser.key("ArrowUp"), "pitch", ">"),
                                  (lambda: self.browser.key("Minus"), "distance", ">")):
            before = self.ask(POSE)
            act()
            self.browser.wait(f"{POSE}.{member} {sign} {before[member]}")
            for other in {"yaw", "pitch", "distance"} - {member}:
                self.assertEqual(before[other], self.ask(f"{POSE}.{other}"))

    def test_a_camera_that_is_taken_goes_on_from_where_it_was(self):
        difference = self.ask("""(() => {
            const {scene, orbit, number} = gloam.live.state;
            orbit.change(0, 0);
            const path = gloam.cameraAt(scene, number);
            return Math.max(...orbit.camera.eye.map((x, i) => Math.abs(x - path.eye[i])));
        })()""")
        self.assertLess(difference, 1e-12)

    def test_the_wheel_scrolls_the_page_until_the_picture_has_the_focus(self):
        self.browser.look(1000, 400)
        x, y = self.middle()
        before = self.ask("scrollY")
        self.browser.wheel(x, y, 100)
        self.browser.wait(f"scrollY > {before}")
        self.assertIsNone(self.ask(POSE))

    def test_nothing_moves_for_who_wants_no_motion(self):
        self.browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-reduced-motion", "value": "reduce"}])
        self.open()
        self.assertEqual([False, 0], self.ask("[$('#moves').checked, gloam.live.state.number]"))


if __name__ == "__main__":
    main()
