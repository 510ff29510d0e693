// SPDX-License-Identifier: MIT
// Runs int f(int, int) for 256 pairs from -8 to 7: GLSL in WebGL2, WGSL in WebGPU.
"use strict";

const fragmentHead = "#version 300 es\nprecision highp float;\nprecision highp int;\n";
const fragmentMain = `
layout(location = 0) out highp ivec4 result;
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy) - 8;
    result = ivec4(f(at.x, at.y));
}`;
const vertexText = `#version 300 es
void main() {
    gl_Position = vec4(vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0), 0.0, 1.0);
}`;
const computeMain = `
@group(0) @binding(0) var<storage, read_write> results: array<i32>;
@compute @workgroup_size(16, 16)
fn run(@builtin(local_invocation_id) id: vec3u) {
    results[id.y * 16u + id.x] = f(i32(id.x) - 8, i32(id.y) - 8);
}`;

function byWebGl(text) {
    const gl = document.createElement("canvas").getContext("webgl2");
    const program = gl.createProgram();
    for (const [stage, code] of [[gl.VERTEX_SHADER, vertexText],
        [gl.FRAGMENT_SHADER, fragmentHead + text + fragmentMain]]) {
        const shader = gl.createShader(stage);
        gl.shaderSource(shader, code);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32I, 16, 16);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D,
        gl.getParameter(gl.TEXTURE_BINDING_2D), 0);
    gl.viewport(0, 0, 16, 16);
    gl.useProgram(program);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const words = new Int32Array(1024);
    gl.readPixels(0, 0, 16, 16, gl.RGBA_INTEGER, gl.INT, words);
    gl.getExtension("WEBGL_lose_context")?.loseContext();  // a page has few contexts
    return Array.from({length: 256}, (_, i) => words[4 * i]);
}

async function byWebGpu(device, text) {
    const module = device.createShaderModule({code: text + computeMain});
    const pipeline = await device.createComputePipelineAsync({layout: "auto", compute: {module}});
    const {STORAGE, COPY_SRC, COPY_DST, MAP_READ} = GPUBufferUsage;
    const results = device.createBuffer({size: 1024, usage: STORAGE | COPY_SRC});
    const copy = device.createBuffer({size: 1024, usage: MAP_READ | COPY_DST});
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, device.createBindGroup({layout: pipeline.getBindGroupLayout(0),
        entries: [{binding: 0, resource: {buffer: results}}]}));
    pass.dispatchWorkgroups(1);
    pass.end();
    encoder.copyBufferToBuffer(results, 0, copy, 0, 1024);
    device.queue.submit([encoder.finish()]);
    await copy.mapAsync(GPUMapMode.READ);
    return [...new Int32Array(copy.getMappedRange())];
}

// Both results for each pair of texts.
async function runPrograms(pairs) {
    const device = await (await navigator.gpu.requestAdapter()).requestDevice();
    const all = [];
    for (const [glsl, wgsl] of pairs) all.push([byWebGl(glsl), await byWebGpu(device, wgsl)]);
    return all;
}
