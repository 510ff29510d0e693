// SPDX-License-Identifier: MIT
// Models of the visitor: a file becomes a scene. The file is from elsewhere: what is read of it is bounded and checked.
"use strict";

gloam.model = (() => {
    const limits = {bytes: 64e6, triangles: 5e5, name: 60, message: 300};
    const size = 10;  // of the scene: the diagonal of its box
    const defaultColor = [179, 179, 179];

    // Triangles that a reader adds one corner after another. normals: null where the file has none.
    class Triangles {
        constructor() {
            this.positions = [];
            this.normals = [];
            this.colors = [];
            this.hasNormals = true;
        }

        add(position, normal, color) {
            if (this.positions.length >= 9 * limits.triangles)
                throw new Error(`more than ${limits.triangles} triangles`);
            if (!position.every(Number.isFinite)) throw new Error("a position is not finite");
            this.positions.push(...position);
            if (normal === null || !normal.every(Number.isFinite)) this.hasNormals = false;
            else if (this.hasNormals) this.normals.push(...normal);
            this.colors.push(...(color ?? defaultColor), 255);
        }
    }

    // The normal of each triangle, for its three corners.
    function flatNormals(p) {
        const normals = new Float32Array(p.length);
        for (let i = 0; i < p.length; i += 9) {
            const [a, b] = [3, 6].map((first) => [0, 1, 2].map((k) => p[i + first + k] - p[i + k]));
            const n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
            const length = Math.hypot(...n) || 1;
            for (let k = 0; k < 9; ++k) normals[i + k] = n[k % 3] / length;
        }
        return normals;
    }

    // A camera that goes round the model once: of each frame the eye and what it looks at.
    function turntable(frames) {
        const cameras = new Float64Array(6 * frames);
        for (let i = 0; i < frames; ++i) {
            const angle = 2 * Math.PI * i / frames;
            cameras.set([1.05 * size * Math.sin(angle), 0.4 * size, 1.05 * size * Math.cos(angle)], 6 * i);
        }
        return cameras;
    }

    // The scene of triangles: moved to the origin, and scaled.
    function sceneOf(name, triangles) {
        if (triangles.positions.length === 0) throw new Error("no triangles");
        const {low, high} = gloam.boxOf(triangles.positions);
        const scale = size / Math.hypot(...low.map((x, k) => high[k] - x));
        if (!Number.isFinite(scale) || scale <= 0) throw new Error("all triangles are in one point, or too far apart");
        const middle = low.map((x, k) => 0.5 * (x + high[k]));
        const positions = Float32Array.from(triangles.positions, (x, i) => (x - middle[i % 3]) * scale);
        return {name, radius: 0.05 * size, fovy: 0.75, near: 0.01 * size, far: 10 * size, frames: 480,
            cameras: turntable(480), positions, colors: Uint8Array.from(triangles.colors),
            normals: triangles.hasNormals ? Float32Array.from(triangles.normals) : flatNormals(positions),
            indices: Uint32Array.from({length: positions.length / 3}, (_, i) => i)};
    }

    // The scene of a file. Throws an Error that names the file and what is wrong with it.
    async function read(file) {
        const name = file.name.slice(0, limits.name);
        try {
            const kind = /\.(obj|gltf|glb)$/i.exec(file.name)?.[1].toLowerCase();
            if (kind === undefined) throw new Error("expected a file that ends in .obj, .gltf or .glb");
            if (file.size > limits.bytes) throw new Error(`${file.size} bytes, expected at most ${limits.bytes}`);
            const bytes = new Uint8Array(await file.arrayBuffer());
            const triangles = new Triangles();
            if (kind === "obj") gloam.readObj(new TextDecoder().decode(bytes), triangles);
            else gloam.readGltf(bytes, triangles);
            return sceneOf(name, triangles);
        } catch (error) {
            throw new Error(`${name}: ${error.message}`.replace(/\s+/g, " ").slice(0, limits.message));
        }
    }

    return {read};
})();
