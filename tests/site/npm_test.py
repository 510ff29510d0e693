#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""npm_test.py GLOAM FOLDER: `gloam pack --npm`, installed into a copy of the example with three.js, bundled, and opened
in headless Chromium. It uses no FOLDER.

Left with status 77 where there is no Chromium, no npm, or nothing that npm can install from."""
import array
import json
import shutil
import subprocess
import tempfile
from pathlib import Path

from browser import program
from site_case import GLOAM, BrowserCase, floats_of, install, main, read_pfm, skip

EXAMPLE = Path(__file__).resolve().parents[2] / "examples/threejs"

# Name, preset, whether there are normals, and the view.
# The last number: the share of pixels that may be apart once the camera stands; in a jitter a point that stands lies
# on the border of other texels in each frame.
SEQUENCES = [("perspective", "balanced", True, "made()", 0.015),
             ("reversed depth, jitter", "quality", True,
              "Object.assign(made({reversedDepthBuffer: true}), {jitters: true})", 0.03),
             ("orthographic", "fast", True, "orthographic(made())", 0.015),
             ("orthographic, in tiles", "quality", True, "orthographic(made())", 0.015),
             ("depth of the composer, left-handed", "reference", False, "leftHanded(withComposerDepth(made()))", 0.015),
             ("the same, orthographic", "fast", False, "leftHanded(withComposerDepth(orthographic(made())))", 0.015),
             ("full size", "reference --set resolution=full", True, "made()", 0.015),
             ("tiles", "balanced --set resolution=tiles --set mark=0.08", True, "made()", 0.015)]

# Calls, one after the other, and what each is refused with.
REFUSED = [("new AmbientOcclusion(none, effect)", "not one of WebGL2"),
           ("new AmbientOcclusion(gl, effect, {depth: 'log'})", 'depth "log": expected "linear" or "buffer"'),
           ("new AmbientOcclusion(gl, effect, {range: '0-1'})", 'range "0-1": expected'),
           ("new AmbientOcclusion(gl, effect, {normals: 'tangent'})", 'normals "tangent": expected'),
           ("plain.render({})", "no size or no preset"),
           ("plain.setPreset('none', 1)", 'preset "none": expected fast, balanced'),
           ("plain.setPreset('balanced', -1)", "radius -1: expected"),
           ("plain.setPreset('balanced', 1, {resolution: 'quarter'})", 'resolution "quarter": expected "full"'),
           ("plain.setSize(0, 5)", "size 0x5: expected whole numbers"),
           ("plain.setPreset('balanced', 1); plain.setSize(8, 8); plain.render({projection, view: [NaN]})",
            "view: expected 16 finite numbers"),
           ("plain.render({projection, view: projection})", "depth: expected a texture"),
           ("plain.render({projection: byRows, view: projection})",
            "projection: the matrix is written row by row, expected column"),
           ("plain.render({projection, view: projection.map((x, i) => i === 7 ? 3 : x)})",
            "view: the matrix is written row by row"),
           ("pass.source = 'composer'; view.draw()", "whose target has a depthTexture"),
           ("pass.source = 'scene'; pass.preset = 'none'; view.draw()", 'preset "none": expected fast'),
           ("made({logarithmicDepthBuffer: true}).draw()", "logarithmicDepthBuffer: expected"),
           ("new Pass(scene, camera, {output: 'light'})",
            'output "light": expected "shaded" or "visibility" or "ambient"'),
           ("new Pass(scene, camera, {raduis: 2})",
            'option "raduis": expected preset, radius, resolution, intensity, distance, output'),
           ("new Pass(scene)", "camera: expected one of three.js, got undefined"),
           ("depths.onBeforeCompile({uniforms: {}, fragmentShader: ''})",
            "MeshNormalMaterial: expected a material that three.js lights")]


def write_gbuffer(folder, number, frame, before, normals):
    """A frame as `gloam render --gbuffer` reads it."""
    folder.mkdir(exist_ok=True)
    width, height = frame["size"]
    texels = floats_of(frame["texels"])
    camera = {"view": frame["view"], "proj_vk": frame["proj_vk"], "prev_view": None if frame["cut"] else before["view"]}
    name = f"{folder}/f{number:04}"
    Path(name + ".json").write_text(json.dumps({"width": width, "height": height, "camera": camera}), encoding="utf-8")
    for kind, head, channels in [("depth", "Pf", [3])] + [("normal", "PF", [0, 1, 2])] * normals:
        rows = [[texels[4 * (y * width + x) + c] for x in range(width) for c in channels] for y in range(height)]
        values = array.array("f", [value for row in reversed(rows) for value in row])
        Path(f"{name}_{kind}.pfm").write_bytes(f"{head}\n{width} {height}\n-1\n".encode() + values.tobytes())


class NpmTest(BrowserCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.browser.timeout = 150
        cls.browser.look(800, 600)
        cls.browser.open(FOLDER / "index.html", "#compare")

    def tearDown(self):
        self.assertEqual([], self.browser.problems())

    def ask(self, script):
        """What a function of the page returns. Its views are closed then."""
        return self.browser.evaluate(f"(async () => {{ {script} }})().finally(closeViews)")

    def test_the_types(self):
        done = subprocess.run(["npx", "tsc", "--noEmit", "--strict", "--module", "nodenext", "--target", "es2022",
                               "--types", "@webgpu/types", "types.ts"], cwd=FOLDER, capture_output=True, text=True,
                              check=False)
        self.assertEqual((0, ""), (done.returncode, done.stdout))

    def test_the_occlusion_is_that_of_the_program(self):
        """In 40 frames of a moving view, with a cut and another size among them. At last the camera stands: there a
        point that has not moved is within rounding of the border between two texels before."""
        for name, preset, normals, made, standing in SEQUENCES:
            with self.subTest(name):
                frames = self.ask(f"""
                    const view = {made};
                    [view.occlusion.preset, , view.occlusion.resolution = null] = "{preset}".split(/ --set |=/);
                    const box = view.scene.children[2];
                    return written(recorded(view, 40, (view, i) => {{
                        if (i === 20) view.setSize(97, 55);
                        if (i === 10) view.occlusion.restart();
                        if (i < 32) turn(view, (i < 10 ? 0 : 0.3) + 0.01 * i);
                        box.position.x = 0.02 * i - 2;
                        if (view.jitters) jitter(view, i);
                    }}));""")
                folder = FOLDER / name
                for i, frame in enumerate(frames):
                    write_gbuffer(folder, i, frame, frames[i - 1], normals)
                subprocess.run([GLOAM, "render", "--gbuffer", folder, "--depth", "buffer", "--normals", "view-unorm",
                                "--preset", *preset.split(), "--radius", "1", "--out", folder / "out", "--quiet"],
                               check=True)
                for i, frame in enumerate(frames):
                    want = read_pfm(folder / f"out/f{i:04}_ao.pfm")
                    apart = [x - y for x, y in zip(floats_of(frame["occlusion"]), want, strict=True)]
                    self.assertLessEqual(sum(255 * abs(one) > 1.1 for one in apart),
                                         len(apart) * (0.002 if i < 32 else standing), i)
                    self.assertLess(abs(sum(apart)) / len(apart), 2e-4, i)
                    self.assertGreater(max(want), 0.4)

    def test_other_encodings_and_left_handed_views_give_the_same(self):
        for view in ("made()", "orthographic(made())"):
            for how in ('"world-octahedral", false', '"world-octahedral", true', '"view", true, "visibility"'):
                with self.subTest(view + how):
                    got = self.ask(f"return encoded({view}, {how});")
                    self.assertTrue(got["into"])
                    self.assertLess(got["mean"], 1e-3)
                    self.assertLess(got["most"], 1e-7)  # one less visibility is rounded

    def test_a_camera_that_zooms_gives_what_one_gives_that_stands_still(self):
        """With the images of its first frame, where the option alone says that it becomes narrow (16 degrees high)."""
        for deep, fov in (("false", 40), ("true", 16)):
            with self.subTest(fov):
                got = self.ask(f"""
                    const view = made();
                    view.occlusion.deep = {deep};
                    const zoom = (i) => {{
                        view.camera.fov = {fov} * (1 + 0.005 * i);
                        view.camera.updateProjectionMatrix();
                    }};
                    const zoomed = occlusion(frames(view, 24, (i) => zoom(23 - i)));
                    const {{images}} = view.occlusion.occlusion;
                    view.occlusion.restart();
                    const got = apart(zoomed, occlusion(frames(view, 24, () => zoom(0))));
                    const {{deep}} = images;
                    return {{...got, deep, max: Math.max(...zoomed)}};""")
                self.assertEqual(deep == "true", got["deep"])
                self.assertLess(got["mean"], 0.008)
                self.assertLess(got["most"], 0.02)
                self.assertGreater(got["max"], 0.2)

    def test_a_camera_off_its_centre_shows_its_part(self):
        got = self.ask("""
            const view = made();
            view.setSize(320, 180);
            const whole = occlusion(frames(view, 24));
            view.setSize(160, 90);
            view.camera.setViewOffset(320, 180, 80, 0, 160, 90);
            const part = occlusion(frames(view, 24));
            return apart(part, part.map((_, i) => whole[(90 + Math.floor(i / 160)) * 320 + 80 + i % 160]));""")
        self.assertLess(got["mean"], 0.01)
        self.assertLess(got["most"], 0.02)

    def test_what_is_seen_of_a_mesh_counts(self):
        got = self.ask("return comparedPairs();")
        for pair in got["all"]:
            with self.subTest(pair["name"]):
                if pair["name"] == "wireframe":
                    self.assertLess(pair["apart"], 0.3 * got["solid"])
                    self.assertGreater(pair["apart"], 0)
                    continue
                self.assertLess(pair["apart"], 1e-4)
                if pair["name"] not in ("glass", "no depth"):
                    self.assertGreater(pair["visible"], 0.2 * got["solid"])

    def test_a_context_that_was_lost_goes_on(self):
        got = self.ask("return lostAndRestored();")
        self.assertEqual((0, 0), (got["mean"], got["error"]))

    def test_other_options_give_what_a_new_pass_gives(self):
        """They begin a new history. A cut and another size do so in test_the_occlusion_is_that_of_the_program()."""
        got = self.ask("""
            const view = made();
            const chosen = {};
            const all = [{preset: "reference", resolution: "full"}, {preset: "fast", resolution: null}, {radius: 0.5},
                {preset: "quality"}, {preset: "reference", resolution: "full"}, {resolution: null},
                {camera: view.camera.clone()}, {preset: "balanced"}, {resolution: "tiles"}, {resolution: "full"},
                {resolution: "half"}].map((change) => {
                const other = made();
                const [got, want] = [[view, change], [other, Object.assign(chosen, change)]].map(([one, options]) => {
                    Object.assign(one.occlusion, options);
                    return occlusion(frames(one, 3));
                });
                const {images, passes: {gl}} = other.occlusion.occlusion;
                other.occlusion.dispose();
                const left = [images.marks, images.fullTexels].some((one) => gl.isTexture(one?.image ?? null));
                return {got, mean: apart(got, want).mean, left, error: view.renderer.getContext().getError()};
            });
            const [half, ...others] = all.splice(-4).map((one) => one.got);
            return {all, others: others.map((other) => apart(half, other).mean)};""")
        for one in got["all"]:
            self.assertLess(one["mean"], 3e-7)  # one texel by 1/255: what was before rounds a frame of all the weight
            self.assertEqual((False, 0), (one["left"], one["error"]))
        self.assertGreater(min(got["others"][:2]), 1e-3)
        self.assertEqual(0, got["others"][2])

    def test_what_cannot_be_is_refused(self):
        calls = ", ".join(f"() => {{ {call}; }}" for call, _ in REFUSED)
        messages = self.ask(f"""
            const gl = document.createElement("canvas").getContext("webgl2");
            const none = document.createElement("canvas").getContext("2d");
            const plain = new AmbientOcclusion(gl, effect);
            const projection = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
            const byRows = [1, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1, -0.2, 0, 0, -1, 0];
            const view = made();
            const {{occlusion: pass, scene, camera}} = view;
            const Pass = pass.constructor;
            const depths = new pass.materials.hidden.constructor();
            pass.darken(depths);
            return [{calls}].map(refusal);""")
        for (call, expected), message in zip(REFUSED, messages, strict=True):
            self.assertIn(expected, message or "", call)

    def test_fog_before_a_surface_is_not_darkened(self):
        """Opaque white fog stays white; a black surface in half of it has no light that could be darkened."""
        for view in ("made({reversedDepthBuffer: true})", "orthographic(made())", "withComposerDepth(made())"):
            for fog in ("Fog('white', 0, .1)", "FogExp2('white', 9)", "Fog('white', 4, 14)", "FogExp2('white', 0.08)"):
                with self.subTest(view + fog):
                    got = self.ask(f"""
                        const view = {view};
                        fogged(view, new {fog});
                        return darkening(view);""")
                    self.assertLessEqual(got["most"], 1)
                    self.assertEqual(fog.endswith(("1)", "9)")), got["least"] == 255)

    def test_glass_is_not_darkened_by_what_lies_behind_it(self):
        for output in ("shaded", "ambient"):
            for glass, most in (("{opacity: 0.98}", 2), ("{opacity: 1, depthWrite: false}", 0), ("{opacity: 0}", 255)):
                with self.subTest(output + glass):
                    got = self.ask(f"""
                        const view = made();
                        const pane = sheet({{transparent: true, ...{glass}}}, 40);
                        view.scene.add(pane.translateZ(4));
                        pane.scale.y = 20;
                        if ("{output}" === "ambient") ambient(view, "HemisphereLight");
                        return darkening(view);""")
                    self.assertTrue(got["mean"] > 2 if most == 255 else got["most"] <= most, got)

    def test_strength_and_distance_of_what_is_shown(self):
        for view in ("made()", "orthographic(made({reversedDepthBuffer: true}))"):
            means = []
            for options in ("{}", "{intensity: 0.5}", "{intensity: 2}", "{distance: 9}", "{distance: 4}"):
                with self.subTest(view + options):
                    got = self.ask(f"return shownByFormula({view}, {options});")
                    self.assertLess(got["most"], 1.1)
                    means.append(got["mean"])
            whole, half, twice, near, none = means
            self.assertTrue(twice < whole - 1 < near - 2 < none == 255 and whole < half < none, means)

    def test_ambient_light_alone_is_darkened(self):
        got = self.ask("""
            return ["DirectionalLight", "HemisphereLight"].map((lights) => {
                const view = ambient(made(), lights);
                const dark = shown(frames(view, 8));
                view.occlusion.bounces = true;
                const bounced = shown(view);
                view.occlusion.intensity = 0;
                const plain = shown(view);
                Object.assign(view.occlusion, {intensity: 1, enabled: false});
                const disabled = apart(shown(view), plain).mean;
                Object.assign(view.occlusion, {enabled: true, distance: 4});
                const far = apart(shown(view), plain).mean;
                return {disabled: disabled + far, dark: apart(dark, plain).mean, bounced: apart(bounced, plain).mean,
                    brighter: dark.filter((x, i) => x > plain[i]).length};
            });""")
        self.assertEqual({"disabled": 0, "dark": 0, "bounced": 0, "brighter": 0}, got[0])
        self.assertGreater(got[1]["dark"], 2)
        self.assertLess(got[1]["bounced"], 0.9 * got[1]["dark"])
        self.assertGreater(got[1]["bounced"], 0.3 * got[1]["dark"])
        self.assertEqual((0, 0), (got[1]["brighter"], got[1]["disabled"]))

    def test_only_what_is_asked_for_changes_the_picture(self):
        got = self.ask("""
            const view = made();
            const other = withComposerDepth(made());
            other.occlusion.enabled = false;
            const without = shown(other);
            Object.assign(view.occlusion, {output: "shaded", intensity: 0});
            const idle = shown(frames(view, 2));
            view.occlusion.intensity = 1;
            const shaded = shown(frames(view, 2));
            const brighter = shaded.filter((x, i) => x > without[i] + 1).length;
            return {idle: apart(without, idle).mean, shaded: apart(without, shaded).mean, brighter,
                visible: view.scene.children.every((one) => one.material?.isMeshNormalMaterial !== true)};""")
        self.assertLess(got["idle"], 0.05)
        self.assertGreater(got["shaded"], 2)
        self.assertEqual((0, True), (got["brighter"], got["visible"]))


if __name__ == "__main__":
    if program() is None:
        skip("no Chromium")
    with tempfile.TemporaryDirectory() as owner:
        FOLDER = Path(owner, "example")
        shutil.copytree(EXAMPLE, FOLDER, ignore=shutil.ignore_patterns("node_modules", "gloam", "bundle.js"))
        shutil.copytree(Path(__file__).with_name("npm"), FOLDER, dirs_exist_ok=True)
        for file in ("page.js", "page.html"):
            shutil.copy(EXAMPLE.parent / file, owner)
        package = Path(owner, "gloam")  # outside, as the guide has it
        subprocess.run([GLOAM, "pack", "--npm", package], check=True)
        install(FOLDER, "--install-links", package, "typescript@5.9.3", "@types/three@0.180.0")
        subprocess.run(["npx", "esbuild", "bundle=page.js", "index=../page.html", "--bundle", "--loader:.html=copy",
                        "--outdir=.", "--log-level=warning"], cwd=FOLDER, check=True)
        main()
