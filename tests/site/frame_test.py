#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""frame_test.py GLOAM FRAME_CASES: the class of the package in headless Chromium gives the occlusion that the passes of
the frame give on Vulkan, for every preset, camera, encoding and size, for poisoned images, and in sequences.

Left with status 77 where there is no Chromium."""
import re
import subprocess
import sys

from site_case import GLOAM, BrowserCase, main

# Renders a case, with the projection of Vulkan or with that of OpenGL. Of the frame that differs most: the mean
# difference from Vulkan's occlusion, and the share of pixels that differ by more than 5e-3. The contrast is that of the
# last frame.
RUN = """(({inputs, preset, size, radius, frames}, range) => {
    const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
    const floats = (text) => new Float32Array(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer);
    const occlusion = new AmbientOcclusion(gl, effect, {...inputs, range});
    const ranged = (p) => range === "zero-to-one" ? p : p.map((x, i) => i % 4 === 2 ? 2 * x - p[i + 1] : x);
    const stored = (format, channels, texels) => {
        const image = occlusion.passes.image(format, size);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, ...size, channels, gl.FLOAT, floats(texels));
        return image;
    };
    occlusion.setPreset(preset, radius);
    occlusion.setSize(...size);
    let told = {mean: 0, apart: 0};
    for (const {projection, view, depth, normal, want} of frames) {
        occlusion.render({projection: ranged(projection), view, depth: stored("R32F", gl.RED, depth),
            normal: normal ? stored("RGBA32F", gl.RGBA, normal) : null});
        const [got, wanted] = [occlusion.readOcclusion(), floats(want)];
        const far = got.reduce((sum, x, i) => sum + (Math.abs(x - wanted[i]) <= 5e-3 ? 0 : 1), 0) / got.length;
        const mean = got.reduce((sum, x, i) => sum + x - wanted[i], 0) / got.length;
        told = {mean: Math.max(told.mean, Math.abs(mean)), apart: Math.max(told.apart, far),
            contrast: Math.max(...wanted) - Math.min(...wanted)};
    }
    const error = gl.getError();
    gl.getExtension("WEBGL_lose_context").loseContext();
    return {error, ...told};
})"""


class FrameTest(BrowserCase):
    def test_each_case_is_as_on_vulkan(self):
        subprocess.run([sys.argv[2], self.folder / "cases.js"], check=True)
        subprocess.run([GLOAM, "pack", "--npm", self.folder / "gloam"], check=True)
        text = re.sub(r"(?m)^export (\{.*)?", "", (self.folder / "gloam/index.js").read_text(encoding="utf-8"))
        # llvmpipe cuts a depth to 16 bits, where the browser rounds it: one tap within rounding of a limit counts there
        # and not here, in 3 % of the pixels.
        cut = r"depth = uintBitsToFloat(floatBitsToUint(\1) & ~0x1FFFu);"
        text, cuts = re.subn(r"depth = (sign_of\([^;]*);", cut, text)
        self.assertEqual(1, cuts)
        page = self.folder / "frame.html"
        page.write_text(f"<!doctype html><script src='cases.js'></script><script>{text}</script>", encoding="utf-8")
        self.browser.open(page)
        for i in range(self.browser.evaluate("cases.length")):
            name = self.browser.evaluate(f"cases[{i}].name")
            for range_ in ("zero-to-one", "negative-one-to-one"):
                with self.subTest(name, range=range_):
                    told = self.browser.evaluate(f"{RUN}(cases[{i}], '{range_}')")
                    self.assertEqual(0, told["error"])
                    # A point that has not moved is within rounding of the border between two texels before.
                    # The filter's tolerance is five times what a depth of 16 bits is rounded by.
                    self.assertLess(told["apart"], 0.006 if "stands" in name else 0.003, told)
                    self.assertLess(told["mean"], 2e-4 if "stands" in name else 1e-4, told)
                    self.assertGreater(told["contrast"], 0.3, told)


if __name__ == "__main__":
    main(arguments=2)
