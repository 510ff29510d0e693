// SPDX-License-Identifier: MIT
// What the passes of a frame read of its camera, computed in double. Lengths of view space are in radii of influence.

// Whether a matrix is written row by row: it has (0, 0, 0, 1) in its last column, not in its last row; a perspective
// (0, 0, 1 or -1, 0).
function byRows(m, projects) {
    const last = (x, y, z, w) => projects && w === 0 ? x === 0 && y === 0 && Math.abs(z) === 1
        : [x, y, z, w - 1].every((one) => Math.abs(one) <= (projects ? 0 : 1e-6));
    return last(...[12, 13, 14, 15].map((i) => m[i])) && !last(...[3, 7, 11, 15].map((i) => m[i]));
}

// A matrix before or behind which z is turned: by its columns or rows.
const mirrored = (m, {rows, columns}) =>
    Array.from(m, (x, i) => (rows && i % 4 === 2) || (columns && i >> 2 === 2) ? -x : x);

// A frame's camera. projection: from view to clip space, of OpenGL, or of Vulkan with y down. view: from world to view
// space, left-handed where the projection is: a perspective whose w is z, an orthographic one with the middle of its
// depths at z > 0. radius: world units. before: the camera of the frame before, or null; a jitter around it by up to a
// pixel, for antialiasing, moves no history. Throws an Error for what is no matrix.
function cameraOf(projection, view, size, radius, {depth, range, deep}, before) {
    for (const [name, matrix] of [["projection", projection], ["view", view]]) {
        if (matrix?.length !== 16 || !Array.from(matrix).every(Number.isFinite))
            throw new Error(`${name}: expected 16 finite numbers, column by column`);
        if (byRows(matrix, name === "projection"))
            throw new Error(`${name}: the matrix is written row by row, expected column by column`);
    }
    const orthographic = projection[11] === 0;
    const [scaled, offset] = range === "zero-to-one" ? [1, 0] : [2, -1];
    const left = orthographic ? (scaled + 2 * offset - 2 * projection[14]) / projection[10] > 0 : projection[11] > 0;
    if (left) [projection, view] = [mirrored(projection, {columns: true}), mirrored(view, {rows: true})];
    const unit = orthographic ? radius : 1;
    const scale = [projection[0] * unit, projection[5] * unit];
    const axis = orthographic ? [-projection[12], -projection[13]] : [projection[8], projection[9]];
    const step = scale.map((p, i) => 2 / (size[i] * p));  // of the ray at depth 1 from one pixel to the next
    const firstOf = (middle) => step.map((x, i) => (middle[i] - 1) / scale[i] + 0.5 * x);  // of the first pixel
    const jitters = before?.orthographic === orthographic &&
        axis.every((x, i) => Math.abs(x - before.axis[i]) * size[i] <= 2);
    const held = jitters ? before.axis : axis;
    const spans = step.map((x, i) => Math.abs(x * size[i]));
    const narrow = before?.deep ?? Math.max(...spans) < 0.536;  // 30 degrees; a camera that zooms keeps its images
    return {orthographic, deep: deep || orthographic || narrow, left, size, radius, step, axis: held,
        first: firstOf(held), first_ray: firstOf(axis), view: Array.from(view),
        usual: usualOf(projection, radius, spans, depth === "buffer" ? scaled : 0),
        ...(depth === "linear" ? {numerator: [0, 1 / radius], divisor: [1, 0], far: Infinity, lift: 0}
            : depthOf(projection, radius, [scaled, offset]))};
}

// Of deep passes, as glsl/passes/frame/gloam_frame.h (gloam_fill_usual) has them. spans: of the ray at depth 1;
// orthographic: of the image, in radii. scale: from stored depth to clip space; 0: depth is linear.
function usualOf(projection, radius, spans, scale) {
    const least = 1 / 8192;  // two roundings to 24 bits, in the sweep's rise
    const across = Math.max(...spans) / 1.1547;
    const [p22, p32, stored] = [projection[10], projection[14], scale * least];
    return projection[11] === 0 ? [Math.max(across, Math.abs(stored / (p22 * radius))), 2 * least]
        : [Math.max(Math.min(across, 1), 2 * least), p32 < 0 ? -stored * radius / p32 : 0];
}

// What makes depth in radii of a depth buffer's (gloam_level_depth). scale, offset: from stored depth to clip space.
// lift: radii that are added to depth: an orthographic camera has depths from 1, at its near plane. No pass needs where
// its eye is.
function depthOf(projection, radius, [scale, offset]) {
    const [p22, p32, orthographic] = [projection[10], projection[14], projection[11] === 0];
    const reversed = p22 > (orthographic || offset !== 0 ? 0 : -0.5);
    const far = reversed ? 0 : 1;
    if (!orthographic) return {far, lift: 0, numerator: [p32 / radius, 0], divisor: [p22 + offset, scale]};
    const lift = 1 - (p32 - offset - (reversed ? scale : 0)) / (p22 * radius);
    return {far, lift, numerator: [(p32 - offset) / (p22 * radius) + lift, -scale / (p22 * radius)], divisor: [1, 0]};
}

// What the sweep reads, but for the frame's noise.
function sweepValues({view, size, step, left, usual}) {
    const last = size.map((n) => Math.max(n - 1, 1));
    const behind = [...usual, left ? 2 : 0];
    return {view_from_world: behind.flatMap((w, column) => [...view.slice(4 * column, 4 * column + 3), w]),
        inverse_span: last.map((n) => 1 / n), first: size.map((n) => 0.5 / n), span: last.map((n, i) => n / size[i]),
        ray_span: step.map((x, i) => x * last[i]), reach: step.map((x) => 1 / x)};
}

// (x, y, z, w) times a matrix whose last row is (0, 0, 0, 1), and times its inverse; both without w, which stays.
const times = (m, [x, y, z, w]) => [0, 1, 2].map((i) => m[i] * x + m[4 + i] * y + m[8 + i] * z + m[12 + i] * w);

function timesInverse(m, [x, y, z, w]) {
    const cross = (a, b) => [1, 2, 0].map((i, k) => m[a + i] * m[b + (k + 2) % 3] - m[a + (k + 2) % 3] * m[b + i]);
    const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    const rows = [cross(4, 8), cross(8, 0), cross(0, 4)];
    const from = [x, y, z].map((c, i) => c - w * m[12 + i]);
    return rows.map((row) => dot(row, from) / dot(rows[0], m));
}

// Where a pixel's point was, for gloam_frame_before (gloam/temporal/frame_history.glsl): 4 columns of 3 numbers.
function pixelBefore(now, before) {
    const {orthographic, radius, step, first, lift} = now;
    const columns = [[step[0], 0, 0, 0], [0, step[1], 0, 0],
        orthographic ? [...first, lift, 1] : [...first, -1, 0], orthographic ? [0, 0, -1, 0] : [0, 0, 0, 1]];
    return columns.flatMap(([x, y, z, w]) => {
        const moved = times(before.view, [...timesInverse(now.view, [x, y, z, w / radius]), w / radius]);
        const depth = before.lift * w - moved[2];
        const one = orthographic ? w : depth;
        const pixel = [0, 1].map((i) => (moved[i] - before.first[i] * one) / before.step[i]);
        return [...pixel.map((x, i) => (x + 0.5 * one) / before.size[i]), depth];
    });
}
