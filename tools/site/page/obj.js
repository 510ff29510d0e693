// SPDX-License-Identifier: MIT
// Wavefront OBJ: positions with colours, normals, and faces; what else a file has is passed over.
"use strict";

gloam.readObj = (text, triangles) => {
    const [positions, colors, normals] = [[], [], []];

    function numbers(words, count, what) {
        const values = words.slice(0, count).map(Number);
        if (values.length < count || !values.every(Number.isFinite))
            throw new Error(`expected ${count} numbers for ${what}`);
        return values;
    }

    // What an index of a face names: from 1, or from the end where it is negative.
    function named(word, list, what) {
        const index = Number(word);
        const at = index < 0 ? list.length + index : index - 1;
        if (!Number.isInteger(index) || at < 0 || at >= list.length)
            throw new Error(`${what} "${word.slice(0, 20)}" of ${list.length}: there is none`);
        return at;
    }

    function corner(word) {
        const [position, , normal = ""] = word.split("/");
        const at = named(position, positions, "position");
        return [positions[at], normal === "" ? null : normals[named(normal, normals, "normal")], colors[at]];
    }

    function face(words) {
        if (words.length < 3) throw new Error("a face has fewer than three corners");
        const corners = words.map(corner);
        for (let i = 2; i < corners.length; ++i)
            for (const one of [corners[0], corners[i - 1], corners[i]]) triangles.add(...one);
    }

    const readers = {
        v: (words) => {
            positions.push(numbers(words, 3, "a position"));
            colors.push(words.length < 6 ? null : numbers(words.slice(3), 3, "a colour")
                .map((x) => Math.round(255 * Math.min(Math.max(x, 0), 1))));
        },
        vn: (words) => normals.push(numbers(words, 3, "a normal")),
        f: face
    };
    let number = 0;
    for (const line of text.split("\n")) {
        ++number;
        const [kind, ...words] = line.split("#", 1)[0].trim().split(/\s+/);
        if (!Object.hasOwn(readers, kind)) continue;
        try {
            readers[kind](words);
        } catch (error) {
            throw new Error(`line ${number}: ${error.message}`);
        }
    }
};
