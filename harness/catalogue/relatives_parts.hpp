// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/glm.hpp>

#include "catalogue/entry.hpp"

// The equations of methods related to those of the study. The function's name begins with the equation's
// room.
namespace gloam::catalogue {

// Whether a vector has length 1; accuracy is promised for such normals.
[[nodiscard]] inline bool is_unit(const glm::dvec3& n) {
    return std::abs(glm::length(n) - 1.0) <= 1e-6;
}

void append_sampling_levels(Entries& entries);     // depth mip chain, samples by distance
void append_geometry_lengths(Entries& entries);    // length of any vector, cap on a projected radius
void append_occlusion_scalable(Entries& entries);  // SAO and MSSAO
void append_filter_keys(Entries& entries);  // SAO's quad filter, depth keys and blur; MSSAO's coarser level
void append_filter_resolution(Entries& entries);  // half resolution and back

void append_occlusion_layers(Entries& entries);    // curvature, depth rejection, layers, separable AO
void append_shading_bent(Entries& entries);        // bent normals and cones
void append_temporal_smoothing(Entries& entries);  // Gears of War 2

void append_sampling_marches(Entries& entries);     // rays marched in eye space
void append_occlusion_proxies(Entries& entries);    // balls and discs that represent the scene, Poisson discs
void append_shading_directional(Entries& entries);  // directional occlusion, depth darkening

}  // namespace gloam::catalogue
