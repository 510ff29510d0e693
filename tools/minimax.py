#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""minimax.py: the polynomial coefficients of glsl/gloam/numeric, by the exchange algorithm of Remez.

Prints, for each function, the coefficients as float32 and the largest error that they leave: relative, for the cosine
absolute.
"""
import math
import struct

GRID = 4000


def solve(rows, right):
    """The solution of a small linear system, by elimination with pivoting."""
    size = len(right)
    m = [row + [r] for row, r in zip(rows, right)]
    for i in range(size):
        pivot = max(range(i, size), key=lambda k: abs(m[k][i]))
        m[i], m[pivot] = m[pivot], m[i]
        for k in range(i + 1, size):
            factor = m[k][i] / m[i][i]
            m[k] = [a - factor * b for a, b in zip(m[k], m[i])]
    x = [0.0] * size
    for i in reversed(range(size)):
        x[i] = (m[i][size] - sum(m[i][k] * x[k] for k in range(i + 1, size))) / m[i][i]
    return x


def polynomial(coefficients, z):
    value = 0.0
    for c in reversed(coefficients):
        value = value * z + c
    return value


def extrema(errors):
    """Grid positions of the largest error between each pair of sign changes."""
    found = [0]
    for i, e in enumerate(errors):
        if e * errors[found[-1]] < 0.0:
            found.append(i)
        elif abs(e) > abs(errors[found[-1]]):
            found[-1] = i
    return found


def remez(function, weight, last, degree):
    """Coefficients of the polynomial P(z) that makes max |weight (function - P)| smallest for z in (0, last]."""
    grid = [last * (1.0 - math.cos(math.pi * (i + 0.5) / GRID)) / 2.0 for i in range(GRID)]
    grid = [z for z in grid if z > 1e-4 * last]
    angles = [math.pi * k / (degree + 1) for k in range(degree + 2)]
    points = [grid[round((len(grid) - 1) * (1.0 - math.cos(angle)) / 2.0)] for angle in angles]
    for _ in range(20):
        rows = [[z**n for n in range(degree + 1)] + [(-1.0) ** k / weight(z)] for k, z in enumerate(points)]
        coefficients = solve(rows, [function(z) for z in points])[:-1]
        errors = [weight(z) * (function(z) - polynomial(coefficients, z)) for z in grid]
        found = extrema(errors)
        if len(found) < degree + 2:
            break
        count = degree + 2
        start = max(range(len(found) - degree - 1), key=lambda s: min(abs(errors[i]) for i in found[s : s + count]))
        points = [grid[i] for i in found[start : start + count]]
    return coefficients, grid


def to_float(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def report(name, function, weight, last, degree):
    coefficients, grid = remez(function, weight, last, degree)
    rounded = [to_float(c) for c in coefficients]
    error = max(abs(weight(z) * (function(z) - polynomial(rounded, z))) for z in grid)
    print(f"{name}: {', '.join(f'{c:.9g}' for c in rounded)}  (error {error:.2g})")


def main():
    def of_root(f):  # f(x) = x + x z P(z), z = x^2: P, and the weight of its relative error
        return (lambda z: (f(math.sqrt(z)) / math.sqrt(z) - 1.0) / z), (lambda z: z * math.sqrt(z) / f(math.sqrt(z)))

    quarter = (math.pi / 4.0) ** 2
    report("sin(x), |x| <= pi/4", *of_root(math.sin), quarter, 2)
    report("cos(x), |x| <= pi/4", lambda z: (math.cos(math.sqrt(z)) - 1.0 + z / 2.0) / z**2, lambda z: z**2, quarter, 2)
    report("asin(x), |x| <= 1/2", *of_root(math.asin), 0.25, 4)
    report("asin(x), |x| <= sqrt(1/2)", *of_root(math.asin), 0.5, 5)
    report("atan(x), |x| <= 1", *of_root(math.atan), 1.0, 7)


if __name__ == "__main__":
    main()
