// SPDX-License-Identifier: MIT
// Runs kernels in WebGPU: an invocation of a compute shader evaluates one input (docs/opengl-and-browsers.md).
"use strict";

gloam.webgpu = (() => {
    const groupSize = 64;    // invocations; the kernels have the number in their text
    const faultWords = 5;    // accesses outside an image, and the first one: image, x, y, input

    const limits = ["maxStorageBuffersPerShaderStage", "maxStorageBufferBindingSize", "maxBufferSize"];

    // What is reported of the GPU, and how kernels run. Throws an Error where there is no WebGPU.
    async function open() {
        const adapter = await navigator.gpu?.requestAdapter({powerPreference: "high-performance"});
        if (!adapter) throw new Error("this browser has no WebGPU");
        const requiredLimits = Object.fromEntries(limits.map((name) => [name, adapter.limits[name]]));
        const gpu = await adapter.requestDevice({requiredLimits});
        const state = {lost: false};
        gpu.lost.then(() => { state.lost = true; });
        const {vendor, architecture, device, description} = adapter.info;
        const renderer = description || [vendor, architecture, device].filter((text) => text !== "").join(" ");
        return {
            facts: {renderer, vendor, version: "WebGPU", type: "webgpu", name: "webgpu: " + (renderer || "unknown")},
            compile: (text) => compile(gpu, gloam.bounded.wgsl(text)),
            run: (program, check, data) => gloam.webgpu.run(gpu, program, check, data),
            drop: () => {},
            isLost: () => state.lost
        };
    }

    // The buffers of a kernel: for each group, how each binding is used. The text says it, one line each.
    function layoutsOf(gpu, text) {
        const types = {"storage, read": "read-only-storage", "storage, read_write": "storage", uniform: "uniform"};
        const groups = [[], []];
        for (const [, group, binding, use] of text.matchAll(/@group\((\d)\) @binding\((\d+)\) var<([^>]*)>/g))
            groups[group].push({binding: Number(binding), visibility: GPUShaderStage.COMPUTE,
                buffer: {type: types[use]}});
        return groups.map((entries) => gpu.createBindGroupLayout({entries}));
    }

    // The compiled program. Throws an Error with the compiler's message.
    async function compile(gpu, text) {
        gpu.pushErrorScope("validation");
        const module = gpu.createShaderModule({code: text});
        const layouts = layoutsOf(gpu, text);
        const bindings = new Set([...text.matchAll(/@group\(0\) @binding\((\d+)\)/g)].map((match) => Number(match[1])));
        const pipeline = gpu.createComputePipelineAsync({
            layout: gpu.createPipelineLayout({bindGroupLayouts: layouts}), compute: {module}});
        pipeline.catch(() => {});  // awaited below
        const scope = gpu.popErrorScope();
        const {messages} = await module.getCompilationInfo();
        const errors = messages.filter((message) => message.type === "error");
        if (errors.length > 0)
            throw new Error("the kernel does not compile: " +
                errors.map((message) => `${message.lineNum}: ${message.message}`).join(" "));
        const error = await scope;
        if (error !== null) throw new Error(error.message);
        return {layouts, bindings, pipeline: await pipeline};
    }

    function bufferOf(gpu, words, usage) {
        const buffer = gpu.createBuffer({size: Math.max(4, words.byteLength), usage: usage | GPUBufferUsage.COPY_DST});
        gpu.queue.writeBuffer(buffer, 0, words);
        return buffer;
    }

    // The buffers by their bindings: inputs, outputs, faults, images.
    function buffersOf(gpu, check, data) {
        const {STORAGE, COPY_SRC} = GPUBufferUsage;
        const outputs = new Uint32Array(data.count * (check.outputs.length + 1));
        return [bufferOf(gpu, data.inputs, STORAGE), bufferOf(gpu, outputs, STORAGE | COPY_SRC),
            bufferOf(gpu, new Uint32Array(faultWords), STORAGE | COPY_SRC),
            ...data.images.map((image) => bufferOf(gpu, image, STORAGE))];
    }

    function groupsOf(gpu, program, buffers, run) {
        const entries = buffers.map((buffer, binding) => ({binding, resource: {buffer}}))
            .filter(({binding}) => program.bindings.has(binding));
        return [gpu.createBindGroup({layout: program.layouts[0], entries}),
            gpu.createBindGroup({layout: program.layouts[1], entries: [{binding: 0, resource: {buffer: run}}]})];
    }

    // What the kernel writes: [rows of outputs, faults].
    async function dispatch(gpu, program, check, data, canary) {
        const groups = Math.ceil(data.count / groupSize);
        const run = bufferOf(gpu, new Uint32Array([data.count, groups * groupSize, canary, 0]), GPUBufferUsage.UNIFORM);
        const buffers = buffersOf(gpu, check, data);
        const encoder = gpu.createCommandEncoder();
        const pass = encoder.beginComputePass();
        pass.setPipeline(program.pipeline);
        groupsOf(gpu, program, buffers, run).forEach((group, i) => pass.setBindGroup(i, group));
        pass.dispatchWorkgroups(groups);
        pass.end();
        const copies = [buffers[1], buffers[2]].map((buffer) => {
            const usage = GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST;
            const copy = gpu.createBuffer({size: buffer.size, usage});
            encoder.copyBufferToBuffer(buffer, 0, copy, 0, buffer.size);
            return copy;
        });
        gpu.queue.submit([encoder.finish()]);
        const results = [];
        for (const copy of copies) {
            await copy.mapAsync(GPUMapMode.READ);
            results.push(new Uint32Array(copy.getMappedRange().slice(0)));
        }
        for (const buffer of [...buffers, ...copies, run]) buffer.destroy();
        return results;
    }

    // The outputs without canary and faults. Throws an Error where an input was not evaluated.
    function outputsOf(check, data, rows, faults, canary) {
        const width = check.outputs.length;
        const outputs = new Uint32Array(data.count * width);
        for (let i = 0; i < data.count; ++i) {
            const row = rows.subarray(i * (width + 1), (i + 1) * (width + 1));
            gloam.bounded.requireEnd(row[width], canary, i);
            outputs.set(row.subarray(0, width), i * width);
        }
        const fault = faults[0] === 0 ? "" :
            `image ${faults[1]}: pixel (${faults[2] | 0}, ${faults[3] | 0}) is outside`;
        return {outputs, fault};
    }

    // Runs a linked program on the inputs of a decoded scenario.
    async function run(gpu, program, check, data) {
        const canary = Math.floor(Math.random() * 2 ** 32) >>> 0;
        gpu.pushErrorScope("validation");
        const finished = dispatch(gpu, program, check, data, canary);
        finished.catch(() => {});  // awaited below
        const error = await gpu.popErrorScope();
        const [rows, faults] = await finished;
        if (error !== null) throw new Error("WebGPU: " + error.message);
        return outputsOf(check, data, rows, faults, canary);
    }

    return {open, run};
})();
