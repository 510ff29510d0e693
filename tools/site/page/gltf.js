// SPDX-License-Identifier: MIT
// glTF 2.0, as JSON with its buffers as data, or as GLB: triangles of the nodes of its scene, with normals and colours.
"use strict";

gloam.readGltf = (() => {
    const most = {depth: 64, work: 1e7};
    const kinds = {5121: [Uint8Array, "getUint8"], 5123: [Uint16Array, "getUint16"], 5125: [Uint32Array, "getUint32"],
        5126: [Float32Array, "getFloat32"]};
    const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

    // A whole number from 0 to a limit.
    function whole(value, limit, what) {
        if (!Number.isInteger(value) || value < 0 || value > limit)
            throw new Error(`${what} is ${JSON.stringify(value)?.slice(0, 30)}, expected a whole number from 0 to ` +
                String(limit));
        return value;
    }

    // The element of a list of the file that an index names.
    function named(list, index, what) {
        if (!Array.isArray(list)) throw new Error(`there are no ${what}`);
        const element = list[whole(index, list.length - 1, `an index of ${what}`)];
        if (typeof element !== "object" || element === null) throw new Error(`${what} ${index} is no object`);
        return element;
    }

    function finite(values, count, what) {
        if (!Array.isArray(values) || values.length !== count || !values.every(Number.isFinite))
            throw new Error(`${what}: expected ${count} numbers`);
        return values;
    }

    // The JSON of a GLB file and its buffer.
    function glb(bytes) {
        const view = new DataView(bytes.buffer);
        const word = (at) => at + 4 <= bytes.length ? view.getUint32(at, true) : NaN;
        if (word(4) !== 2) throw new Error(`version ${word(4)} of GLB, expected 2`);
        if (word(8) !== bytes.length) throw new Error(`its head says ${word(8)} bytes, but it has ${bytes.length}`);
        const chunks = [];
        for (let at = 12; at < bytes.length && chunks.length < 2; at += 8 + word(at)) {
            if (!(at + 8 + word(at) <= bytes.length)) throw new Error("a part of it is longer than the file");
            chunks.push({kind: word(at + 4), bytes: bytes.subarray(at + 8, at + 8 + word(at))});
        }
        if (chunks[0]?.kind !== 0x4E4F534A) throw new Error("its first part is not JSON");
        return {json: chunks[0].bytes, binary: chunks[1]?.kind === 0x004E4942 ? chunks[1].bytes : null};
    }

    class Reader {
        constructor(json, binary, triangles) {
            this.json = json;
            this.binary = binary;
            this.triangles = triangles;
            this.buffers = new Map();
            this.work = 0;
        }

        // Counts what the file makes this read: shared nodes and accessors can be many more than its bytes.
        spend(count) {
            this.work += count;
            if (this.work > most.work) throw new Error(`more than ${most.work} numbers, nodes and parts to read`);
        }

        buffer(index) {
            if (this.buffers.has(index)) return this.buffers.get(index);
            const {uri} = named(this.json.buffers, index, "buffers");
            const data = /^data:[\w/+.-]*;base64,/.exec(String(uri).slice(0, 100));
            if (uri === undefined && this.binary === null) throw new Error(`buffer ${index} has no data`);
            if (uri !== undefined && data === null)
                throw new Error(`buffer ${index} is a file of its own: expected one that stands in this file`);
            const bytes = uri === undefined ? this.binary : gloam.bytes(uri.slice(data[0].length));
            this.buffers.set(index, bytes);
            return bytes;
        }

        // The numbers of an accessor, `width` for each element.
        accessor(index, type, width, floats) {
            const one = named(this.json.accessors, index, "accessors");
            const kind = kinds[one.componentType];
            if (one.type !== type || kind === undefined || floats !== (one.componentType === 5126))
                throw new Error(`accessor ${index}: expected ${floats ? "floats" : "whole numbers"} as ${type}`);
            if (one.sparse !== undefined || one.bufferView === undefined)
                throw new Error(`accessor ${index} is sparse or empty: expected one with a buffer`);
            const view = named(this.json.bufferViews, one.bufferView, "bufferViews");
            const bytes = this.buffer(view.buffer);
            const begin = whole(view.byteOffset ?? 0, bytes.length, "byteOffset");
            const length = whole(view.byteLength, bytes.length - begin, "byteLength");
            const step = kind[0].BYTES_PER_ELEMENT;
            const stride = whole(view.byteStride ?? width * step, 252, "byteStride");
            const first = whole(one.byteOffset ?? 0, length, "byteOffset");
            const count = whole(one.count, most.work, "count");
            this.spend(count * width);
            if (count > 0 && first + (count - 1) * stride + width * step > length)
                throw new Error(`accessor ${index} ends behind its buffer`);
            const data = new DataView(bytes.buffer, bytes.byteOffset + begin + first);
            return this.numbers(data, kind, {count, width, stride});
        }

        numbers(data, [Kind, get], {count, width, stride}) {
            const values = new Kind(count * width);
            for (let i = 0; i < values.length; ++i)
                values[i] = data[get](Math.floor(i / width) * stride + i % width * Kind.BYTES_PER_ELEMENT, true);
            return values;
        }

        color(material) {
            if (material === undefined) return null;
            const factor = named(this.json.materials, material, "materials").pbrMetallicRoughness?.baseColorFactor;
            if (factor === undefined) return null;
            return finite(factor, 4, "baseColorFactor").slice(0, 3)
                .map((x) => Math.round(255 * Math.min(Math.max(x, 0), 1)));
        }

        primitive(primitive, matrix) {
            this.spend(1);
            if ((primitive.mode ?? 4) !== 4) return;  // points and lines
            const {POSITION, NORMAL} = primitive.attributes ?? {};
            const positions = this.accessor(POSITION, "VEC3", 3, true);
            const normals = NORMAL === undefined ? null : this.accessor(NORMAL, "VEC3", 3, true);
            const count = positions.length / 3;
            const indices = primitive.indices === undefined ? Uint32Array.from({length: count}, (_, i) => i)
                : this.accessor(primitive.indices, "SCALAR", 1, false);
            const color = this.color(primitive.material);
            const [points, directions] = [matrix, cofactors(matrix)].map((m) => (v) => [0, 1, 2].map((row) =>
                m[row] * v[0] + m[4 + row] * v[1] + m[8 + row] * v[2] + m[12 + row]));
            for (let i = 0; i + 2 < indices.length; i += 3)
                for (const index of indices.subarray(i, i + 3)) {
                    const at = 3 * whole(index, count - 1, "an index of a vertex");
                    const normal = normals?.subarray(at, at + 3);
                    this.triangles.add(points(positions.subarray(at, at + 3)),
                        normal?.length === 3 ? directions(normal) : null, color);
                }
        }

        node(index, parent, above) {
            if (above.includes(index)) throw new Error(`node ${index} is below itself`);
            if (above.length >= most.depth) throw new Error(`nodes stand more than ${most.depth} deep`);
            this.spend(64);
            const node = named(this.json.nodes, index, "nodes");
            const matrix = product(parent, matrixOf(node));
            const primitives = node.mesh === undefined ? [] : named(this.json.meshes, node.mesh, "meshes").primitives;
            list(primitives, "primitives").forEach((_, i) =>
                this.primitive(named(primitives, i, "primitives"), matrix));
            for (const child of list(node.children ?? [], "children")) this.node(child, matrix, [...above, index]);
        }

        read() {
            const needs = list(this.json.extensionsRequired ?? [], "extensionsRequired");
            if (needs.length > 0) throw new Error(`it needs ${String(needs[0]).slice(0, 60)}, which is not read here`);
            const scene = named(this.json.scenes, this.json.scene ?? 0, "scenes");
            for (const root of list(scene.nodes ?? [], "nodes")) this.node(root, identity, []);
        }
    }

    function list(value, what) {
        if (!Array.isArray(value)) throw new Error(`${what}: expected a list`);
        return value;
    }

    // 4 x 4 matrices, column by column.
    function product(a, b) {
        return identity.map((_, i) => [0, 1, 2, 3].reduce((sum, k) => sum + a[4 * k + i % 4] * b[i - i % 4 + k], 0));
    }

    function matrixOf(node) {
        if (node.matrix !== undefined) return finite(node.matrix, 16, "matrix");
        const [x, y, z, w] = finite(node.rotation ?? [0, 0, 0, 1], 4, "rotation");
        const s = finite(node.scale ?? [1, 1, 1], 3, "scale");
        const t = finite(node.translation ?? [0, 0, 0], 3, "translation");
        const columns = [[1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
            [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
            [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)]];
        return [...columns.flatMap((column, k) => [...column.map((c) => c * s[k]), 0]), ...t, 1];
    }

    // What directions across surfaces are multiplied by: the cofactors of the upper 3 x 3. No matrix lacks them.
    function cofactors(m) {
        const minor = (a, b, c, d) => m[a] * m[d] - m[b] * m[c];
        return [minor(5, 6, 9, 10), minor(8, 10, 4, 6), minor(4, 5, 8, 9), 0,
            minor(9, 10, 1, 2), minor(0, 2, 8, 10), minor(8, 9, 0, 1), 0,
            minor(1, 2, 5, 6), minor(4, 6, 0, 2), minor(0, 1, 4, 5), 0, 0, 0, 0, 1];
    }

    return (bytes, triangles) => {
        const isGlb = bytes.length >= 12 && new DataView(bytes.buffer).getUint32(0, true) === 0x46546C67;
        const {json, binary} = isGlb ? glb(bytes) : {json: bytes, binary: null};
        const parsed = JSON.parse(new TextDecoder().decode(json));
        if (typeof parsed !== "object" || parsed === null || !String(parsed.asset?.version).startsWith("2."))
            throw new Error("expected glTF of version 2");
        new Reader(parsed, binary, triangles).read();
    };
})();
