// SPDX-License-Identifier: MIT
// The single frame in WebGL2: the passes of glsl/passes/frame as fragment shaders.

class Frame {
    // passes: a Passes. texts: of whole_image.vert and of the four passes, by their names, in GLSL ES 3.00. inputs: as
    // AmbientOcclusion has them; normals "none" are made from depth.
    constructor(passes, texts, {depth, range, normals}) {
        this.passes = passes;
        this.texts = texts;
        this.inputs = {depth, range};
        this.normals = {world_normals: normals.startsWith("world"), octahedral_normals: normals.includes("octahedral"),
            unorm_normals: normals.includes("unorm"), normals_from_depth: normals === "none"};
    }

    // preset: {slices, steps, half, half_width}. radius: world units. depth, normal: textures of this size, as they are
    // stored. projection, view: 16 numbers each, column by column.
    // Returns a target whose first channel is the occlusion; it belongs to the caller, who deletes it.
    render(preset, {depth, normal, projection, view, radius, size}) {
        const {passes} = this;
        const swept = preset.half ? size.map((n) => Math.floor((n + 1) / 2)) : size;
        const {orthographic, values} = this.sweepValues(projection, view, radius, size);
        passes.begin();
        const levels = passes.levels(...size, "r16float", Frame.levels);
        levels.forEach((target, level) => this.draw("prepare", {},
            {...this.depthValues(projection, radius), stored_image: depth, level}, target));
        const texels = this.draw("sweep", {...this.normals, orthographic, slices: preset.slices, steps: preset.steps,
            stride: preset.half ? 2 : 1}, {...values, ...this.depthValues(projection, radius),
                depth_image: levels[0].image, normal_image: normal || depth}, passes.target(...swept, "r32uint"));
        const shown = this.draw(preset.half ? "join" : "filter", preset.half ? {} : {half_width: preset.half_width},
            {...Frame.noHistory, texel_image: texels.image, depth_image: levels[0].image,
                inverse_size: size.map((n) => 1 / n), inverse_half_size: swept.map((n) => 1 / n)},
            passes.target(...size, "r32float"));
        for (const target of [...levels, texels]) passes.deleteTarget(target);
        passes.end();
        return shown;
    }

    draw(name, constants, values, target) {
        const {passes, texts} = this;
        passes.draw(passes.program(name, texts.whole_image, texts[name], constants), values, target);
        return target;
    }

    // What makes depth in radii of a stored one (gloam_level_depth).
    depthValues(projection, radius) {
        if (this.inputs.depth === "linear") return {numerator: [0, 1 / radius], divisor: [1, 0], far: null};
        const [p22, p32, orthographic] = [projection[10], projection[14], projection[11] === 0];
        const [scale, offset] = this.inputs.range === "zero-to-one" ? [1, 0] : [2, -1];  // from stored to clip space
        const reversed = p22 > (orthographic || offset !== 0 ? 0 : -0.5);
        const near = (p32 - offset - (reversed ? scale : 0)) / p22;  // orthographic
        const before = near > 0 ? 0 : radius - near;
        return {far: reversed ? 0 : 1, ...(orthographic
            ? {numerator: [p32 - offset + before * p22, -scale].map((x) => x / (p22 * radius)), divisor: [1, 0]}
            : {numerator: [p32 / radius, 0], divisor: [p22 + offset, scale]})};
    }

    sweepValues(projection, view, radius, size) {
        const orthographic = projection[11] === 0;
        const unit = orthographic ? radius : 1;
        const scale = [projection[0], projection[5]];
        const step = scale.map((p, axis) => 2 / (size[axis] * p));
        const last = size.map((n) => Math.max(n - 1, 1));
        return {orthographic, values: {
            view_from_world: [0, 1, 2].flatMap((column) => [...view.slice(4 * column, 4 * column + 3), 0]),
            inverse_span: last.map((n) => 1 / n), first: size.map((n) => 0.5 / n),
            span: last.map((n, axis) => n / size[axis]), ray_span: step.map((x, axis) => x * last[axis] / unit),
            first_ray: step.map((x, axis) => (projection[8 + axis] - 1) / scale[axis] + 0.5 * x),
            noise: [0, 0], reach: step.map((x) => unit / x)}};
    }

    // Of what a single frame does not read.
    static noHistory = {before: Array(12).fill(0), most: 0, range: 0, narrowing: 0, sharpness: 0, dither: 0,
        before_image: null, depth_before_image: null};

    static levels = 5;
}
