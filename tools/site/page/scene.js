// SPDX-License-Identifier: MIT
// Scenes of the page, loaded when they are chosen (scene-NAME.js, tools/site/scene_data.cpp), and their cameras.
"use strict";

// The values of a type, Float64Array for one, from their compressed bytes as base64 (live_page.cpp).
gloam.values = async (Type, text) => {
    const packed = new Blob([Uint8Array.from(atob(text), (character) => character.charCodeAt(0))]);
    const bytes = packed.stream().pipeThrough(new DecompressionStream("deflate"));
    return new Type(await new Response(bytes).arrayBuffer());
};

// The scenes that were loaded, by their names.
gloam.scenes = new Map();

// fetch() of a file is refused on file://, a script is not.
gloam.scene = async (name) => {
    const src = `scene-${name}.js`;
    if (!gloam.scenes.has(name)) await new Promise((resolve, reject) => {
        document.head.append(Object.assign(document.createElement("script"), {src, onload: resolve,
            onerror: () => reject(new Error("cannot load " + src))}));
    });
    return gloam.scenes.get(name);
};

gloam.addScene = ({vertices, indices, path, ...scene}) => gloam.scenes.set(scene.name, (async () => ({...scene,
    vertices: await gloam.values(Uint8Array, vertices), indices: await gloam.values(Uint32Array, indices),
    path: await gloam.values(Float64Array, path)}))());

// The camera of a frame on a scene's path: the eye and the point that it looks at.
gloam.cameraAt = ({path}, frame) => ({eye: Array.from(path.slice(6 * frame, 6 * frame + 3)),
    target: Array.from(path.slice(6 * frame + 3, 6 * frame + 6))});

// World to view of such a camera, column by column, in double as harness/occlusion/scene/camera.cpp has it. The world's
// y points up.
gloam.viewOf = ({eye, target}) => {
    const unit = (v) => v.map((x) => x / Math.hypot(...v));
    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const ahead = unit(target.map((x, k) => x - eye[k]));
    const right = unit(cross(ahead, [0, 1, 0]));
    const rows = [right, cross(right, ahead), ahead.map((x) => -x)];
    const moved = rows.map((row) => -row.reduce((sum, x, k) => sum + x * eye[k], 0));
    return [...[0, 1, 2].flatMap((k) => [...rows.map((row) => row[k]), 0]), ...moved, 1];
};

// View to clip as Vulkan has it: y down, z in [0, 1].
gloam.projectionOf = ({fovy, near, far}, aspect) => {
    const scale = 1 / Math.tan(fovy / 2);
    const depth = far / (near - far);
    return [scale / aspect, 0, 0, 0, 0, -scale, 0, 0, 0, 0, depth, -1, 0, 0, near * depth, 0];
};
