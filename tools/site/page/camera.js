// SPDX-License-Identifier: MIT
// Cameras of the scenes as matrices, column by column, computed in double as harness/occlusion/scene/camera.cpp does.
"use strict";

gloam.camera = (() => {
    const scaled = (v) => v.map((x) => x / Math.hypot(...v));

    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

    // The camera of a frame: the rotation from world to view by rows, and the eye. The world's y points up. `points`:
    // of each frame the eye and what it looks at.
    function at(points, frame) {
        const [eye, target] = [6 * frame, 6 * frame + 3].map((first) => Array.from(points.subarray(first, first + 3)));
        const ahead = scaled(target.map((x, k) => x - eye[k]));
        const right = scaled(cross(ahead, [0, 1, 0]));
        return {rotation: [...right, ...cross(right, ahead), ...ahead.map((x) => -x)], eye};
    }

    const turned = (rotation, v) => [0, 3, 6].map((i) =>
        rotation[i] * v[0] + rotation[i + 1] * v[1] + rotation[i + 2] * v[2]);

    const rigid = (r, t) => [r[0], r[3], r[6], 0, r[1], r[4], r[7], 0, r[2], r[5], r[8], 0, t[0], t[1], t[2], 1];

    // World to view.
    const view = ({rotation, eye}) => rigid(rotation, turned(rotation, eye.map((x) => -x)));

    // View to clip as Vulkan has it: y down, z in [0, 1]. fovy: radians.
    function projection(fovy, aspect, near, far) {
        const scale = 1 / Math.tan(fovy / 2);
        const depth = far / (near - far);
        return [scale / aspect, 0, 0, 0, 0, -scale, 0, 0, 0, 0, depth, -1, 0, 0, near * depth, 0];
    }

    return {at, view, projection};
})();
