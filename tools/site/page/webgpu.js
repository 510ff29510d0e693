// SPDX-License-Identifier: MIT
// Runs the passes of the page in WebGPU, as gloam.WebGl2 does in WebGL2: with the same methods and values. A shader is
// an object as tools/site/page_data.hpp has it. A draw is submitted at once, so its values may stand where those of the
// last one stood.
"use strict";

gloam.WebGpu = class {
    // Throws an Error where there is no WebGPU.
    static async open(canvas) {
        const adapter = await navigator.gpu?.requestAdapter({powerPreference: "high-performance"});
        if (!adapter) throw new Error("this browser has no WebGPU");
        const requiredFeatures = ["timestamp-query"].filter((feature) => adapter.features.has(feature));
        const device = await adapter.requestDevice({requiredFeatures});
        const context = canvas.getContext("webgpu");
        if (context === null) throw new Error("this browser has no canvas of WebGPU");
        return new gloam.WebGpu(device, context);
    }

    constructor(device, context) {
        this.device = device;
        this.context = context;
        this.programs = new Map();
        this.views = new WeakMap();
        this.nothing = this.texture("r32float", 1, 1);  // in the place of an image that is not read
        this.timer = new gloam.WebGpuTimer(device);
        this.api = "webgpu";
        this.zeroToOne = true;  // the range of z in clip space
        this.bottomUp = false;  // row 0 of the canvas is its top row
        context.configure({device, format: gloam.WebGpu.canvasFormat, alphaMode: "opaque",
            usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC});
        // Why it cannot go on: a lost device, or a draw that WebGPU refuses.
        this.lost = new Promise((resolve) => { this.fail = resolve; });
        device.lost.then(({message}) => this.fail(message || "the device was lost"));
        device.addEventListener("uncapturederror", ({error}) => this.fail(error.message));
    }

    static canvasFormat = "rgba8unorm";

    get mostPixels() {
        return this.device.limits.maxTextureDimension2D;
    }

    // Compiled once for each name and its constants. The formats of what it draws to are known when it first draws.
    program(name, vertices, fragments, constants = {}) {
        const key = `${name} ${JSON.stringify(constants)}`;
        if (!this.programs.has(key)) this.programs.set(key, this.compiled(name, vertices, fragments, constants));
        return this.programs.get(key);
    }

    compiled(name, vertices, fragments, constants) {
        const numbers = Object.entries(constants).map(([constant, value]) => {
            if (!(constant in fragments.constants)) throw new Error(`${name} has no constant ${constant}`);
            return [fragments.constants[constant], Number(value)];
        });
        const stages = [[fragments, GPUShaderStage.FRAGMENT], [vertices, GPUShaderStage.VERTEX]];
        const groups = stages.map(([shader, visibility]) => this.group(shader, visibility));
        return {name, groups, constants: Object.fromEntries(numbers), pipelines: new Map(),
            layout: this.device.createPipelineLayout({bindGroupLayouts: groups.map(({layout}) => layout)}),
            modules: stages.map(([{text}]) => this.module(name, text))};
    }

    module(name, code) {
        this.device.pushErrorScope("validation");
        const module = this.device.createShaderModule({label: name, code});
        this.device.popErrorScope().then((error) => {
            if (error !== null) this.fail(`${name} does not compile: ${error.message}`);
        }, () => {});  // a lost device tells of itself
        return module;
    }

    // What a shader reads: its values and images.
    group({bytes, values, images}, visibility) {
        const entries = images.map(([, binding]) =>
            ({binding, visibility, texture: {sampleType: "unfilterable-float"}}));
        if (bytes > 0) entries.push({binding: 0, visibility, buffer: {type: "uniform"}});
        const usage = GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST;
        return {values, images, layout: this.device.createBindGroupLayout({entries}),
            data: new DataView(new ArrayBuffer(bytes)),
            buffer: bytes > 0 ? this.device.createBuffer({size: bytes, usage}) : null};
    }

    // The pipeline of a program for targets of these formats.
    pipeline(program, formats, more) {
        const key = formats.join();
        if (!program.pipelines.has(key)) {
            const [fragment, vertex] = program.modules;
            program.pipelines.set(key, this.device.createRenderPipeline({label: program.name, layout: program.layout,
                vertex: {module: vertex, buffers: more.buffers ?? []}, depthStencil: more.depthStencil,
                fragment: {module: fragment, constants: program.constants,
                    targets: formats.map((format) => ({format}))}}));
        }
        return program.pipelines.get(key);
    }

    texture(format, width, height) {
        const {TEXTURE_BINDING, RENDER_ATTACHMENT, COPY_SRC, COPY_DST} = GPUTextureUsage;
        return this.device.createTexture({size: [width, height], format,
            usage: TEXTURE_BINDING | RENDER_ATTACHMENT | (format.startsWith("depth") ? 0 : COPY_SRC | COPY_DST)});
    }

    target(width, height, ...formats) {
        const images = formats.map((format) => this.texture(format, width, height));
        return {width, height, formats, images, image: images[0]};
    }

    meshTarget(width, height, ...formats) {
        return {...this.target(width, height, ...formats), depthBuffer: this.texture("depth32float", width, height)};
    }

    deleteTarget({images, depthBuffer}) {
        for (const image of images) image.destroy();
        depthBuffer?.destroy();
    }

    get screen() {
        const texture = this.context.getCurrentTexture();
        return {width: texture.width, height: texture.height, formats: [gloam.WebGpu.canvasFormat], images: [texture]};
    }

    viewOf(image) {
        if (!this.views.has(image)) this.views.set(image, image.createView());
        return this.views.get(image);
    }

    // Passes leave no state behind.
    begin() {}

    end() {}

    clear(target) {
        this.render(target, () => {});
    }

    // Clears a target and runs `draws` with its pass.
    render({images, depthBuffer}, draws) {
        const encoder = this.device.createCommandEncoder();
        const pass = encoder.beginRenderPass({...this.timer.writes(),
            colorAttachments: images.map((image) => ({view: this.viewOf(image), clearValue: [0, 0, 0, 0],
                loadOp: "clear", storeOp: "store"})),
            ...depthBuffer && {depthStencilAttachment: {view: this.viewOf(depthBuffer), depthClearValue: 1,
                depthLoadOp: "clear", depthStoreOp: "discard"}}});
        draws(pass);
        pass.end();
        this.device.queue.submit([encoder.finish()]);
    }

    // The values of a shader by their names, as Passes.use() takes them, and its images.
    bound({layout, values, images, data, buffer}, named, program) {
        const valueOf = (name) => {
            if (named[name] === undefined) throw new Error(`${program.name}: there is no value of the name ${name}`);
            return named[name];
        };
        for (const [name, type, offset] of values) gloam.WebGpu.setValue(data, type, offset, valueOf(name));
        const entries = images.map(([name, binding]) =>
            ({binding, resource: this.viewOf(valueOf(name) ?? this.nothing)}));
        if (buffer !== null) {
            this.device.queue.writeBuffer(buffer, 0, data);
            entries.push({binding: 0, resource: {buffer}});
        }
        return this.device.createBindGroup({layout, entries});
    }

    // Of a uniform buffer of std140. null is infinity.
    static setValue(data, type, offset, value) {
        const rows = type.startsWith("mat") ? Number(type.at(-1)) : Infinity;
        const set = {i: "setInt32", u: "setUint32"}[type[0]] ?? "setFloat32";
        [value ?? Infinity].flat().forEach((number, i) => data[set](
            offset + 4 * (rows === Infinity ? i : 4 * Math.floor(i / rows) + i % rows), Number(number), true));
    }

    // Draws the whole of a target.
    draw(program, values, target) {
        this.drawWith(program, values, target, {}, (pass) => pass.draw(3));
    }

    drawWith(program, values, target, more, draws) {
        const pipeline = this.pipeline(program, target.formats, more);
        const groups = program.groups.map((group) => this.bound(group, values, program));
        this.render(target, (pass) => {
            pass.setPipeline(pipeline);
            groups.forEach((group, i) => pass.setBindGroup(i, group));
            draws(pass);
        });
    }

    mesh({positions, normals, colors, indices}) {
        const filled = (data, usage) => {
            const buffer = this.device.createBuffer({size: data.byteLength, usage: usage | GPUBufferUsage.COPY_DST});
            this.device.queue.writeBuffer(buffer, 0, data);
            return buffer;
        };
        return {vertices: [positions, normals, colors].map((data) => filled(data, GPUBufferUsage.VERTEX)),
            indices: filled(indices, GPUBufferUsage.INDEX), count: indices.length};
    }

    deleteMesh({vertices, indices}) {
        for (const buffer of [...vertices, indices]) buffer.destroy();
    }

    drawMesh(program, values, target, mesh) {
        const buffers = [["float32x3", 12], ["float32x3", 12], ["unorm8x4", 4]].map(([format, arrayStride],
            shaderLocation) => ({arrayStride, attributes: [{format, offset: 0, shaderLocation}]}));
        const depthStencil = {format: "depth32float", depthWriteEnabled: true, depthCompare: "less"};
        this.drawWith(program, values, target, {buffers, depthStencil}, (pass) => {
            mesh.vertices.forEach((buffer, i) => pass.setVertexBuffer(i, buffer));
            pass.setIndexBuffer(mesh.indices, "uint32");
            pass.drawIndexed(mesh.count);
        });
    }

    fill({image, width, height}, floats) {
        this.device.queue.writeTexture({texture: image}, floats, {bytesPerRow: 4 * width}, [width, height]);
    }

    copyOf({images, width, height, formats}) {
        const copy = this.target(width, height, ...formats);
        const encoder = this.device.createCommandEncoder();
        images.forEach((texture, i) =>
            encoder.copyTextureToTexture({texture}, {texture: copy.images[i]}, [width, height]));
        this.device.queue.submit([encoder.finish()]);
        return copy;
    }

    // Until the frame before this one is finished: unlike WebGL2, WebGPU takes any number of frames that wait.
    async paced() {
        const before = this.submitted;
        this.submitted = this.device.queue.onSubmittedWorkDone().catch(() => {});  // `lost` tells of a lost device
        await before;
    }

    // In the place of what a lost device would have said. The loss itself is told by `lost`.
    static neverAnswered = () => new Promise(() => {});

    // As Passes.read() gives it: a promise.
    async read({image, width, height, formats}, channels = 4) {
        const stored = formats[0] === "rgba32float" ? 4 : 1;
        const rowFloats = Math.ceil(width * stored / 64) * 64;
        const buffer = this.device.createBuffer({size: 4 * rowFloats * height,
            usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST});
        const encoder = this.device.createCommandEncoder();
        encoder.copyTextureToBuffer({texture: image}, {buffer, bytesPerRow: 4 * rowFloats}, [width, height]);
        this.device.queue.submit([encoder.finish()]);
        await buffer.mapAsync(GPUMapMode.READ).catch(gloam.WebGpu.neverAnswered);
        const floats = new Float32Array(buffer.getMappedRange());
        const texels = new Float32Array(channels * width * height);
        for (let i = 0; i < texels.length; ++i) {
            const [pixel, channel] = [Math.floor(i / channels), i % channels];
            const at = Math.floor(pixel / width) * rowFloats + pixel % width * stored + channel;
            texels[i] = channel < stored ? floats[at] : Number(channel === 3);  // as WebGL reads one channel
        }
        buffer.destroy();
        return texels;
    }

    close() {
        this.context.unconfigure();
        this.device.destroy();
    }
};

