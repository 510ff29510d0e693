// SPDX-License-Identifier: MIT
// Runs kernels in WebGL2: a fragment evaluates one input. Inputs and images are integer textures, outputs are integer
// targets, so bits arrive unchanged (docs/opengl-and-browsers.md).
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
        const canvas = new OffscreenCanvas(1, 1);
        const gl = canvas.getContext("webgl2", {antialias: false, depth: false, powerPreference: "high-performance"});
        if (gl === null) throw new Error("this browser has no WebGL2");
        const info = gl.getExtension("WEBGL_debug_renderer_info");
        const renderer = gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
        return {
            facts: {renderer, vendor: gl.getParameter(info ? info.UNMASKED_VENDOR_WEBGL : gl.VENDOR),
                version: gl.getParameter(gl.VERSION), type: "webgl", name: "webgl2: " + renderer},
            compile: (text) => compile(gl, gloam.bounded.glsl(text)),
            run: (program, check, data) => gloam.kernel.run(gl, program, check, data),
            drop: (program) => gl.deleteProgram(program),
            isLost: () => gl.isContextLost()
        };
    }

    function compileStage(gl, stage, text) {
        const shader = gl.createShader(stage);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        return shader;
    }

    // The linked program. Throws an Error with the driver's message.
    function compile(gl, text) {
        const stages = [compileStage(gl, gl.VERTEX_SHADER, vertexText), compileStage(gl, gl.FRAGMENT_SHADER, text)];
        const program = gl.createProgram();
        for (const stage of stages) gl.attachShader(program, stage);
        gl.linkProgram(program);
        const linked = gl.getProgramParameter(program, gl.LINK_STATUS);
        const log = linked ? "" : stages.map((stage) => gl.getShaderInfoLog(stage)).join(" ") +
            (gl.getProgramInfoLog(program) ?? "");
        for (const stage of stages) gl.deleteShader(stage);
        if (linked) return program;
        gl.deleteProgram(program);
        throw new Error(gl.isContextLost() ? "the context was lost" : "the kernel does not compile: " + log.trim());
    }

    function integerTexture(gl, unit, internal, format, width, height, words) {
        const texture = gl.createTexture();
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
            gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
        gl.texImage2D(gl.TEXTURE_2D, 0, internal, width, height, 0, format, gl.UNSIGNED_INT, words);
        return texture;
    }

    // A texture that holds words: word i is the texel (i % 2048, i / 2048).
    function wordTexture(gl, unit, words) {
        const height = Math.max(1, Math.ceil(words.length / rowOfTexture));
        const padded = new Uint32Array(height * rowOfTexture);
        padded.set(words);
        return integerTexture(gl, unit, gl.R32UI, gl.RED_INTEGER, rowOfTexture, height, padded);
    }

    // The targets of one draw in a framebuffer.
    function makeTargets(gl, count, height, unit) {
        const framebuffer = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        const textures = [];
        for (let i = 0; i < count; ++i) {
            textures.push(integerTexture(gl, unit, gl.RGBA32UI, gl.RGBA_INTEGER, targetWidth, height, null));
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, textures[i], 0);
        }
        gl.drawBuffers(textures.map((texture, i) => gl.COLOR_ATTACHMENT0 + i));
        const status = gl.checkFramebufferStatus(gl.FRAMEBUFFER);
        if (status !== gl.FRAMEBUFFER_COMPLETE && !gl.isContextLost())
            throw new Error("integer targets are incomplete: status " + status);
        return {framebuffer, textures};
    }

    function setUniforms(gl, program, numbers, samplers) {
        gl.useProgram(program);
        for (const [name, value] of Object.entries(numbers))
            gl.uniform1ui(gl.getUniformLocation(program, name), value);
        samplers.forEach((name, unit) => gl.uniform1i(gl.getUniformLocation(program, name), unit));
    }

    // Draws one pass and copies its words into the rows of all inputs.
    function drawPass(gl, check, count, pass, rows) {
        const height = Math.ceil(count / targetWidth);
        gl.viewport(0, 0, targetWidth, height);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
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
    function drawAll(gl, program, check, data, canary) {
        const textures = [wordTexture(gl, 0, data.inputs)];
        data.images.forEach((image, i) => textures.push(wordTexture(gl, i + 1, image)));
        const targets = makeTargets(gl, check.targets, Math.ceil(data.count / targetWidth), textures.length);
        const samplers = ["gloam_kernel_inputs", ...data.images.map((image, i) => "gloam_kernel_image" + i)];
        const rows = new Uint32Array(data.count * check.row);
        for (let pass = 0; pass * check.targets * wordsOfTarget < check.row; ++pass) {
            setUniforms(gl, program, {gloam_kernel_count: data.count, gloam_kernel_canary: canary,
                gloam_kernel_pass: pass}, samplers);
            // A target may not be bound as a texture while it is drawn to.
            gl.activeTexture(gl.TEXTURE0 + textures.length);
            gl.bindTexture(gl.TEXTURE_2D, null);
            drawPass(gl, check, data.count, pass, rows);
        }
        gl.deleteFramebuffer(targets.framebuffer);
        for (const texture of [...textures, ...targets.textures]) gl.deleteTexture(texture);
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
    function run(gl, program, check, data) {
        const canary = Math.floor(Math.random() * 2 ** 32) >>> 0;
        while (gl.getError() !== gl.NO_ERROR && !gl.isContextLost());
        const rows = drawAll(gl, program, check, data, canary);
        if (gl.isContextLost()) throw new Error("the context was lost");
        const error = gl.getError();
        if (error !== gl.NO_ERROR) throw new Error("WebGL error " + error);
        return outputsOf(check, data, rows, canary);
    }

    return {open, run};
})();
