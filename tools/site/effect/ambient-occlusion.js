// SPDX-License-Identifier: MIT
// The frame in sequences for any engine of WebGL2: the passes of glsl/passes/frame as fragment shaders. It takes a
// frame's depth and normals, and gives the occlusion. It keeps a history, which follows the camera, and what moves.
// index.d.ts says what its methods take and give.

class AmbientOcclusion {
    constructor(gl, effect, {depth = "buffer", range = "negative-one-to-one", normals = "none", deep = false,
        shown = "occlusion"} = {}) {
        AmbientOcclusion.check(depth, range, normals, shown);
        Object.assign(this, {effect, inputs: {depth, range, deep, shown}, size: null, preset: null, images: null});
        this.stored = normals === "none" ? null : {world_normals: normals.startsWith("world"),
            octahedral_normals: normals.includes("octahedral"), unorm_normals: normals.includes("unorm")};
        this.passes = new Passes(gl);
        this.restored = () => {  // the context, without all that was made in it
            this.passes = new Passes(gl);
            this.images = null;
            this.restart();
        };
        gl.canvas.addEventListener("webglcontextrestored", this.restored);
        this.restart();
    }

    static check(depth, range, normals, shown) {
        for (const [name, value, pattern, expected] of [["depth", depth, /^(linear|buffer)$/, '"linear" or "buffer"'],
            ["range", range, /^(negative-one|zero)-to-one$/, '"negative-one-to-one" or "zero-to-one"'],
            ["shown", shown, /^(occlusion|visibility)$/, '"occlusion" or "visibility"'],
            ["normals", normals, /^(none|(view|world)(-octahedral)?(-unorm)?)$/,
                '"none", or "view" or "world" and "-octahedral", "-unorm" or both behind it']])
            if (!pattern.test(value)) throw new Error(`${name} "${value}": expected ${expected}`);
    }

    setPreset(preset, radius, {resolution = null} = {}) {
        const {presets} = this.effect;
        const named = presets.find(({name}) => name === preset);
        if (!named) throw new Error(`preset "${preset}": expected ${presets.map(({name}) => name).join(", ")}`);
        if (!(radius > 0 && radius <= 1e18)) throw new Error(`radius ${radius}: expected a number above 0`);
        if (![null, "full", "half", "tiles"].includes(resolution))
            throw new Error(`resolution "${resolution}": expected "full", "half" or "tiles"`);
        const {mark} = presets.find((one) => one.mark > 0);  // for a preset that has no tiles
        const found = {...named, resolution: resolution ?? named.resolution, mark: named.mark || mark};
        if (found.resolution !== this.preset?.resolution) this.deleteImages();
        Object.assign(this, {preset: found, radius});
        this.restart();
    }

    setSize(width, height) {
        const most = this.passes.mostPixels;
        for (const side of [width, height])
            if (!Number.isInteger(side) || side < 1 || side > most)
                throw new Error(`size ${width}x${height}: expected whole numbers from 1 to ${most}`);
        this.size = [width, height];
        this.deleteImages();
        this.restart();
    }

    // setPreset() and setSize(), where something is not as it was chosen before.
    choose(preset, radius, size, {resolution = null} = {}) {
        const [chosen, sized] = [String([preset, radius, resolution]), String(size)];
        if (this.chosen !== chosen) this.setPreset(preset, radius, {resolution});
        if (this.sized !== sized) this.setSize(...size);
        Object.assign(this, {chosen, sized});
    }

    restart() {
        this.before = null;  // the camera of the last frame
        this.frames = 0;
    }

    render({depth, normal = null, projection, view, into = null}) {
        if (this.size === null || this.preset === null)
            throw new Error("no size or no preset: setSize() and setPreset() must come before render()");
        const {passes, size, preset} = this;
        if (passes.gl.isContextLost()) return null;
        const now = cameraOf(projection, view, size, this.radius, this.inputs, this.before);
        for (const [name, image] of [["depth", depth], ["normal", this.stored ? normal : depth]])
            if (!image) throw new Error(`${name}: expected a texture`);
        if (this.before?.orthographic !== now.orthographic) this.restart();
        if (this.images?.deep !== now.deep) this.deleteImages();
        this.images ??= this.newImages(now.deep);
        this.drawInto(into ?? this.images.own);
        passes.begin();
        this.drawPasses(preset, {...now, ...sweepValues(now), ...this.historyValues(now), stored_image: depth,
            normal_image: normal ?? depth});
        passes.end();
        this.before = now;
        ++this.frames;
        return this.images.shown;
    }

