// SPDX-License-Identifier: MIT
// One view, a floor before a wall, as engines store it in textures: depth buffers of all projections, normals of all
// encodings. `encodings` gives the occlusion of each.
import {AmbientOcclusion, effect} from "gloam";

const [width, height] = [61, 47];
const [near, far] = [0.1, 50];
const scale = [1.3, 1.7];  // elements [0][0] and [1][1] of the projection
const turn = [0.8, 0, -0.6, 0, 1, 0, 0.6, 0, 0.8];  // world to view, column by column
const view = [...turn.slice(0, 3), 0, ...turn.slice(3, 6), 0, ...turn.slice(6), 0, 3, -2, 5, 1];

// Elements [2][2] and [3][2].
const planes = {
    standard: [-(far + near) / (far - near), -2 * far * near / (far - near)],
    infinite: [-1, -2 * near],
    reversed: [(far + near) / (far - near), 2 * far * near / (far - near)],
    zeroToOne: [far / (near - far), far * near / (near - far)],
    reversedInfinite: [0, near],
    orthographic: [-2 / (far - near), -(far + near) / (far - near)],
    orthographicReversed: [1 / (far - near), far / (far - near)],
};

function projectionOf(name) {
    const orthographic = name.startsWith("orthographic");
    const [p22, p32] = planes[name];
    return [scale[0], 0, 0, 0, 0, scale[1], 0, 0, 0, 0, p22, orthographic ? 0 : -1, 0, 0, p32, orthographic ? 1 : 0];
}

// What a pixel shows: its eye-linear depth, and the normal in view space.
function surface(x, y, orthographic) {
    const ndc = [2 * (x + 0.5) / width - 1, 2 * (y + 0.5) / height - 1];
    const up = ndc[1] / scale[1];
    const wall = {depth: 4, normal: [0, 0, 1]};
    if (y > height - 4) return {depth: Infinity, normal: [0, 0, 0]};
    if (up >= 0) return wall;
    if (orthographic) return up > -0.2 ? wall : {depth: 4.2 + up, normal: [0, Math.SQRT1_2, Math.SQRT1_2]};
    return -1 / up < wall.depth ? {depth: -1 / up, normal: [0, 1, 0]} : wall;
}

// As the engine's depth buffer has it, 0 to 1.
function buffered(depth, projection, range) {
    const [p22, p32] = [projection[10], projection[14]];
    const clip = projection[11] === 0 ? p32 - p22 * depth : (p32 - p22 * depth) / depth;
    if (depth === Infinity) return p22 > (projection[11] === 0 ? 0 : -0.5) ? 0 : 1;
    return range === "zero-to-one" ? clip : (clip + 1) / 2;
}

function stored(normal, kind) {
    let n = normal;
    if (kind.startsWith("world")) n = [0, 1, 2].map((i) => turn.slice(3 * i, 3 * i + 3)
        .reduce((sum, r, k) => sum + r * normal[k], 0));
    if (kind.includes("octahedral")) {
        const [x, y] = n.map((c) => c / (Math.abs(n[0]) + Math.abs(n[1]) + Math.abs(n[2]) || 1));
        n = n[2] >= 0 ? [x, y, 0] : [(1 - Math.abs(y)) * (x < 0 ? -1 : 1), (1 - Math.abs(x)) * (y < 0 ? -1 : 1), 0];
    }
    return kind.includes("unorm") ? n.map((c) => (c + 1) / 2) : n;
}

function texture(gl, texels) {
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, new Float32Array(texels));
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
        gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
    return gl.getParameter(gl.TEXTURE_BINDING_2D);
}

// The occlusion after three frames.
function occlusionOf(gl, name, inputs) {
    const projection = projectionOf(name);
    const pixels = Array.from({length: width * height}, (_, i) =>
        surface(i % width, Math.floor(i / width), projection[11] === 0));
    const depth = texture(gl, pixels.flatMap((one) => inputs.depth === "linear" ? [one.depth, 0, 0, 0]
        : [buffered(one.depth, projection, inputs.range), 0, 0, 0]));
    const normal = inputs.normals === "none" ? null
        : texture(gl, pixels.flatMap((one) => [...stored(one.normal, inputs.normals), 0]));
    const occlusion = new AmbientOcclusion(gl, effect, inputs);
    occlusion.setPreset("balanced", 1);
    occlusion.setSize(width, height);
    for (let i = 0; i < 3; ++i) occlusion.render({depth, normal, projection, view});
    const result = occlusion.readOcclusion();
    occlusion.dispose();
    return result;
}

// [what it is, its occlusion, that of eye-linear depth and normals in view space] of every encoding.
export function encodings() {
    const gl = document.createElement("canvas").getContext("webgl2");
    const ranges = {zeroToOne: "zero-to-one", reversedInfinite: "zero-to-one", orthographicReversed: "zero-to-one"};
    const plain = {depth: "linear", normals: "view"};
    const known = {perspective: occlusionOf(gl, "standard", plain),
        orthographic: occlusionOf(gl, "orthographic", plain)};
    const kinds = ["view", "world", "view-octahedral", "world-octahedral", "world-unorm", "world-octahedral-unorm",
        "none"];
    const cases = Object.keys(planes).map((name, i) => [name, kinds[i]]);
    cases.push(...kinds.map((kind) => ["standard", kind]));
    return cases.map(([name, normals]) => [`${name}, ${normals}`, occlusionOf(gl, name,
        {depth: "buffer", range: ranges[name] ?? "negative-one-to-one", normals}),
    known[name.startsWith("orthographic") ? "orthographic" : "perspective"]]);
}
