#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""wgsl_test.py GLOAM GLSL: what `gloam pack --target wgsl` writes, in headless Chromium's WebGPU.

With GLOAM_WGSL_SWEEP=1 it packs every include, every pass, and the effect of every preset and method, in one to two
minutes. Left with status 77 where there is no Chromium, or none with WebGPU."""
import base64
import json
import os
import re
import sys
import unittest
from array import array
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from check_page import run
from random_program import Program
from site_case import BrowserCase, main, read_pfm, skip

GLSL = Path(sys.argv[2])
WIDTH, HEIGHT = 64, 48


def defined(text):
    """The text with a body for each function that its user defines."""
    text = re.sub(r"^// (fn \w+\([^\n]*\) -> (\S+))$", r"\1 { return \2(); }", text, flags=re.M)
    return re.sub(r"^// (fn \w+\([^\n>]*\))$", r"\1 { }", text, flags=re.M)


class WgslTest(BrowserCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        page = cls.folder / "page.html"
        scripts = [(Path(__file__).parent / name).read_text(encoding="utf-8")
                   for name in ("run_effect.js", "run_program.js")]
        page.write_text("".join(f"<script>{script}</script>" for script in scripts), encoding="utf-8")
        cls.browser.open(page)
        if not cls.browser.evaluate("navigator.gpu?.requestAdapter().then((adapter) => adapter !== null)"):
            skip("no WebGPU")

    def compiled(self, texts):
        """What the browser's compiler says of texts by their names, without those that it accepts."""
        messages = self.browser.evaluate(f"compileAll({json.dumps(list(texts.values()))})")
        return {name: message for name, message in zip(texts, messages) if message}

    def packed(self, commands):
        """The texts of `gloam pack` by their names, and the messages where it refuses."""
        with ThreadPoolExecutor(2) as pool:
            results = list(pool.map(lambda command: run("pack", *command, "--target", "wgsl"), commands.values()))
        texts = {name: defined(r.stdout) for name, r in zip(commands, results) if r.returncode == 0}
        refused = {name: r.stderr for name, r in zip(commands, results) if r.returncode != 0}
        return texts, refused

    def effect(self, name, *arguments):
        folder = self.folder / name
        packed = run("pack", "--effect", *arguments, "--target", "wgsl", "--out", folder)
        self.assertEqual(0, packed.returncode, packed.stderr)
        return folder

    def passes(self, folder):
        return {f"{folder.name}/{file.stem}": file.read_text(encoding="utf-8") for file in folder.glob("*.wgsl")}

    def test_the_compiler_refuses_what_is_wrong(self):
        self.assertEqual(["wrong"], list(self.compiled({"right": "fn f() -> f32 { return 1.0; }",
                                                        "wrong": "fn f() -> f32 { return 1u; }"})))

    def test_the_functions_of_all_methods_compile(self):
        methods = {name: [file, "--function", name] for file in sorted((GLSL / "gloam/methods").glob("*.glsl"))
                   for name in re.findall(r"^GloamEstimate (\w+)\(", file.read_text(encoding="utf-8"), re.MULTILINE)}
        texts, refused = self.packed(methods)
        self.assertEqual({}, refused)
        self.assertGreaterEqual(len(texts), 37)
        self.assertEqual({}, self.compiled(texts))
        self.assertIn("fn gloam_gtao(", texts["gloam_gtao"])

    def test_the_passes_of_presets_compile(self):
        texts = {}
        for preset in ("balanced", "fast", "reference"):
            texts.update(self.passes(self.effect(preset, "--preset", preset)))
        texts.update(self.passes(self.effect("moving", "--motion-vectors", "--bent-normals")))
        self.assertIn("balanced/ambient_occlusion", texts)
        self.assertIn("moving/positions_from_motion", texts)
        self.assertEqual({}, self.compiled(texts))

    def test_vertex_and_fragment_shaders_compile(self):
        files = sorted([*(GLSL / "passes").glob("*.vert"), *(GLSL / "passes").glob("*.frag")])
        texts, refused = self.packed({file.name: [file] for file in files})
        self.assertEqual({}, refused)
        self.assertEqual(["gbuffer.frag", "gbuffer.vert", "peel.frag"], sorted(texts))
        self.assertEqual({}, self.compiled(texts))

    def test_images_exchanges_halves_and_subgroups_compile(self):
        fixtures = sorted((Path(__file__).parent.parent / "shader/fixtures/wgsl").glob("*.comp"))
        texts, refused = self.packed({file.stem: [file] for file in fixtures})
        self.assertEqual({}, refused)
        self.assertEqual(["exchange", "half", "images", "subgroups"], sorted(texts))
        messages = self.compiled(texts)
        without = "extension 'f16' is not allowed in the current environment"  # SwiftShader has no shader-f16
        self.assertTrue(without in messages.pop("half", without))
        self.assertEqual({}, messages)

    @unittest.skipUnless(os.environ.get("GLOAM_WGSL_SWEEP"), "GLOAM_WGSL_SWEEP=1 runs it")
    def test_everything_compiles_or_is_refused_in_one_line(self):
        files = sorted([*GLSL.rglob("gloam/**/*.glsl"), *GLSL.rglob("passes/**/*.comp")])
        texts, refused = self.packed({str(file.relative_to(GLSL)): [file] for file in files})
        for preset in (one["name"] for one in json.loads(run("list", "presets", "--json").stdout)["presets"]):
            texts.update(self.passes(self.effect("preset-" + preset, "--preset", preset)))
        for method in run("list", "methods").stdout.split():
            texts.update(self.passes(self.effect("method-" + method, "--method", method)))
        self.assertEqual({}, self.compiled(texts))
        print(f"{len(texts)} texts; refused: {refused}")
        for message in refused.values():
            self.assertRegex(message, r"^gloam: .*(WGSL cannot express|gloam does not translate to WGSL yet:) .*\n$")

    def test_random_programs_give_the_results_of_glsl(self):
        """WebGL2 runs the GLSL: its compiler is another one than that which made the WGSL."""
        programs = {}
        for seed in range(int(os.environ.get("GLOAM_WGSL_PROGRAMS", "5"))):
            programs[str(seed)] = self.folder / f"program{seed}.glsl"
            programs[str(seed)].write_text(Program(seed).text, encoding="utf-8")
        texts, refused = self.packed({seed: [file] for seed, file in programs.items()})
        self.assertEqual({}, refused)
        pairs = [[programs[seed].read_text(encoding="utf-8"), text] for seed, text in texts.items()]
        various = 0
        for seed, (want, got) in zip(texts, self.browser.evaluate(f"runPrograms({json.dumps(pairs)})")):
            self.assertEqual(want, got, f"seed {seed}")
            various += len(set(got)) > 50
        self.assertGreater(various, len(pairs) // 2)

    def picture(self, preset, *more, bent=False):
        """What the browser and the program make of one G-buffer: the occlusion, or x of the mean open directions."""
        buffers = self.folder / f"{preset}-buffers"
        out = self.folder / f"{preset}-native"
        native = run("render", "columns", "--still", "--size", f"{WIDTH}x{HEIGHT}", "--preset", preset, *more,
                     *(("--bent-normals", "--bent-interleave", "4") if bent else ()),
                     "--write-gbuffer", buffers, "--out", out, "--quiet")
        self.assertEqual(0, native.returncode, native.stderr)
        view = json.loads((buffers / "f0000.json").read_text(encoding="utf-8"))
        folder = self.effect(preset + "-effect", "--preset", preset, *more, "--size", f"{WIDTH}x{HEIGHT}",
                             "--radius", view["ao_radius"], *(("--bent-normals",) if bent else ()))
        depth, _ = read_pfm(buffers / "f0000_depth.pfm")
        normal, _ = read_pfm(buffers / "f0000_normal.pfm")
        normal = [v for i in range(0, len(normal), 3) for v in (*normal[i:i + 3], 0.0)]
        images = {name: base64.b64encode(array("f", values)).decode()
                  for name, values in (("depth", depth), ("normal", normal))}
        projection = view["camera"]["proj_vk"]
        effect = json.loads((folder / "effect.json").read_text(encoding="utf-8"))
        texts = {name.split("/")[1]: text for name, text in self.passes(folder).items()}
        arguments = [effect, texts, images, {"p00_p11": [projection[0], projection[5]]}]
        if bent:
            arguments.append("bent_normal")
        got = self.browser.evaluate(f"runEffect({', '.join(map(json.dumps, arguments))})")
        if bent:
            return got, read_pfm(out / "f0000_bent.pfm")[0][::3]
        return got, read_pfm(out / "f0000_ao.pfm")[0]

    def test_a_whole_effect_gives_the_picture_of_the_program(self):
        for preset in ("balanced", "tssao-paper"):
            with self.subTest(preset=preset):
                got, want = self.picture(preset, "--set", "precision=float32")
                self.assertEqual(len(want), len(got))
                self.assertGreater(max(want) - min(want), 0.5)
                self.assertLess(max(abs(a - b) for a, b in zip(got, want)), 1e-6)  # seen: 6e-8 and 1.2e-7

    def test_the_bent_normals_of_an_effect_are_those_of_the_program(self):
        got, want = self.picture("balanced", bent=True)
        self.assertEqual(len(want), len(got))
        self.assertGreater(max(want) - min(want), 1.0)
        self.assertLess(max(abs(a - b) for a, b in zip(got, want)), 1e-4)


if __name__ == "__main__":
    main(2)
