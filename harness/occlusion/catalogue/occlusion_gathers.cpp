// SPDX-License-Identifier: MIT
// What the loops of the methods share.
#include <cmath>

#include "catalogue/inputs.hpp"
#include "reference/geometry.hpp"
#include "reference/occlusion_slices.hpp"
#include "reference/sampling.hpp"
#include "reference/shaded_point.hpp"

namespace gloam::catalogue {
namespace {

using namespace subject;

void append_gathers(Entries& entries) {
    const Values vectors = vector(3, uniform(-4, 4)).and_special();
    add(entries, "TSSAO-2-can", &reference::gloam_can_gather,
        {vectors, vectors, log_uniform(0.01, 4).and_special(), cameras()});
    const Values sum = either(uniform(0, 64), log_uniform(1e-37, 1e30)).and_special();
    add(entries, "TSSAO-2-estimate", &reference::gloam_estimate, {sum, sum, integers(0, 2048)}, {.ulp = 2.5},
        {0, 2048}, [](double occluded, double whole, unsigned) {
            return !(whole > 8.5e37) && moderate(1e-30, 3e37, occluded);
        });
    const Values weights = either(uniform(0, 64), log_uniform(1e-37, 64));
    add(entries, "SLICE-estimate", &reference::gloam_slice_estimate,
        {sum, weights, integers(0, 64), integers(1, 64)}, {.ulp = 2.5}, {0, 8192},
        [](double occluded, double, unsigned, unsigned) { return moderate(1e-30, 3e37, occluded); });
    add(entries, "TSSAO-2-sees", &reference::gloam_tap_sees,
        {either(log_uniform(1e-4, 6e4), either(log_uniform(1e-37, 1e38), any_float())).and_special()});
    add(entries, "PAIR-samples", &reference::gloam_paired_samples, {log_integers(100'000)});
    // The parts of the samples that all pixels share.
    const auto point = [&](const char* id, auto reference, double absolute, double most_third) {
        add(entries, id, reference, {log_integers(16777216).and_near_integers({16777216, 4294967295})},
            {.absolute = absolute}, {-1.000001, 1.000001}, [most_third](unsigned index) {
                return reference::gloam_radical_inverse(index, 5U) < most_third;
            });
    };
    point("POINTS-halton", &reference::gloam_halton_point, 2e-7, 1.0);
    point("POINTS-disc", &reference::gloam_disc_point, 5e-7, 1.0);
    point("POINTS-hemisphere-cosine", &reference::gloam_hemisphere_cosine_point, 1.2e-6, 0.998);
    point("POINTS-hemisphere-uniform", &reference::gloam_hemisphere_uniform_point, 2e-6, 0.998);
    const Values distance = either(constant(0.0F), log_uniform(1, 64)).and_special();
    const Values pixel = vector({integers(0, 2000), integers(0, 1000)});
    add(entries, "TAP-pixel", &reference::gloam_tap_pixel,
        {pixel, pixel, constant(glm::ivec2(2001, 1001)), distance});
    const Values offset = vector(3, uniform(-4, 4));
    add(entries, "PAIR-height", &reference::gloam_height_at,
        {offset, offset, unit_vector(3), uniform(0.03, 1)}, {.absolute = 6e-5}, {-700, 700});
}

}  // namespace

void append_occlusion_gathers(Entries& entries) {
    append_gathers(entries);
    const Values offsets = vector(3, uniform(-4, 4)).and_special();
    const Values units = normals();
    add(entries, "SLICE-into", &reference::gloam_into_slice, {offsets, units, units}, {.absolute = 2e-5},
        {-3.5e38, 3.5e38}, [](const glm::dvec3& v, const glm::dvec3& a, const glm::dvec3& n) {
            const double turned = glm::dot(a, n);
            const bool unit = glm::dot(a, a) < 1.001 && glm::dot(n, n) < 1.001;
            return moderate(1e-9, 4, v, a, n) && unit && !(turned * turned > 0.9);
        });
    add(entries, "SLICE-axes", &reference::gloam_slice_axes, {facing_slices(), unit_vector(3)},
        {.absolute = 1.5e-5}, {-33, 33}, [](const reference::GloamSlice& slice, const glm::vec3& n) {
            const double turned = glm::dot(glm::cross(slice.tangent, slice.view), glm::dvec3(n));
            return turned * turned < 0.9;
        });
    add(entries, "SLICE-sample", &reference::gloam_slice_sample, {log_integers(16777216), uniform(0, 1)},
        {.absolute = 5e-7, .backward_ulp = 2}, {-1.000001, 1.000001});
    add(entries, "SLICE-place", &reference::gloam_slice_place, {uniform(0, 1), log_uniform(0.01, 1e6)},
        {.ulp = 4}, {0, 1});
    add(entries, "SLICE-places", &reference::gloam_slice_places,
        {uniform(0, 1), uniform(1, 32), log_uniform(0.01, 1e6)}, {.absolute = 6e-7}, {0, 1.6});
    add(entries, "SAMPLES-whole", &reference::gloam_whole_samples,
        {log_integers(100'000).and_near_integers({64, 4294967295}), integers(0, 64)});
    add(entries, "POISSON-disc", &reference::gloam_poisson_disc,
        {log_integers(16777216).and_near_integers({64, 16777216, 4294967295})}, {}, {-1, 1});
}

}  // namespace gloam::catalogue
