// SPDX-License-Identifier: MIT
// Matrices of views: 16 numbers, column by column, computed in double.

// The product of two matrices whose last row is (0, 0, 0, 1).
function product(a, b) {
    const all = [];
    for (let column = 0; column < 4; ++column)
        for (let row = 0; row < 4; ++row) {
            let sum = column === 3 ? a[12 + row] : 0;
            for (let k = 0; k < 3; ++k) sum += a[4 * k + row] * b[4 * column + k];
            all.push(sum);
        }
    return all;
}

// The inverse of such a matrix.
function inverse(m) {
    const minor = (a, b, c, d) => m[a] * m[d] - m[b] * m[c];
    const columns = [
        [minor(5, 9, 6, 10), -minor(1, 9, 2, 10), minor(1, 5, 2, 6)],
        [-minor(4, 8, 6, 10), minor(0, 8, 2, 10), -minor(0, 4, 2, 6)],
        [minor(4, 8, 5, 9), -minor(0, 8, 1, 9), minor(0, 4, 1, 5)]];
    const determinant = m[0] * columns[0][0] + m[4] * columns[0][1] + m[8] * columns[0][2];
    for (const column of columns) column.forEach((x, row) => { column[row] = x / determinant; });
    const moved = [0, 1, 2].map((i) => -(columns[0][i] * m[12] + columns[1][i] * m[13] + columns[2][i] * m[14]));
    return [...columns[0], 0, ...columns[1], 0, ...columns[2], 0, ...moved, 1];
}

// A frame's view. projection: from view to clip space, of OpenGL, or of Vulkan with y down. view: from world to view
// space. Throws an Error for what cannot be a view.
function viewOf(projection, view, [width, height]) {
    for (const [name, matrix] of [["projection", projection], ["view", view]])
        if (matrix?.length !== 16 || !Array.from(matrix).every(Number.isFinite))
            throw new Error(`${name}: expected 16 finite numbers, column by column`);
    const orthographic = projection[11] === 0;
    // A jitter for antialiasing is left out: histories and samples are those of the middle of a pixel.
    const offset = orthographic ? [projection[12], projection[13]] : [projection[8], projection[9]];
    const pixels = Math.max(Math.abs(offset[0]) * width, Math.abs(offset[1]) * height) / 2;
    if (pixels > 1) throw new Error(`projection: ${pixels.toFixed(1)} pixels off its centre, expected at most 1`);
    return {orthographic, size: [width, height], p00_p11: [projection[0], projection[5]],
        p22_p32: [projection[10], projection[14]], view: Array.from(view)};
}

// The view as an image of half its size shows it, whose pixels are every second one of the view's.
function halfView(view) {
    const size = view.size.map((n) => Math.floor((n + 1) / 2));
    const scale = (p, axis) => p * view.size[axis] / (2 * size[axis]);
    return {...view, size, p00_p11: view.p00_p11.map(scale), shift: view.p00_p11.map((p, axis) =>
        view.size[axis] % 2 === 0 ? 1 / (view.size[axis] * p) : 0)};
}

// View space of a view to that of the one before. The view space of half the size is sheared: x' = x + shift d, or
// x' = x + shift of an orthographic camera (gloam/filter/half_resolution.glsl).
function change(before, now) {
    const m = product(before.view, inverse(now.view));
    if (!now.shift) return m;
    for (let row = 0; row < 3; ++row)
        for (const axis of [0, 1]) {
            if (now.orthographic) m[12 + row] -= now.shift[axis] * m[4 * axis + row];
            else m[8 + row] += now.shift[axis] * m[4 * axis + row];
        }
    for (const axis of [0, 1]) {
        if (before.orthographic) m[12 + axis] += before.shift[axis];
        else for (let column = 0; column < 4; ++column) m[4 * column + axis] -= before.shift[axis] * m[4 * column + 2];
    }
    return m;
}
