#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""effect_test.py GLOAM: the effect of the site in headless Chromium. Its occlusion is that of `gloam render`, and what
the controls choose has an effect.

Left with status 77 where there is no Chromium."""
import array
import base64
import subprocess
import tempfile
from pathlib import Path

from site_case import GLOAM, SHADE, SiteCase, main, read_pfm

WIDTH, HEIGHT, FRAMES = 192, 108, 4


class EffectTest(SiteCase):
    def setUp(self):
        self.browser.look(1000, 900)
        self.browser.open(self.site / "index.html", "#scene=columns&method=gtao&size=320x180")
        self.browser.wait("gloam.live.state.effect?.frames > 0")

    def rendered(self, read, method, preset="balanced", frames=FRAMES, moves=True, size=(WIDTH, HEIGHT)):
        script = SHADE.format(width=size[0], height=size[1], method=method, preset=preset, frames=frames,
                              moves="true" if moves else "false", read=read)
        return array.array("f", base64.b64decode(self.browser.evaluate(script)))

    def history(self, *arguments, **choices):
        return self.rendered("read", *arguments, **choices)

    def native(self, method, *options, preset="balanced", frames=FRAMES, size=(WIDTH, HEIGHT)):
        with tempfile.TemporaryDirectory(dir=self.folder) as out:
            subprocess.run([GLOAM, "render", "columns", "--size", "{}x{}".format(*size), "--frames", str(frames),
                            "--method", method, "--preset", preset, "--set", "precision=float32", *options, "--out",
                            out, "--quiet"], check=True)
            return read_pfm(Path(out) / f"f{frames - 1:04}_ao.pfm")[0]

    def compare(self, got, want):
        """The G-buffers are of two rasterizers, so pixels at edges may differ at all: means and percentiles are
        compared."""
        self.assertEqual(len(want), len(got))
        self.assertGreater(max(want) - min(want), 0.5)
        errors = sorted(abs(a - b) for a, b in zip(got, want))
        self.assertLess(sum(errors) / len(errors), 0.0015)
        self.assertLess(errors[len(errors) // 2], 2e-5)
        self.assertLess(errors[len(errors) * 95 // 100], 0.003)

    def test_the_occlusion_is_that_of_the_program(self):
        for method in ("gtao", "sweep", "hemisphere"):
            with self.subTest(method=method):
                self.compare(self.history(method)[0::4], self.native(method, "--set", "filter=none"))

    def test_the_filtered_occlusion_is_that_of_the_program(self):
        unfiltered = self.native("sweep", "--set", "filter=none")
        for preset, frames, size in (("balanced", FRAMES, (WIDTH, HEIGHT)), ("quality", 2, (WIDTH, HEIGHT)),
                                     ("fast", FRAMES, (WIDTH, HEIGHT)), ("fast", FRAMES, (161, 99))):
            with self.subTest(preset=preset, size=size):
                want = self.native("sweep", preset=preset, frames=frames, size=size)
                self.compare(self.rendered("readOcclusion", "sweep", preset, frames=frames, size=size), want)
        filtered = self.rendered("readOcclusion", "sweep")
        self.assertGreater(sum(abs(a - b) for a, b in zip(filtered, unfiltered)) / len(filtered), 0.01)

    def test_every_frame_is_filtered(self):
        for frames in (1, 9):
            history = self.history("sweep", frames=frames, size=(64, 36))[0::4]
            shown = self.rendered("readOcclusion", "sweep", frames=frames, size=(64, 36))
            self.assertNotEqual(list(history), list(shown), frames)

    def test_samples_accumulate_and_converge(self):
        weights = self.history("hemisphere", frames=20, moves=False)[1::4]
        self.assertEqual(128.0, max(weights))  # 10 samples a frame, 128 in the mean
        self.assertEqual(200.0, max(self.history("hemisphere", frames=20, moves=False)[2::4]))
        self.assertEqual(40.0, sorted(self.history("hemisphere", frames=4, moves=False)[1::4])[WIDTH * HEIGHT // 2])

    def test_the_views_and_the_slider_differ(self):
        self.history("gtao")  # ends the page's own loop: from here on nothing else changes
        pictures = [self.browser.evaluate(f"gloam.live.state.effect.show({view}, {split}),"
                                          "document.getElementById('canvas').toDataURL()")
                    for view in range(5) for split in (0, 0.5)]
        self.assertEqual(10, len(set(pictures)))
        white = self.browser.evaluate("""(() => {
            const {effect} = gloam.live.state;
            effect.show(1, 1);
            const bytes = new Uint8Array(4 * effect.images.width * effect.images.height);
            const {gl} = effect.passes;
            gl.readPixels(0, 0, effect.images.width, effect.images.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
            return bytes.every((byte) => byte === 255);
        })()""")
        self.assertTrue(white)  # nothing has occlusion left of the slider

    def test_a_kept_picture_is_compared_with_what_follows(self):
        self.history("gtao", frames=2, moves=False)
        state = self.browser.evaluate("""(async () => {
            const {effect} = gloam.live.state;
            const shown = (view, split) => {
                effect.show(view, split);
                return document.getElementById("canvas").toDataURL();
            };
            const picture = shown(1, 0);
            effect.keep();
            const same = await effect.error();
            const nothing = shown(5, 0);
            effect.setMethod(await gloam.method("hemisphere"), "balanced", effect.scene.radius);
            effect.frame(gloam.camera.at(effect.scene.cameras, 0));
            const left = shown(1, 1) === picture;
            const right = shown(1, 0) === picture;
            const differs = shown(5, 0) !== nothing;
            const error = await effect.error();
            effect.forget();
            return {same, left, right, differs, error, forgotten: await effect.error()};
        })()""")
        self.assertEqual((0, True, False, True, None), tuple(state[name] for name in
                                                             ("same", "left", "right", "differs", "forgotten")))
        self.assertGreater(state["error"], 0.01)

    def test_a_converged_picture_is_kept(self):
        self.browser.evaluate("document.getElementById('keep').click()")
        self.browser.wait("gloam.live.state.keeping > 3")
        self.assertEqual(1e6, self.setting("weight_max"))
        self.browser.evaluate("gloam.live.state.keeping = 3")
        self.browser.wait("document.getElementById('left-told').textContent === 'gtao, kept'")
        self.assertEqual(128, self.setting("weight_max"))
        self.choose(view="difference", method="hemisphere")
        self.browser.wait("document.getElementById('timing').textContent.includes('against gtao, kept')")
        self.choose(scene="knot")
        self.browser.wait("document.getElementById('left-told').textContent === 'without'")
        self.assertIsNone(self.browser.evaluate("gloam.live.state.effect.kept"))

    def test_another_method_stands_on_the_left_with_a_history_of_its_own(self):
        self.choose(left="hemisphere", view="difference")
        self.browser.wait("document.getElementById('timing').textContent.includes('against hemisphere')")
        self.browser.wait("gloam.live.state.effect.left.frames > 5")
        self.assertGreater(self.browser.evaluate("gloam.live.state.effect.error()"), 0.01)
        self.choose(left="gtao")
        self.browser.wait("gloam.live.state.effect.left.frames > 5")
        self.choose(method="gtao")  # both begin anew
        self.assertEqual(0, self.browser.evaluate("gloam.live.state.effect.error()"))
        self.choose(left="without")
        self.assertIsNone(self.browser.evaluate("gloam.live.state.effect.compared"))

    def choose(self, **choices):
        """Sets controls by their identifiers, as a person does, and lets the page draw."""
        for identifier, value in choices.items():
            self.browser.evaluate(f"document.getElementById('{identifier}').value = '{value}';"
                                  f"document.getElementById('{identifier}').dispatchEvent(new Event('input'));"
                                  f"document.getElementById('{identifier}').dispatchEvent(new Event('change'))")
        self.browser.evaluate("new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() =>"
                              " requestAnimationFrame(resolve)))).then(() => 0)")

    def setting(self, name):
        return self.browser.evaluate(f"gloam.live.state.effect.settings.{name}")

    def test_the_controls_choose(self):
        self.choose(size="320x180", preset="quality")
        self.assertEqual(("sweep", 24), (self.setting("method"), self.setting("samples")))
        self.choose(method="sweep", radius=2)
        self.assertEqual(("sweep", 1.0), (self.setting("method"), self.setting("radius")))
        self.assertAlmostEqual(0.001, self.setting("bias"), 6)
        self.choose(scene="knot")
        self.assertEqual(("knot", 320), (self.browser.evaluate("gloam.live.state.effect.scene.name"),
                                         self.browser.evaluate("document.getElementById('canvas').width")))
        self.browser.evaluate("document.getElementById('moves').click()")
        before = self.browser.evaluate("gloam.live.state.number")
        self.choose()
        self.assertEqual(before, self.browser.evaluate("gloam.live.state.number"))
        self.assertIn("ms from frame to frame", self.browser.text("timing"))
        self.assertEqual([], self.browser.problems())
        asked = [url for url in self.browser.requests() if not url.startswith(("file:", "data:", "about:"))]
        self.assertEqual([], asked)

    def test_a_shader_that_does_not_compile_is_told(self):
        self.browser.evaluate("gloam.method('sweep').then((sweep) =>"
                              " gloam.addMethod({...sweep, text: sweep.text + 'no_such;'})).then(() => 0)")
        self.choose(method="sweep")
        self.assertIn("occlusion by sweep does not compile", self.browser.text("told"))

    def test_every_method_draws(self):
        names = self.browser.evaluate("gloam.effectData.methods.map((method) => method.name)")
        self.assertGreater(len(names), 25)
        for name in names:
            occlusion = self.history(name, frames=1, size=(64, 36))[0::4]
            self.assertGreater(max(occlusion) - min(occlusion), 0.1, name)

    def test_a_small_screen(self):
        self.browser.look(390, 844, dark=True)
        self.assertLessEqual(self.browser.evaluate("document.documentElement.scrollWidth"), 390)


if __name__ == "__main__":
    main()
