// SPDX-License-Identifier: MIT
#include <cmath>

#include "catalogue/geometry_parts.hpp"
#include "catalogue/inputs.hpp"
#include "catalogue/scenarios.hpp"
#include "reference/geometry_camera.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

using NeighborSignature = glm::vec3(glm::vec3, glm::vec3, glm::vec3, glm::vec3, glm::vec3);

// A position in front of the eye.
Values centers() {
    return vector({uniform(-5, 5), uniform(-5, 5), either(uniform(-20, -1), uniform(-2, -1))}).and_special();
}
// Offsets of neighbours from the centre: a step along the image and a change of depth, some beyond a
// silhouette.
Values steps(bool along_x) {
    const Values step = uniform(0.02, 0.2);
    const Values slack = uniform(-0.01, 0.01);
    const Values depth = either(uniform(-0.2, 0.2), uniform(-4, 0.9));
    return along_x ? vector({step, slack, depth}).and_special() : vector({slack, step, depth}).and_special();
}

// The neighbours are drawn as steps from the centre; left and down point the other way.
void place_neighbors(std::span<Word> words) {
    constexpr double signs[] = {-1.0, 1.0, 1.0, -1.0};
    for (std::size_t neighbor = 0; neighbor < 4; ++neighbor) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Word& word = words[3 * (neighbor + 1) + axis];
            const double step = from_word<double>(word) * (axis == 2 ? 1.0 : signs[neighbor]);
            word = to_word(from_word<double>(words[axis]) + step);
        }
    }
}

// The cross product is accurate if the directions are not nearly parallel, and its sign is if the surface is
// not seen edge-on.
template <class Viewer>
bool well_conditioned(glm::dvec3 x, glm::dvec3 y, Viewer viewer) {
    const glm::dvec3 product = glm::cross(x, y);
    const double sine = glm::length(product);
    if (!(sine > 0.0)) return true;
    return sine > 0.02 && std::abs(glm::dot(glm::normalize(product), glm::normalize(viewer))) > 1e-3;
}

template <bool orthographic>
bool promised_normal(glm::dvec3 center, glm::dvec3 left, glm::dvec3 right, glm::dvec3 up, glm::dvec3 down) {
    // Beyond these the sign of n . center depends on numbers that may be flushed to 0.
    if (!moderate(1e-30, 1e6, center) || !moderate(0, 1e6, left, right, up, down)) return false;
    const glm::dvec3 x = reference::gloam_neighbor_direction(center, left, right);
    const glm::dvec3 y = reference::gloam_neighbor_direction(center, down, up);
    return well_conditioned(x, y, orthographic ? glm::dvec3(0, 0, 1) : -center);
}

template <bool orthographic, class Reference>
void append_neighbors(Entries& entries, Description description, Reference reference) {
    description.file = "gloam/geometry/normal.glsl";
    description.title = "normal from a position and its four neighbours";
    entries.push_back(equation<NeighborSignature>(
        std::move(description), reference,
        {.domain = Domain{centers(), steps(true), steps(true), steps(false), steps(false)}.adjusted(
             place_neighbors),
         .budget = {.absolute = orthographic ? 4e-6 : 5e-7, .backward_ulp = 1},
         .codomain = {-1.000001, 1.000001},
         .promised = make_predicate<NeighborSignature>(promised_normal<orthographic>)}));
}

using DirectionSignature = glm::vec3(glm::vec3, glm::vec3, glm::vec3);

void append_direction(Entries& entries) {
    const auto place = [](std::span<Word> words) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto center = from_word<double>(words[axis]);
            const double behind = from_word<double>(words[3 + axis]) * (axis == 2 ? 1.0 : -1.0);
            words[3 + axis] = to_word(center + behind);
            words[6 + axis] = to_word(center + from_word<double>(words[6 + axis]));
        }
    };
    entries.push_back(equation<DirectionSignature>(
        {.id = "NORMAL-direction",
         .function = "gloam_neighbor_direction",
         .file = "gloam/geometry/normal.glsl",
         .title = "direction of the surface along one image axis",
         .formula = "one-sided difference of smaller |dz|, normalised",
         .source = "definition; one-sided differences as in Bavoil and Sainz 2009"},
        &reference::gloam_neighbor_direction,
        {.domain = Domain{centers(), steps(true), steps(true)}.adjusted(place),
         .budget = {.ulp = 6, .backward_ulp = 1},
         .codomain = {-1.000001, 1.000001},
         .promised = make_predicate<DirectionSignature>(
             [](const auto&... positions) { return moderate(1e-12, 1e12, positions...); })}));
}

