// SPDX-License-Identifier: MIT
// Cameras of the scenes as matrices, column by column, computed in double as harness/occlusion/scene/camera.cpp does.
"use strict";

gloam.camera = (() => {
    // A frame's camera. `numbers`: the rotation from world to view by rows, then the eye.
    const at = (numbers, frame) => ({rotation: numbers.subarray(12 * frame, 12 * frame + 9),
        eye: numbers.subarray(12 * frame + 9, 12 * frame + 12)});

    const turned = (rotation, v) => [0, 3, 6].map((i) =>
        rotation[i] * v[0] + rotation[i + 1] * v[1] + rotation[i + 2] * v[2]);

    const rigid = (r, t) => [r[0], r[3], r[6], 0, r[1], r[4], r[7], 0, r[2], r[5], r[8], 0, t[0], t[1], t[2], 1];

    // World to view.
    const view = ({rotation, eye}) => rigid(rotation, turned(rotation, Array.from(eye, (x) => -x)));

    // View to clip as Vulkan has it: y down, z in [0, 1]. fovy: radians.
    function projection(fovy, aspect, near, far) {
        const scale = 1 / Math.tan(fovy / 2);
        const depth = far / (near - far);
        return [scale / aspect, 0, 0, 0, 0, -scale, 0, 0, 0, 0, depth, -1, 0, 0, near * depth, 0];
    }

    return {at, view, projection};
})();
