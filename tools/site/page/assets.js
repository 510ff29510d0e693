// SPDX-License-Identifier: MIT
// What the page loads on demand: scenes (scene-NAME.js, tools/site/scene_data.cpp) and methods (method-NAME.js).
"use strict";

// The methods that were loaded, by their names.
gloam.methods = new Map();

gloam.addMethod = (method) => gloam.methods.set(method.name, method);

// A method as AmbientOcclusion.setMethod() takes it.
gloam.method = async (name) => {
    if (!gloam.methods.has(name)) await gloam.loadScript(`method-${name}.js`);
    return gloam.methods.get(name);
};

// The scenes that were loaded, by their names: triangles in the arrays that WebGL takes, and a camera's path.
gloam.scenes = new Map();

gloam.scene = async (name) => {
    if (!gloam.scenes.has(name)) await gloam.loadScript(`scene-${name}.js`);
    return gloam.scenes.get(name);
};

// Ray-traced truth of the first views, by their scenes: {picture, width, height, rays}, filled by truth-NAME.js.
gloam.truths = new Map();

// The truth of a scene's first view at this size, of which visibility is the picture, and what it is.
gloam.truth = async (name, {width, height}) => {
    if (!gloam.truths.has(name)) await gloam.loadScript(`truth-${name}.js`);
    const {picture, rays, ...traced} = gloam.truths.get(name);
    const image = new Image();
    image.src = "data:image/png;base64," + picture;
    await image.decode();
    const context = new OffscreenCanvas(width, height).getContext("2d");
    context.drawImage(image, 0, 0, width, height);
    const bytes = context.getImageData(0, 0, width, height).data;
    return {occlusion: Float32Array.from({length: width * height}, (_, i) => 1 - bytes[4 * i] / 255),
        told: `truth: ${rays} rays a pixel of ${traced.width}x${traced.height}`};
};

// The numbers of a stream (Stream of tools/site/scene_data.cpp).
gloam.numbers = (text) => {
    const numbers = [];
    let next = 0;
    let [distance, shift] = [0, 0];
    for (const byte of gloam.bytes(text)) {
        distance |= (byte & 127) << shift;
        shift += 7;
        if (byte > 127) continue;
        numbers.push(next - distance);
        next = Math.max(next, next - distance + 1);
        [distance, shift] = [0, 0];
    }
    return numbers;
};

gloam.addScene = (packed) => {
    const floats = new Float32Array(gloam.bytes(packed.floats).buffer);
    const triples = (streams) => {
        const [a, b, c] = streams.map(gloam.numbers);
        return a.map((first, i) => [first, b[i], c[i]]);
    };
    const vectors = (streams) => triples(streams).map((triple) => triple.map((number) => floats[number]));
    const [points, directions] = [packed.points, packed.directions].map(vectors);
    const palette = gloam.bytes(packed.palette);
    const vertices = triples(packed.vertices);
    const scene = {name: packed.name, radius: packed.radius, fovy: packed.fovy, near: packed.near, far: packed.far,
        frames: packed.frames, cameras: gloam.doubles(packed.cameras),
        positions: new Float32Array(3 * vertices.length), normals: new Float32Array(3 * vertices.length),
        colors: new Uint8Array(4 * vertices.length).fill(255),
        indices: Uint32Array.from(gloam.numbers(packed.indices))};
    vertices.forEach(([point, direction, color], i) => {
        scene.positions.set(points[point], 3 * i);
        scene.normals.set(directions[direction], 3 * i);
        scene.colors.set(palette.subarray(3 * color, 3 * color + 3), 4 * i);
    });
    gloam.scenes.set(packed.name, scene);
};
