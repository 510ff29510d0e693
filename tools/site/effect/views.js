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

// View space of a view to that of the one before. Both are matrices from world to view.
function change(before, now) {
    return product(before, inverse(now));
}
