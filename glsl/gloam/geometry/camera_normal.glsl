// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_CAMERA_NORMAL_GLSL
#define GLOAM_GEOMETRY_CAMERA_NORMAL_GLSL

#include "gloam/gather/fetch.glsl"
#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/surface.glsl"

// position read from the depth image (POSITION-depth): `CAMERA-position of the depth and the centre of the pixel`
// [inverse of the projection].
// pixel: integer pixel.
// Returns the position in world units; the zero vector for background and outside the image, where nothing is fetched.
// Error: at most 4 ulp in each component.
vec3 gloam_camera_surface(ivec2 pixel, GloamCamera camera) {
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= camera.size.x || pixel.y >= camera.size.y) return vec3(0.0);
    return gloam_camera_position(pixel, gloam_fetch_depth(pixel), camera);
}

// normal reconstructed from the depth image (NORMAL-depth): `NORMAL of the positions under the pixel and its
// neighbours` [definition; one-sided differences as in Bavoil and Sainz 2009].
// At the image's edges and beside background only the other side is used.
// pixel: integer pixel, taken to the nearest one of the image. camera: its size from 1 x 1.
// Returns a unit vector facing the eye; (0, 0, 1) where the neighbours do not suffice (a single row, column or
// pixel); the zero vector for background. Error: that of the positions, 1e-7 of the distance, over their spacing:
// 1.8e-5 where it is a fiftieth.
vec3 gloam_camera_normal(ivec2 pixel, GloamCamera camera) {
    ivec2 at = clamp(pixel, ivec2(0), max(camera.size - 1, ivec2(0)));
    vec3 center = gloam_camera_surface(at, camera);
    vec3 left = gloam_camera_surface(at - ivec2(1, 0), camera);
    vec3 right = gloam_camera_surface(at + ivec2(1, 0), camera);
    vec3 up = gloam_camera_surface(at - ivec2(0, 1), camera);
    vec3 down = gloam_camera_surface(at + ivec2(0, 1), camera);
    return camera.orthographic ? gloam_normal_from_neighbors_orthographic(center, left, right, up, down)
                               : gloam_normal_from_neighbors(center, left, right, up, down);
}

#endif
