// SPDX-License-Identifier: MIT
#include <cmath>

#include "catalogue/camera_inputs.hpp"
#include "catalogue/gather_inputs.hpp"
#include "catalogue/inputs.hpp"
#include "catalogue/occlusion_parts.hpp"
#include "catalogue/scenarios.hpp"
#include "reference/methods.hpp"
#include "reference/occlusion_slices.hpp"
#include "reference/sampling.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;
using Camera = reference::GloamCamera;
using Kernel = reference::GloamKernel;
using Estimate = reference::GloamEstimate;
using Slice = reference::GloamSlice;
using reference::GloamCamera;
using reference::GloamKernel;

constexpr double most_samples = 64;

void append_into_slice(Entries& entries) {
    using Signature = glm::vec3(glm::vec3, glm::vec3, glm::vec3);
    const Values offsets = vector(3, uniform(-4, 4)).and_special();
    const Values units = unit_vector(3).and_special();
    entries.push_back(equation<Signature>(
        {.id = "SLICE-into",
         .function = "gloam_into_slice",
         .file = "gloam/geometry/into_slice.glsl",
         .title = "offset moved into a slice along the tangent plane",
         .formula = "v - (v . a) u, u . n = 0, u . a = 1",
         .source = "definition"},
        &reference::gloam_into_slice,
        {.domain = {offsets, units, units},
         .budget = {.absolute = 2e-5},
         .codomain = {-3.5e38, 3.5e38},
         .promised =
             make_predicate<Signature>([](const glm::dvec3& v, const glm::dvec3& a, const glm::dvec3& n) {
                 const double turned = glm::dot(a, n);
                 const bool unit = glm::dot(a, a) < 1.001 && glm::dot(n, n) < 1.001;
                 return moderate(1e-9, 4, v, a, n) && unit && !(turned * turned > 0.9);
             })}));
}

Values slices() {
    return made_by<Slice>([](numeric::Random& random) {
        const glm::vec3 view =
            glm::normalize(glm::vec3(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 1));
        const glm::dvec3 normal = glm::normalize(glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), 1));
        const auto turn = static_cast<float>(random.uniform(0, 3.1415926));
        return reference::gloam_slice(glm::vec2(std::cos(turn), std::sin(turn)), view, normal);
    });
}

void append_clearance(Entries& entries) {
    using Signature = glm::vec2(Slice, glm::vec3, glm::vec2, glm::vec2, glm::vec2, float, float);
    const Values ends = either(vector(2, uniform(0, 1)), vector(2, uniform(-0.1, 1.1))).and_special();
    const Values positions = vector({uniform(-1, 1), uniform(-1, 1), uniform(-4, -1)}).and_special();
    entries.push_back(equation<Signature>(
        {.id = "SLICE-clearance",
         .function = "gloam_slice_clearance",
         .file = "gloam/occlusion/closed_march.glsl",
         .title = "how near to the view axis the taps of a slice may see something",
         .formula = "s -> (1 - B / D) (s a - b) / (1 + R / D (sqrt(1 - a^2) + b))",
         .source = "derived from the rays of pixels beside the slice"},
        &reference::gloam_slice_clearance,
        {.domain = {slices(), positions, unit_vector(2), ends, vector(2, log_uniform(0.1, 1000)),
                    log_uniform(0.01, 10), uniform(0, 1)},
         .budget = {.absolute = 8e-7},
         .codomain = {0, 1}}));
}

void append_taps(Entries& entries) {
    using Signature = unsigned(glm::vec2, float, float, unsigned);
    const Values clearances = vector({uniform(0, 1), uniform(0, 1)}).and_value(glm::vec2(0)).and_special();
    entries.push_back(equation<Signature>(
        {.id = "SLICE-taps",
         .function = "gloam_slice_taps",
         .file = "gloam/occlusion/closed_march.glsl",
         .title = "taps of a side of a slice that may see something within a ball",
         .formula = "ceil(n sqrt((b + y) / x) - jitter), at most n",
         .source = "definition"},
        &reference::gloam_slice_taps,
        {.domain = {clearances, uniform(-0.25, 1.25).and_near({0.0, 1.0}).and_special(), uniform(0, 1),
                    integers(1, 64)},
         .budget = {.backward_ulp = 4},
         .codomain = {0, 64},
         // A smaller ball is within the rounding of a tap's distance.
         .promised = make_predicate<Signature>(
             [](glm::vec2, float ball, float, unsigned) { return moderate(1e-5, 1e30, ball); })}));
}

