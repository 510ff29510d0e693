// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_TANGENT_FRAME_GLSL
#define GLOAM_SAMPLING_TANGENT_FRAME_GLSL

// orthonormal frame around a normal (FRAME): `columns t, b, n: z turned onto n the shortest way` [Duff et al. 2017].
// Right-handed orthonormal frame around a normal, without branches that lose accuracy near any direction
// (Duff et al. 2017, "Building an Orthonormal Basis, Revisited"). The tangents jump where n.z changes its sign.
// normal: n, unit, in any space.
// Returns the matrix of columns (t, b, n), t x b = n: it takes tangent space (z along the normal) to the space of the
// normal. Its first two columns are the axes x and y for a zero normal; NaN for a NaN normal. Error: 3e-7 in each
// component.
mat3 gloam_tangent_frame(vec3 n) {
    float side = n.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (side + n.z);
    float b = n.x * n.y * a;
    // A name for the product: NVIDIA's OpenGL 580 negates the bits of -side * n.x as an integer.
    float x = side * n.x;
    vec3 tangent = vec3(1.0 + x * n.x * a, side * b, -x);
    vec3 bitangent = vec3(b, side + n.y * n.y * a, -n.y);
    return mat3(tangent, bitangent, n);
}

#endif
