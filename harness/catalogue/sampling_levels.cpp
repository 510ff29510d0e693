// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "reference/sampling.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr const char* mip_file = "gloam/sampling/depth_mip.glsl";
constexpr const char* sao = "McGuire, Mara and Luebke 2012 (Scalable Ambient Obscurance)";

Values sizes() {
    return either(vector(2, integers(1, 40)), vector(2, integers(-2, 16384)));
}
Values levels() {
    return either(integers(0, 5), integers(-2, 40));
}
Values pixels() {
    return either(vector(2, integers(0, 40)), vector(2, integers(-16, 16384)));
}

// Near an integer, rounding decides on which side of it the quotient falls.
bool off_a_whole_number(double depth, double z_far, int base, int) {
    const double start = std::clamp(base, 0, 4096);
    const double quotient = start / (1 + start * std::min(depth / z_far, 1.0));
    return !(std::abs(quotient - std::round(quotient)) <= 1e-6 * quotient) || depth == 0 || base <= 0;
}

void append_level(Entries& entries) {
    const Values distance = either(log_uniform(1, 2048), any_float())
                                .and_near({8.0, 16.0, 32.0, 64.0, 128.0, 256.0})
                                .and_special();
    entries.push_back(equation<int(float, float, int)>(
        {.id = "CS-Q-level",
         .function = "gloam_depth_mip_level",
         .file = mip_file,
         .title = "level of the depth chain that a tap reads",
         .formula = "clamp(floor(log2(h / first)) + 1, 0, last), h in pixels",
         .source = sao},
        &reference::gloam_depth_mip_level,
        {.domain = Domain{distance, either(constant(16.0F), log_uniform(1, 64)).and_special(), levels()}
                       .tied(0, 1)
                       .tied(0, 1, 4.0)}));
}

void append_chain(Entries& entries) {
    entries.push_back(equation<glm::ivec2(glm::ivec2, int)>(
        {.id = "CS-Q-size",
         .function = "gloam_depth_mip_size",
         .file = mip_file,
         .title = "size of a level of the depth chain",
         .formula = "max(size >> level, 1)",
         .source = "Vulkan's rule for the sizes of levels"},
        &reference::gloam_depth_mip_size, {.domain = {sizes(), levels()}}));
    entries.push_back(equation<glm::ivec2(glm::ivec2, glm::ivec2, int)>(
        {.id = "CS-Q-pixel",
         .function = "gloam_depth_mip_pixel",
         .file = mip_file,
         .title = "pixel of a level that stands for one of the full image",
         .formula = "tap >> level, inside the level",
         .source = sao},
        &reference::gloam_depth_mip_pixel, {.domain = {pixels(), sizes(), levels()}}));
    entries.push_back(equation<glm::ivec2(glm::ivec2, glm::ivec2)>(
        {.id = "CS-Q-grid",
         .function = "gloam_rotated_grid",
         .file = mip_file,
         .title = "pixel of the level before that a pixel takes its depth from",
         .formula = "(2 x + (y & 1), 2 y + (x & 1))",
         .source = sao},
        &reference::gloam_rotated_grid, {.domain = {pixels(), sizes()}}));
    entries.push_back(equation<glm::ivec2(glm::ivec2, glm::ivec2, int)>(
        {.id = "CS-Q-source",
         .function = "gloam_depth_mip_source",
         .file = mip_file,
         .title = "pixel of the full image whose depth a pixel of a level holds",
         .formula = "the rotated grid, level by level",
         .source = "derived from the chain of SAO"},
        &reference::gloam_depth_mip_source, {.domain = {vector(2, integers(0, 600)), sizes(), levels()}}));
}

}  // namespace

void append_sampling_levels(Entries& entries) {
    append_level(entries);
    append_chain(entries);
    entries.push_back(equation<int(float, float, int, int)>(
        {.id = "CS-N",
         .function = "gloam_count_by_distance",
         .file = "gloam/sampling/count_by_distance.glsl",
         .title = "samples by distance",
         .formula = "max(int(base / (1 + base d / z_far)), N_min)",
         .source = "Aalund and Baerentzen 2013"},
        &reference::gloam_count_by_distance,
        {.domain = Domain{either(uniform(0, 120), log_uniform(1e-3, 1e6)).and_special(),
                          either(log_uniform(10, 1000), log_uniform(1e-37, 1e38)).and_special(),
                          either(integers(0, 64), integers(-2, 10000)), integers(0, 16)}
                       .tied(0, 1),
         .codomain = {0, 4096},
         .promised = make_predicate<float(float, float, int, int)>(off_a_whole_number)}));
}

}  // namespace gloam::catalogue
