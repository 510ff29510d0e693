// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_SURFACE_POSITION_GLSL
#define GLOAM_GEOMETRY_SURFACE_POSITION_GLSL

#include "gloam/geometry/finite.glsl"

// whether a position is one of a surface (POSITION-surface): `finite and not the zero vector` [convention].
// Whether a position is one of a surface: the zero vector, where no surface can be, stands for background.
// position: world units, in view space or centred on the camera.
// Returns false for the zero vector and for one with an infinite or NaN component. Error: none.
// No method or pass here calls it: it is there to be copied.
bool gloam_is_surface_position(vec3 position) {
    return gloam_is_finite3(position) && (position.x != 0.0 || position.y != 0.0 || position.z != 0.0);
}

#endif