void append_facing(Entries& entries) {
    entries.push_back(equation<DirectionSignature>(
        {.id = "NORMAL-facing",
         .function = "gloam_facing_normal",
         .file = "gloam/geometry/normal.glsl",
         .title = "normal of two directions, turned towards the viewer",
         .formula = "x cross y, normalised; the sign that faces the viewer",
         .source = "definition"},
        &reference::gloam_facing_normal,
        {.domain = {unit_vector(3).and_special(), unit_vector(3).and_special(),
                    vector_of_length(3, log_uniform(1e-3, 1e3)).and_special()},
         .budget = {.absolute = 3e-6},
         .codomain = {-1.000001, 1.000001},
         .promised = make_predicate<DirectionSignature>([](glm::dvec3 x, glm::dvec3 y, glm::dvec3 viewer) {
             return moderate(1e-10, 2.0, x, y) && moderate(1e-10, 1e10, viewer) &&
                    std::isfinite(viewer.x + viewer.y + viewer.z) && well_conditioned(x, y, viewer);
         })}));
}

void append_safe_normalize(Entries& entries) {
    const Values any = either(vector_of_length(3, log_uniform(1e-37, 3e38)), vector(3, any_float()));
    entries.push_back(equation<glm::vec3(glm::vec3, glm::vec3)>(
        {.id = "NORMALIZE",
         .function = "gloam_safe_normalize",
         .file = "gloam/geometry/safe_normalize.glsl",
         .title = "unit vector along any vector that has a direction",
         .formula = "v / |v|; the fallback where v is zero, infinite or NaN",
         .source = "definition"},
        &reference::gloam_safe_normalize,
        {.domain = {any.and_special(), unit_vector(3).and_value(glm::vec3(0.0F))},
         .budget = {.ulp = 5, .absolute = 1e-18},
         .codomain = {-1.000001, 1.000001}}));
}

// A reference that fetches depths, from the images of a scenario.
template <class Reference>
auto fetching_depth(Reference reference) {
    return [reference](const ImageSet& images, glm::ivec2 pixel, glm::ivec2 size, glm::dvec2 scale) {
        const auto fetch = [&images](glm::ivec2 at) { return images.at("gloam_fetch_depth").at<double>(at); };
        return reference(pixel, size, scale, fetch);
    };
}

template <class Reference>
void append_from_depth(Entries& entries, Description description, Reference reference, Question check) {
    description.file = "gloam/geometry/normal_from_depth.glsl";
    check.domain = {either(image_pixel(), vector(2, integers(-2, 66))), image_size(), projection_scales()};
    check.scenarios = depth_scenarios("gloam_fetch_depth");
    entries.push_back(equation<glm::vec3(glm::ivec2, glm::ivec2, glm::vec2)>(
        std::move(description), fetching_depth(reference), std::move(check)));
}

}  // namespace

void append_normals(Entries& entries) {
    append_safe_normalize(entries);
    append_neighbors<false>(
        entries,
        {.id = "NORMAL",
         .function = "gloam_normal_from_neighbors",
         .formula = "cross product of the one-sided differences of smaller |dz|; n . center <= 0",
         .source = "definition; one-sided differences as in Bavoil and Sainz 2009"},
        &reference::gloam_normal_from_neighbors);
    append_neighbors<true>(entries,
                           {.id = "NORMAL-orthographic",
                            .function = "gloam_normal_from_neighbors_orthographic",
                            .formula = "cross product of the one-sided differences of smaller |dz|; n.z >= 0",
                            .source = "definition; one-sided differences as in Bavoil and Sainz 2009"},
                           &reference::gloam_normal_from_neighbors_orthographic);
    append_direction(entries);
    append_facing(entries);
    append_from_depth(entries,
                      {.id = "POSITION-depth",
                       .function = "gloam_position_from_depth",
                       .title = "position read from the depth image",
                       .formula = "POSITION-perspective of the depth and the centre of the pixel",
                       .source = "inverse of the projection"},
                      &reference::gloam_position_from_depth, {.budget = {.ulp = 4}, .codomain = {-1e6, 1e6}});
    append_from_depth(entries,
                      {.id = "NORMAL-depth",
                       .function = "gloam_normal_from_depth",
                       .title = "normal reconstructed from the depth image",
                       .formula = "NORMAL of the positions under the pixel and its neighbours",
                       .source = "definition; one-sided differences as in Bavoil and Sainz 2009"},
                      &reference::gloam_normal_from_depth,
                      {.budget = {.absolute = 2e-5}, .codomain = {-1.000001, 1.000001}});
}

}  // namespace gloam::catalogue
