// SPDX-License-Identifier: MIT
#include "stress/views.hpp"

#include <algorithm>
#include <limits>

namespace gloam::stress {
namespace {

constexpr float wall_depth = 3.0F;
constexpr float step_height = 0.25F;

}  // namespace

scene::GBuffer plane(gpu::Extent extent) {
    scene::GBuffer view{.extent = extent};
    const std::size_t pixels = std::size_t{extent.width} * extent.height;
    view.depth.assign(pixels, wall_depth);
    view.normal.assign(pixels, glm::vec3(0.0F, 0.0F, 1.0F));
    view.camera =
        scene::make_frame({}, static_cast<double>(extent.width) / static_cast<double>(extent.height));
    return view;
}

scene::GBuffer steps(gpu::Extent extent) {
    scene::GBuffer view = plane(extent);
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        const std::size_t field = (i % extent.width) / 6 + (i / extent.width) / 5;
        if (field % 2 == 1) view.depth[i] -= step_height;
    }
    return view;
}

const std::vector<BadValue>& bad_values() {
    using Limits = std::numeric_limits<float>;
    static const std::vector<BadValue> all{{"NaN", Limits::quiet_NaN()},
                                           {"-NaN", -Limits::quiet_NaN()},
                                           {"infinity", Limits::infinity()},
                                           {"-infinity", -Limits::infinity()},
                                           {"zero", 0.0F},
                                           {"-zero", -0.0F},
                                           {"-1", -1.0F},
                                           {"subnormal", Limits::denorm_min()},
                                           {"largest subnormal", 1.17549421e-38F},
                                           {"smallest normal", Limits::min()},
                                           {"1e-20", 1e-20F},
                                           {"1e20", 1e20F},
                                           {"-1e20", -1e20F},
                                           {"largest", Limits::max()},
                                           {"-largest", Limits::lowest()}};
    return all;
}

std::size_t outside_unit(const std::vector<float>& values) {
    return static_cast<std::size_t>(
        std::ranges::count_if(values, [](float v) { return !(v >= 0.0F && v <= 1.0F); }));
}

}  // namespace gloam::stress
