#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""webgpu_effect_test.py GLOAM: the effect of the first page in WebGPU, in headless Chromium. It is that of WebGL2, and
WebGL2 takes its place where there is no WebGPU, or none any more.

Left with status 77 where there is no Chromium, or none with WebGPU."""
import array
import base64

from browser import Browser
from site_case import SiteCase, main, skip

WEBGPU_FLAGS = ("--enable-unsafe-webgpu", "--use-webgpu-adapter", "--enable-features", "--use-vulkan")
# Both APIs run the same GLSL on the same SwiftShader, but two compilers choose the order of its operations. A pixel is
# a mean of at most 64 samples in a frame, so roundings of 2^-24 add up to less than 64 * 2 * 2^-24.
ROUNDING = 2 ** -17
# Where a rounding decides whether a sample counts or a history is kept, the pixel differs by more. 7 of 5,184 pixels
# were measured after four frames.
FLIPPED = 0.005

# What the page computes: float32 values as base64.
PREPARED = """window.floats = (values) => {
    const bytes = new Uint8Array(Float32Array.from(values).buffer);
    let text = "";
    for (let i = 0; i < bytes.length; i += 32768) text += String.fromCharCode(...bytes.subarray(i, i + 32768));
    return btoa(text);
};
// One effect in each API, beside that of the page.
window.effects = {};
window.rendered = async (api, method, preset, [width, height], frames) => {
    effects[api] ??= await gloam.api.effect(api, document.createElement("canvas"));
    const effect = effects[api];
    effect.setLeft(null);
    effect.setSize(width, height);
    effect.setScene(await gloam.scene("columns"));
    effect.setMethod(await gloam.method(method, effect.api), preset, effect.scene.radius);
    for (let i = 0; i < frames; ++i) effect.frame(gloam.camera.at(effect.scene.cameras, 3 * i));
    return effect;
};
// What the canvas shows, in [0, 1].
window.shown = (effect, view, split) => {
    const context = new OffscreenCanvas(effect.images.width, effect.images.height).getContext("2d");
    effect.show(view, split);
    context.drawImage(effect.canvas, 0, 0);
    return Array.from(context.getImageData(0, 0, effect.images.width, effect.images.height).data, (x) => x / 255);
};
// By an object of the class with inputs of another kind than the page's.
window.withInputs = async (effect, inputs) => {
    const occlusion = new gloam.AmbientOcclusion(effect.passes, effect.data, inputs);
    occlusion.setMethod(await gloam.method("sweep", effect.api), "balanced", effect.scene.radius);
    occlusion.setSize(effect.images.width, effect.images.height);
    const {depth, normal} = effect.images;
    for (let i = 0; i < 2; ++i)
        occlusion.render({depth, normal, projection: effect.projection(), view: gloam.camera.view(effect.camera)});
    return occlusion.readOcclusion();
};
gloam.live.state.failed = true;  // ends the page's own loop
0"""


class WebGpuEffectTest(SiteCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.browser.open(cls.site / "licences.html")
        if not cls.browser.evaluate("navigator.gpu?.requestAdapter().then((adapter) => adapter !== null)"):
            skip("no WebGPU")

    def open(self, behind, browser=None):
        browser = browser or self.browser
        browser.look(1000, 900)
        browser.open(self.site / "index.html", behind)
        browser.wait("gloam.live.state.effect?.frames > 0 || gloam.live.state.failed")

    def prepare(self):
        """A page on which rendered() makes effects; that of an earlier test where it is still open."""
        if self.browser.evaluate("window.effects === undefined"):
            self.open("#scene=columns&size=320x180&preset=fast")
            self.browser.evaluate(PREPARED)

    def api(self):
        return self.browser.evaluate("gloam.live.state.effect.api")

    def floats(self, api, script):
        """The value of an expression, in which `api` is this one."""
        return array.array("f", base64.b64decode(self.browser.evaluate(f"((api) => {script})('{api}')")))

    def in_both(self, scripts):
        """The values of expressions, each in WebGL2 and in WebGPU."""
        self.prepare()
        results = [(self.floats("webgl2", script), self.floats("webgpu", script)) for script in scripts]
        self.assertEqual(["webgl2", "webgpu"],
                         self.browser.evaluate("[effects.webgl2, effects.webgpu].map((effect) => effect.api)"))
        self.assertEqual([], self.browser.problems())
        return results

    def compare(self, want, got, rounding=ROUNDING, most=None):
        """most: how many values may differ by more than the rounding. Gives how many do."""
        self.assertEqual(len(want), len(got))
        self.assertGreater(max(want) - min(want), 0.3)
        differ = [abs(a - b) for a, b in zip(want, got) if not abs(a - b) <= rounding]
        self.assertLessEqual(len(differ), FLIPPED * len(want) if most is None else most, sorted(differ)[-5:])
        return len(differ)

    def test_the_occlusion_is_that_of_webgl2(self):
        cases = [(method, preset, size) for method, preset, size in (
            ("sweep", "balanced", (96, 54)), ("gtao", "fast", (97, 55)), ("hemisphere", "quality", (96, 54)),
            ("hbao", "balanced", (75, 43)), ("sweep", "fast", (128, 72)))]
        script = ("rendered(api, '{}', '{}', [{}, {}], 4).then(async (effect) => floats("
                  "[effect.settings.filter_half_width, ...(await effect.read()).filter((_, i) => i % 4 === 0),"
                  " ...await effect.readOcclusion()]))")
        values = self.in_both([script.format(method, preset, *size) for method, preset, size in cases])
        for (method, preset, (width, height)), (want, got) in zip(cases, values):
            with self.subTest(method=method, preset=preset):
                half = preset == "fast"
                pixels = (width + 1) // 2 * ((height + 1) // 2) if half else width * height
                flipped = self.compare(want[1:pixels + 1], got[1:pixels + 1])
                # The filter reads a square around a pixel, and a pixel of the whole size reads four of half the size.
                side = 2 * want[0] + 1
                read = (2 * (side + 1)) ** 2 if half else side ** 2
                self.compare(want[pixels + 1:], got[pixels + 1:], most=flipped * read)

    def test_the_history_and_the_picture_are_those_of_webgl2(self):
        effect = "rendered(api, 'gtao', 'balanced', [96, 54], 3).then(async (effect) => floats({}))"
        names = ["(await effect.read()).filter((_, i) => i % 4 < 2).map((x, i) => i % 2 ? x / 128 : x)",
                 "shown(effect, 0, 0.5)", "shown(effect, 1, 0)", "shown(effect, 4, 0)"]
        values = self.in_both([effect.format(name) for name in names])
        self.compare(*values[0])
        for name, (want, got) in zip(names[1:], values[1:]):
            with self.subTest(name):
                self.compare(want, got, rounding=1 / 255 + ROUNDING)

    def test_all_behind_the_near_plane_is_drawn(self):
        """The ranges of depth in clip space differ: the wrong one cuts what is nearer than twice the near plane."""
        script = """rendered(api, "gtao", "fast", [96, 54], 1).then(async (effect) => {
            const depths = (await effect.passes.read(effect.images, 1)).sort();
            effect.scene = {...effect.scene, near: 0.7 * depths[depths.length / 2]};
            effect.frame(effect.camera);
            return floats(await effect.passes.read(effect.images, 1));
        })"""
        [(want, got)] = self.in_both([script])
        self.compare(want, got)

    def test_every_kind_of_input_is_read(self):
        script = ("rendered(api, 'sweep', 'balanced', [96, 54], 1)"
                  ".then(async (effect) => floats(await withInputs(effect, {})))")
        kinds = ["{depth: 'linear', normals: 'none'}", "{depth: 'linear', normals: 'world'}",
                 "{depth: 'linear', normals: 'view-unorm'}"]
        for kind, (want, got) in zip(kinds, self.in_both([script.format(kind) for kind in kinds])):
            with self.subTest(kind):
                self.compare(want, got)

    def test_another_picture_is_noticed(self):
        self.prepare()
        script = ("rendered(api, 'gtao', 'balanced', [96, 54], {})"
                  ".then(async (effect) => floats(await effect.readOcclusion()))")
        pictures = [self.floats("webgpu", script.format(frames)) for frames in (3, 4)]
        with self.assertRaises(AssertionError):
            self.compare(*pictures)
        with self.assertRaises(AssertionError):
            self.compare(pictures[0], [value + 2 * ROUNDING for value in pictures[0]])

    def test_pictures_are_kept_and_compared(self):
        self.prepare()
        same, with_nothing, occlusion, left = self.browser.evaluate("""(async () => {
            const effect = await rendered("webgpu", "gtao", "balanced", [61, 35], 2);
            effect.keep();
            const same = await effect.error();
            effect.keepOcclusion(new Float32Array(61 * 35));
            const withNothing = await effect.error();
            const depths = await effect.passes.read(effect.images, 1);
            const squares = (await effect.readOcclusion()).filter((_, i) => depths[i] > 0).map((x) => x * x);
            effect.forget();
            effect.setLeft(await gloam.method("hbao", "webgpu"), "balanced", effect.scene.radius);
            effect.frame(effect.camera);
            return [same, withNothing, Math.sqrt(squares.reduce((sum, x) => sum + x) / squares.length),
                await effect.error()];
        })()""")
        self.assertEqual(0, same)
        self.assertAlmostEqual(occlusion, with_nothing, 5)
        self.assertGreater(with_nothing, 0.05)
        self.assertGreater(left, 0.01)

    def test_every_method_draws(self):
        self.prepare()
        ranges = self.browser.evaluate("""(async () => {
            const ranges = {};
            for (const {name} of gloam.effectData.methods) {
                const values = await (await rendered("webgpu", name, "balanced", [32, 18], 1)).readOcclusion();
                ranges[name] = Math.max(...values) - Math.min(...values);
            }
            return ranges;
        })()""")
        self.assertGreater(len(ranges), 25)
        self.assertEqual([], [name for name, range in ranges.items() if not 0.1 < range <= 1])
        self.assertEqual([], self.browser.problems())

    def test_a_browser_that_has_it_runs_it(self):
        self.open("#scene=columns&size=320x180&preset=fast")
        timing = "document.getElementById('timing').textContent"
        self.browser.wait(f"/^WebGPU: [\\d.]+ ms .*, [\\d.]+ ms of the GPU for the occlusion/.test({timing})")
        self.assertLess(0, self.browser.evaluate("gloam.live.state.effect.passes.timer.ms"))
        self.assertNotIn("api=", self.browser.evaluate("location.hash"))

    def choose(self, identifier, value):
        self.browser.evaluate(f"document.getElementById('{identifier}').value = '{value}';"
                              f"document.getElementById('{identifier}').dispatchEvent(new Event('change'))")

    def test_a_control_changes_it_and_the_view_stays(self):
        self.open("#scene=knot&size=320x180&left=hbao&camera=0.5,0.25,3,0,0.5,0&api=webgpu")
        for api in ("webgl2", "webgpu"):
            self.choose("api", api)
            self.browser.wait(f"gloam.live.state.effect.api === '{api}' && gloam.live.state.effect.left?.frames > 1")
            self.assertEqual([0.5, 0.25, 3, 0, 0.5, 0], self.browser.evaluate("gloam.live.state.orbit.numbers"))
            self.browser.wait(f"location.hash.includes('api={api}')")
        self.choose("size", "480x270")
        self.browser.wait("gloam.live.state.effect.images.width === 480 && gloam.live.state.effect.frames > 1")
        self.assertEqual(("webgpu", "", []), (self.api(), self.browser.text("told"), self.browser.problems()))

    def test_a_lost_device_is_told_and_webgl2_goes_on(self):
        self.open("#scene=knot&size=320x180&camera=0.5,0.25,3,0,0.5,0")
        self.browser.evaluate("gloam.live.state.effect.passes.device.destroy()")
        self.browser.wait("gloam.live.state.effect.api === 'webgl2' && gloam.live.state.effect.frames > 2")
        self.assertRegex(self.browser.text("told"), r"^WebGPU: .*[^.]\. The picture runs in WebGL2\.$")
        self.assertEqual([[0.5, 0.25, 3, 0, 0.5, 0], "knot", "webgl2", False], self.browser.evaluate(
            "[gloam.live.state.orbit.numbers, gloam.live.state.effect.scene.name,"
            " document.getElementById('api').value, gloam.live.state.failed]"))

    def test_a_shader_that_does_not_compile_is_told_and_webgl2_goes_on(self):
        self.open("#scene=knot&size=320x180&method=gtao&api=webgpu")
        self.browser.evaluate("gloam.method('sweep', 'webgpu').then(({text}) => gloam.addMethodPass('sweep', 'webgpu',"
                              " {...text, text: text.text + 'no_such;'})).then(() => 0)")
        self.choose("method", "sweep")
        self.browser.evaluate("document.getElementById('method').dispatchEvent(new Event('input'))")
        self.browser.wait("gloam.live.state.effect.api === 'webgl2' && gloam.live.state.effect.frames > 1")
        self.assertRegex(self.browser.text("told"), r"^WebGPU: occlusion by sweep does not compile: "
                         r".*:\d+:1 error: .*\. The picture runs in WebGL2\.$")

    def test_without_webgpu_it_is_webgl2(self):
        with Browser(without=WEBGPU_FLAGS) as other:
            self.open("#scene=columns&size=320x180&preset=fast", other)
            self.assertEqual(("webgl2", ""), (other.evaluate("gloam.live.state.effect.api"), other.text("told")))
            other.wait("document.getElementById('timing').textContent.startsWith('WebGL2: ')")
            self.open("#scene=columns&size=320x180&preset=fast&api=webgpu", other)
            self.assertEqual("WebGPU: this browser has no WebGPU. The picture runs in WebGL2.", other.text("told"))
            self.assertEqual([], other.problems())


if __name__ == "__main__":
    main()
