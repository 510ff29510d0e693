// SPDX-License-Identifier: MIT
// Runs the passes that `gloam pack --effect --target wgsl` wrote, on one frame without a history.
"use strict";

const formats = {VK_FORMAT_R32_SFLOAT: "r32float", VK_FORMAT_R32G32B32A32_SFLOAT: "rgba32float",
    VK_FORMAT_R16G16B16A16_SFLOAT: "rgba16float", VK_FORMAT_R16G16B16A16_UINT: "rgba16uint",
    VK_FORMAT_R32_UINT: "r32uint"};
const channels = {r32float: 1, rgba32float: 4};

const floatsOf = (text) => new Float32Array(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer);

// The textures and buffers of the effect by their names. `given`: floats of images as base64.
function resourcesOf(device, effect, given) {
    const {TEXTURE_BINDING, STORAGE_BINDING, COPY_DST, COPY_SRC} = GPUTextureUsage;
    const resources = new Map();
    for (const image of effect.images) {
        const format = formats[image.format];
        const texture = device.createTexture({size: [image.width, image.height], format,
            usage: TEXTURE_BINDING | STORAGE_BINDING | COPY_DST | COPY_SRC});
        resources.set(image.name, texture);
        if (image.name in given)
            device.queue.writeTexture({texture}, floatsOf(given[image.name]),
                {bytesPerRow: image.width * channels[format] * 4}, [image.width, image.height]);
    }
    for (const buffer of effect.buffers) {
        const made = device.createBuffer({size: Math.max(16, Math.ceil(buffer.bytes / 4) * 4),
            usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST});
        device.queue.writeBuffer(made, 0, new Uint32Array(buffer.contents));
        resources.set(buffer.name, made);
    }
    return resources;
}

// The push constants: those of the file, with others in the place of those that depend on the view.
function constantsOf(device, pass, view) {
    const words = new Uint32Array(Math.ceil(pass.push_constants.bytes / 16) * 4);
    words.set(pass.push_constants.preset);
    for (const member of pass.push_constants.members)
        if (member.name in view)
            words.set(new Uint32Array(new Float32Array(view[member.name]).buffer), member.offset / 4);
    const usage = GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST;
    const buffer = device.createBuffer({size: words.byteLength, usage});
    device.queue.writeBuffer(buffer, 0, words);
    return buffer;
}

const emptyBuffer = (device) => device.createBuffer({size: 256, usage: GPUBufferUsage.STORAGE});

async function runPass(device, effect, pass, text, resources, view) {
    const module = device.createShaderModule({code: text});
    const pipeline = await device.createComputePipelineAsync({layout: "auto", compute: {module}});
    const entries = pass.bindings.filter(({binding}) => text.includes(`@group(0) @binding(${binding}) `))
        .map(({binding, resource}) => {
            // WebGPU lets a pass write a buffer only where no other of its bindings is the same buffer.
            const bound = resource === "no_buffer" ? emptyBuffer(device) : resources.get(resource);
            return {binding, resource: bound instanceof GPUBuffer ? {buffer: bound} : bound.createView()};
        });
    const groups = pass.groups ?? [Math.ceil(effect.view.width / pass.pixels_of_a_group[0]),
        Math.ceil(effect.view.height / pass.pixels_of_a_group[1]), 1];
    const encoder = device.createCommandEncoder();
    const commands = encoder.beginComputePass();
    commands.setPipeline(pipeline);
    commands.setBindGroup(0, device.createBindGroup({layout: pipeline.getBindGroupLayout(0), entries}));
    if (text.includes("@group(1) @binding(0)"))
        commands.setBindGroup(1, device.createBindGroup({layout: pipeline.getBindGroupLayout(1),
            entries: [{binding: 0, resource: {buffer: constantsOf(device, pass, view)}}]}));
    commands.dispatchWorkgroups(...groups);
    commands.end();
    device.queue.submit([encoder.finish()]);
}

// The first channel of an image of floats, row by row.
async function firstChannel(device, texture) {
    const count = channels[texture.format];
    const bytesPerRow = Math.ceil(texture.width * count * 4 / 256) * 256;
    const copy = device.createBuffer({size: bytesPerRow * texture.height,
        usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST});
    const encoder = device.createCommandEncoder();
    encoder.copyTextureToBuffer({texture}, {buffer: copy, bytesPerRow}, [texture.width, texture.height]);
    device.queue.submit([encoder.finish()]);
    await copy.mapAsync(GPUMapMode.READ);
    const all = new Float32Array(copy.getMappedRange());
    return Array.from({length: texture.width * texture.height}, (_, i) =>
        all[Math.floor(i / texture.width) * bytesPerRow / 4 + i % texture.width * count]);
}

// The first channel of an image, by default the occlusion. `texts`: of the passes by their names; `given`: images;
// `view`: values of push constants by names.
async function runEffect(effect, texts, given, view, image = effect.result.image) {
    const adapter = await navigator.gpu.requestAdapter();
    const device = await adapter.requestDevice();
    device.pushErrorScope("validation");
    const resources = resourcesOf(device, effect, given);
    for (const pass of effect.passes)
        if (pass.turn !== "moved") await runPass(device, effect, pass, texts[pass.name], resources, view);
    const result = await firstChannel(device, resources.get(image));
    const error = await device.popErrorScope();
    if (error !== null) throw new Error(error.message);
    return result;
}

// The messages of the compiler for each text; empty where it has accepted the text.
async function compileAll(texts) {
    const adapter = await navigator.gpu.requestAdapter();
    const extensions = ["shader-f16", "subgroups"].filter((feature) => adapter.features.has(feature));
    const device = await adapter.requestDevice({requiredFeatures: extensions});
    const results = [];
    for (const code of texts) {
        device.pushErrorScope("validation");
        const {messages} = await device.createShaderModule({code}).getCompilationInfo();
        await device.popErrorScope();
        results.push(messages.filter(({type}) => type === "error").map((m) => `${m.lineNum}: ${m.message}`).join(" "));
    }
    return results;
}