    // What is kept, in the images of even frames and of odd ones, and what is not.
    newImages(deep) {
        const {passes, size, preset: {resolution}} = this;
        const per = (pixels) => size.map((n) => Math.ceil(n / pixels));
        const target = (format, extent) => passes.target(extent, [passes.image(format, extent)]);
        const texels = (extent) => target(deep ? "RG32UI" : "R32UI", extent);
        const shown = passes.image("R8", size);
        const last = [0, 1].map(() => passes.target(size, [shown, passes.image("RGB10_A2", size, {linear: true})]));
        const images = {deep, own: shown, shown, last,
            levels: [0, 1].map(() => passes.levels(size, deep ? "R32F" : "R16F", 5)),
            texels: texels(resolution === "full" ? size : per(2))};
        if (resolution !== "tiles") return images;
        const fullTexels = texels(size);
        return {...images, fullTexels, marks: target("R8", per(8)),
            joined: last.map((one) => passes.target(size, [...one.images, fullTexels.image]))};
    }

    drawInto(texture) {
        const {passes: {gl}, images} = this;
        if (images.shown === texture) return;
        for (const {framebuffer} of [...images.last, ...images.joined ?? []]) {
            gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
        }
        images.shown = texture;
    }

    // As glsl/passes/frame/gloam_frame.h (gloam_fill) has them.
    historyValues(now) {
        const {before, frames, preset} = this;
        const still = before !== null && ["view", "step", "first"].every((name) =>
            now[name].every((x, i) => x === before[name][i]));
        const range = still ? 1 : preset.range;
        const part = (x) => frames * x % 1;
        return {before: pixelBefore(now, before ?? now), most: before === null ? 0 : (still ? 63 : 7) / 1023, range,
            narrowing: range - 0.01, sharpness: still ? 0 : preset.sharpness, dither: part(0.4142136),
            noise: [part(0.618034), part(0.7548777)]};
    }

    drawPasses({slices, steps, resolution, mark}, values) {
        const {passes, effect, images: {texels, fullTexels, marks, levels, joined, last}, size, frames} = this;
        const [even, odd] = [frames % 2, 1 - frames % 2];
        const all = {...values, depth_image: levels[even][0].image, mark_image: marks?.image, least: mark,
            depth_before_image: levels[odd][0].image, before_image: last[odd].images[1],
            inverse_size: size.map((n) => 1 / n)};
        const common = {orthographic: values.orthographic, deep: values.deep, history: true};
        const swept = {...common, ...this.stored, slices, steps};
        const shown = {...common, visibility: this.inputs.shown === "visibility"};
        const from = this.stored ? "" : "_from_depth";
        // read: the texels that the pass reads. marked: in tiles, of those that are drawn; side: of one, in pixels.
        const draw = (name, constants, target, {read = texels, level = 0, marked = null, side = 8} = {}) => passes.draw(
            passes.program(name, effect[marked === null ? "whole_image" : "tiles"], effect[name], constants),
            {...all, level, marked, texel_image: read.image, inverse_texels: [1 / read.width, 1 / read.height]},
            target, marked === null ? null : {...marks, side});
        levels[even].forEach((target, level) => draw("prepare", common, target, {level}));
        if (resolution !== "tiles") {
            draw("sweep" + from, {...swept, stride: resolution === "half" ? 2 : 1}, texels);
            draw(resolution === "half" ? "join" : "filter", shown, last[even]);
            return;
        }
        draw("sweep" + from, {...swept, slices: 1, steps: effect.steps_before_tiles, stride: 2}, texels);
        draw("mark", {}, marks);
        draw("refine" + from, swept, fullTexels, {marked: 1});
        draw("halve", {}, texels, {read: fullTexels, marked: 1, side: 4});
        draw("join_of_tiles", shown, joined[even], {marked: 0});
        draw("filter_of_tiles", shown, last[even], {read: fullTexels, marked: 1});
    }

    readShown() {
        const {passes: {gl}, size, images} = this;
        const texels = new Uint8Array(4 * size[0] * size[1]);
        gl.bindFramebuffer(gl.FRAMEBUFFER, images.last[0].framebuffer);
        gl.readPixels(0, 0, ...size, gl.RGBA, gl.UNSIGNED_BYTE, texels);
        this.passes.end();
        return Float32Array.from({length: size[0] * size[1]}, (_, i) => texels[4 * i] / 255);
    }

    deleteImages() {
        if (this.images === null) return;
        const {deep, own, shown, ...targets} = this.images;
        for (const target of Object.values(targets).flat(2)) this.passes.deleteTarget(target);
        this.images = null;
    }

    dispose() {
        this.passes.gl.canvas.removeEventListener("webglcontextrestored", this.restored);
        this.deleteImages();
        this.passes.dispose();
    }
}