void append_gtao(Entries& entries) {
    using Signature = Estimate(glm::vec3, glm::vec3, Camera, Kernel, reference::GloamGtao);
    entries.push_back(equation<Signature>(
        {.id = "GTAO-gather",
         .function = "gloam_gtao",
         .file = "gloam/methods/gtao.glsl",
         .title = "occlusion of a pixel by horizon slices",
         .formula = "weighted mean over slices",
         .source = "GTAO (Jimenez et al. 2016)"},
        [](const ImageSet& images, glm::dvec3 position, glm::dvec3 normal, const GloamCamera& camera,
           const GloamKernel& kernel, const reference::GloamGtao& own) {
            return reference::gloam_gtao(position, normal, camera, kernel, own, layers_of(images));
        },
        {.domain = Domain{gather_positions(), unit_vector(3).and_special(), cameras(), gather_kernels(),
                          vector({integers(1, 4)})}
                       .adjusted(place_before_camera(0, 6)),
         .budget = {.absolute = 2e-5, .backward_ulp = 4},
         .codomain = {0, most_samples},
         .promised =
             make_predicate<Signature>([](const glm::vec3& p, const glm::vec3& n, const Camera& c,
                                          const Kernel& k, const auto&) { return usual_gather(p, n, c, k); }),
         .scenarios = gather_scenarios()}));
}

void append_sweep(Entries& entries) {
    using Signature = Estimate(glm::vec3, glm::vec3, Camera, Kernel, reference::GloamSweep);
    entries.push_back(equation<Signature>(
        {.id = "SWEEP-gather",
         .function = "gloam_sweep",
         .file = "gloam/methods/sweep.glsl",
         .title = "occlusion of a pixel by horizon slices, each direction with the falloff at its distance",
         .formula = "sum of w D(rho) (I(H) - I(h)) over the sum of w (cos n + n sin n)",
         .source = "gloam"},
        [](const ImageSet& images, glm::dvec3 position, glm::dvec3 normal, const GloamCamera& camera,
           const GloamKernel& kernel, const reference::GloamSweep& own) {
            return reference::gloam_sweep(position, normal, camera, kernel, own, layers_of(images));
        },
        {.domain = Domain{gather_positions(), unit_vector(3).and_special(), cameras(), gather_kernels(),
                          vector({integers(1, 4), uniform(0, 3).and_value(1e18F), integers(0, 3)})}
                       .adjusted(place_before_camera(0, 6)),
         .budget = {.absolute = 1.5e-5, .backward_ulp = 4},
         .codomain = {0, most_samples},
         .promised = make_predicate<Signature>(
             [](const glm::vec3& p, const glm::vec3& n, const Camera& c, const Kernel& k, const auto&) {
                 const glm::vec3 view = c.orthographic ? glm::vec3(0, 0, 1) : -glm::normalize(p);
                 // Slices of a surface seen edge-on are nearly parallel to its tangent plane.
                 return usual_gather(p, n, c, k) && std::abs(glm::dot(glm::normalize(n), view)) > 0.2F;
             }),
         .scenarios = gather_scenarios()}));
}

void append_slice_parts(Entries& entries) {
    using Axes = reference::GloamSliceAxes(Slice, glm::vec3);
    entries.push_back(equation<Axes>(
        {.id = "SLICE-axes",
         .function = "gloam_slice_axes",
         .file = "gloam/geometry/slice.glsl",
         .title = "vectors that take offsets into a slice along the tangent plane",
         .formula = "(v - (u . v) a, t - (u . t) a), u . n = 0, u . a = 1",
         .source = "definition"},
        &reference::gloam_slice_axes,
        {.domain = {slices().only_as_drawn(), unit_vector(3)},
         .budget = {.absolute = 1.5e-5},
         .codomain = {-33, 33},
         .promised = make_predicate<Axes>([](const Slice& slice, const glm::vec3& n) {
             const double turned = glm::dot(glm::cross(slice.tangent, slice.view), glm::dvec3(n));
             return turned * turned < 0.9;
         })}));
    using Sample = reference::GloamSliceSample(unsigned, float);
    entries.push_back(equation<Sample>(
        {.id = "SLICE-sample",
         .function = "gloam_slice_sample",
         .file = "gloam/sampling/slice_sample.glsl",
         .title = "what is random of a slice",
         .formula = "direction pi fract(x + t), jitter fract(y + t), share z, of the Halton point (x, y, z)",
         .source = "GTAO (Jimenez et al. 2016) with the sequence of TSSAO"},
        &reference::gloam_slice_sample,
        {.domain = {log_integers(16777216), uniform(0, 1)},
         .budget = {.absolute = 5e-7, .backward_ulp = 2},
         .codomain = {-1.000001, 1.000001}}));
    entries.push_back(equation<unsigned(unsigned, unsigned)>(
        {.id = "SAMPLES-whole",
         .function = "gloam_whole_samples",
         .file = "gloam/sampling/whole_samples.glsl",
         .title = "samples of whole slices, rays or crosses",
         .formula = "n max(floor(k / n), 1)",
         .source = "definition"},
        &reference::gloam_whole_samples,
        {.domain = {log_integers(100'000).and_near_integers({64, 4294967295}), integers(0, 64)}}));
}

}  // namespace

void append_slice_gathers(Entries& entries) {
    append_into_slice(entries);
    append_clearance(entries);
    append_taps(entries);
    append_gtao(entries);
    append_sweep(entries);
    append_slice_parts(entries);
}

}  // namespace gloam::catalogue
