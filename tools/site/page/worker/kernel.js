// SPDX-License-Identifier: MIT
// Runs kernels in WebGL2: a fragment evaluates one input. Inputs and images are integer textures, outputs are integer
// targets, so bits arrive unchanged (docs/verdicts.md).
"use strict";

gloam.kernel = (() => {
    const rowOfTexture = 2048;  // texels of one row of a texture with words
    const targetWidth = 1024;   // fragments of one row; the kernels have the number in their text
    const wordsOfTarget = 4;
    const vertexText = `#version 300 es
void main() {
    gl_Position = vec4(vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0), 0.0, 1.0);
}`;

    // What is reported of the GPU, and how kernels run. Throws an Error where there is no WebGL2.
    function open() {
        if (typeof OffscreenCanvas === "undefined") throw new Error("this browser has no OffscreenCanvas");
        const gl = new OffscreenCanvas(1, 1).getContext("webgl2", {antialias: false, depth: false,
            powerPreference: "high-performance"});
        if (gl === null) throw new Error("this browser has no WebGL2");
        const passes = new Passes(gl);
        const info = gl.getExtension("WEBGL_debug_renderer_info");
        const renderer = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
        return {
            facts: {renderer, vendor: gl.getParameter(info ? info.UNMASKED_VENDOR_WEBGL : gl.VENDOR),
                version: gl.getParameter(gl.VERSION), type: "webgl", name: "webgl2: " + renderer},
            compile: (text) => passes.linked("the kernel", vertexText, gloam.bounded.glsl(text)),
            run: (program, check, data) => gloam.kernel.run(passes, program, check, data),
            drop: ({handle}) => gl.deleteProgram(handle),
            isLost: () => gl.isContextLost()
        };
    }

    // A texture that holds words: word i is the texel (i % 2048, i / 2048).
    function wordTexture(passes, words) {
        const {gl} = passes;
        const height = Math.max(1, Math.ceil(words.length / rowOfTexture));
        const padded = new Uint32Array(height * rowOfTexture);
        padded.set(words);
        const texture = passes.image("R32UI", [rowOfTexture, height]);
        gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, rowOfTexture, height, gl.RED_INTEGER, gl.UNSIGNED_INT, padded);
        return texture;
    }

    // Copies the words that a pass has drawn into the rows of all inputs.
    function readPass(gl, check, count, pass, rows) {
        const height = Math.ceil(count / targetWidth);
        const words = new Uint32Array(targetWidth * height * wordsOfTarget);
        for (let target = 0; target < check.targets; ++target) {
            gl.readBuffer(gl.COLOR_ATTACHMENT0 + target);
            gl.readPixels(0, 0, targetWidth, height, gl.RGBA_INTEGER, gl.UNSIGNED_INT, words);
            const first = (pass * check.targets + target) * wordsOfTarget;
            for (let k = 0; k < wordsOfTarget && first + k < check.row; ++k)
                for (let i = 0; i < count; ++i) rows[i * check.row + first + k] = words[i * wordsOfTarget + k];
        }
    }

    // What all passes write: check.row words for each input.
    function drawAll(passes, program, check, data, canary) {
        const textures = [data.inputs, ...data.images].map((words) => wordTexture(passes, words));
        const values = {gloam_kernel_inputs: textures[0], gloam_kernel_count: data.count, gloam_kernel_canary: canary};
        data.images.forEach((_, i) => { values["gloam_kernel_image" + i] = textures[i + 1]; });
        const size = [targetWidth, Math.ceil(data.count / targetWidth)];
        const target = passes.target(size, Array.from({length: check.targets}, () => passes.image("RGBA32UI", size)));
        const rows = new Uint32Array(data.count * check.row);
        for (let pass = 0; pass * check.targets * wordsOfTarget < check.row; ++pass) {
            passes.draw(program, {...values, gloam_kernel_pass: pass}, target);
            readPass(passes.gl, check, data.count, pass, rows);
        }
        passes.deleteTarget(target);
        for (const texture of textures) passes.gl.deleteTexture(texture);
        return rows;
    }

    // The outputs without canary and faults. Throws an Error where an input was not evaluated or a pixel outside an
    // image was read.
    function outputsOf(check, data, rows, canary) {
        const width = check.outputs.length;
        const outputs = new Uint32Array(data.count * width);
        let fault = "";
        for (let i = 0; i < data.count; ++i) {
            const row = rows.subarray(i * check.row, (i + 1) * check.row);
            gloam.bounded.requireEnd(row[width], canary, i);
            outputs.set(row.subarray(0, width), i * width);
            if (data.images.length > 0 && row[width + 1] > 0 && fault === "")
                fault = `image ${row[width + 2]}: pixel (${row[width + 3] | 0}, ${row[width + 4] | 0}) is outside`;
        }
        return {outputs, fault};
    }

    // Runs a linked program on the inputs of a decoded scenario.
    function run(passes, program, check, data) {
        const {gl} = passes;
        const canary = Math.floor(Math.random() * 2 ** 32) >>> 0;
        while (gl.getError() !== gl.NO_ERROR && !gl.isContextLost());
        const rows = drawAll(passes, program, check, data, canary);
        if (gl.isContextLost()) throw new Error("the context was lost");
        const error = gl.getError();
        if (error !== gl.NO_ERROR) throw new Error("WebGL error " + error);
        return outputsOf(check, data, rows, canary);
    }

    return {open, run};
})();
