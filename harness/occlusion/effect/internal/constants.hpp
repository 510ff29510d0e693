// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace gloam::effect {

// Push constants, with the layout that each pass declares.
struct NormalParameters {
    glm::vec2 p00_p11;
    glm::ivec2 size;
    std::uint32_t orthographic;
};

// Of take_inputs.comp.
struct InputParameters {
    glm::mat3x4 view_from_world;
    glm::vec2 p22_p32;
    glm::ivec2 size;
};

struct OcclusionParameters {
    glm::vec2 p00_p11;
    glm::ivec2 size;
    glm::ivec2 border;
    float radius;
    float bias;
    float c_spatial;
    float weight_max;
    float c_rot;
    float least_radius;
    std::uint32_t shade_border;
    std::uint32_t invalidation;
    float change_tolerance;
    float weight_small;
    float confidence_factor;
    float samples_distance;
    float samples_radius;
    std::uint32_t samples_least;
    float radius_cap;
    float smoothing;
    float bias_depth;
};

struct ReprojectionParameters {
    glm::mat4 previous_from_current;
    glm::vec2 p00_p11;
    glm::vec2 previous_p00_p11;
    glm::ivec2 size;
    float tolerance;
};

// Of positions_from_motion.comp.
struct MotionParameters {
    glm::mat4 previous_from_current;
    glm::vec2 p00_p11;
    glm::vec2 previous_p00_p11;
    glm::ivec2 size;
    glm::vec2 motion_unit;
};

struct FilterParameters {
    glm::vec2 p00_p11;
    glm::ivec2 size;
    float sigma_pixels;
    float depth_scale;
    float c_adaptive;
    float weight_max;
    float cap;
};

struct RemapParameters {
    glm::ivec2 size;
    float a;
    float b;
    float c;
};

// Of composite.comp.
struct CompositeParameters {
    glm::ivec2 size;
    std::uint32_t multi_bounce;
};

// Of the passes that include directional/points.glsl.
struct DirectionalParameters {
    glm::vec2 p00_p11;
    glm::ivec2 size;
    float radius;
    float bias;
    std::uint32_t samples;
    std::uint32_t orthographic;
    glm::mat3x4 world_from_view;
};

// Push constants of the passes of glsl/passes/preparation, with the layout of pass.glsl.
struct PreparationParameters {
    glm::vec2 p00_p11;
    glm::ivec2 size;
    glm::ivec2 border;
    float radius;
    float bias;
    float c_spatial;
    float weight_max;
    float c_rot;
    float least_radius;
    std::uint32_t orthographic;
    std::uint32_t shade_border;
    float samples_distance;
    float samples_radius;
    std::uint32_t samples_least;
    float radius_cap;
    float bias_depth;
    std::int32_t level;
};

}  // namespace gloam::effect