// Times of the GPU, where the device has timestamps: the sum of the passes that the measured work runs.
gloam.WebGpuTimer = class {
    static most = 32;  // passes

    constructor(device) {
        this.device = device;
        this.ms = null;  // of the last work whose time is known
        this.count = null;  // passes so far, while work is measured
        this.busy = false;
        if (!device.features.has("timestamp-query")) return;
        const {most} = gloam.WebGpuTimer;
        const {QUERY_RESOLVE, COPY_SRC, COPY_DST, MAP_READ} = GPUBufferUsage;
        this.queries = device.createQuerySet({type: "timestamp", count: 2 * most});
        this.resolved = device.createBuffer({size: 16 * most, usage: QUERY_RESOLVE | COPY_SRC});
        this.copy = device.createBuffer({size: 16 * most, usage: COPY_DST | MAP_READ});
    }

    // What a pass adds to its descriptor.
    writes() {
        if (this.count === null || this.count === gloam.WebGpuTimer.most) return {};
        const first = 2 * this.count++;
        return {timestampWrites: {querySet: this.queries, beginningOfPassWriteIndex: first,
            endOfPassWriteIndex: first + 1}};
    }

    // Runs work, and asks for its time if the last one is known.
    measure(work) {
        if (!this.queries || this.busy) {
            work();
            return;
        }
        this.count = 0;
        work();
        const {count} = this;
        this.count = null;
        this.ask(count);
    }

    async ask(count) {
        if (count === 0) return;
        this.busy = true;
        const encoder = this.device.createCommandEncoder();
        encoder.resolveQuerySet(this.queries, 0, 2 * count, this.resolved, 0);
        encoder.copyBufferToBuffer(this.resolved, 0, this.copy, 0, 16 * count);
        this.device.queue.submit([encoder.finish()]);
        await this.copy.mapAsync(GPUMapMode.READ).catch(gloam.WebGpu.neverAnswered);
        const times = new BigUint64Array(this.copy.getMappedRange(0, 16 * count));
        let sum = 0n;
        for (let i = 0; i < times.length; i += 2) sum += times[i + 1] - times[i];
        this.ms = Number(sum) / 1e6;
        this.copy.unmap();
        this.busy = false;
    }
};
