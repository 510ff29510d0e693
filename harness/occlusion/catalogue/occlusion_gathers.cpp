// SPDX-License-Identifier: MIT
// Whole methods, which read depths through a prototype, and what their loops share.
#include <cmath>

#include "catalogue/inputs.hpp"
#include "reference/geometry.hpp"
#include "reference/methods.hpp"
#include "reference/occlusion_slices.hpp"
#include "reference/sampling.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

using Camera = reference::GloamCamera;
using Kernel = reference::GloamKernel;
using Estimate = reference::GloamEstimate;

constexpr double most_samples = 64;

// The depth at a pixel.
auto depth_of(const ImageSet& images) {
    return [&images](glm::ivec2 pixel) { return images.at(depth_prototype).at<double>(pixel); };
}

// The same, and those of the layers behind it.
auto layers_of(const ImageSet& images) {
    return [&images](glm::ivec2 pixel) {
        return glm::dvec4(images.at(depth_prototype).at<double>(pixel),
                          images.at("gloam_fetch_layers").at<glm::dvec3>(pixel));
    };
}

Values gather_positions() {
    return vector({uniform(-1, 1), uniform(-1, 1), uniform(1, 4)}).and_special();
}

Values gather_kernels() {
    return vector({log_uniform(0.05, 2).and_special(), log_uniform(1e-3, 0.1).and_special(),
                   uniform(0, 6.2831853).and_special(),
                   log_integers(16777216).and_near_integers({16777216, 4294967295}), integers(0, 8),
                   either(constant(1e18F), uniform(-0.5, 2)).and_special()});
}

Values gather_length() {
    return log_uniform(0.01, 4).and_special();
}

// Whether coordinates and lengths are so small that no product overflows, and the angle so small that it is
// known to a millionth of a turn.
bool usual(const glm::vec3& position, const glm::vec3& normal, const Camera& camera, const Kernel& kernel) {
    return moderate(1e-9, 1e9, position, normal, camera.p00_p11, kernel.radius, kernel.bias) &&
           !(std::abs(kernel.angle) > 64.0F);
}

std::vector<ImageScenario> layer_scenarios() {
    std::vector<ImageScenario> scenarios = depth_scenarios(depth_prototype);
    for (ImageScenario& scenario : scenarios) {
        scenario.make = [make = scenario.make](glm::ivec2 size, numeric::Random& random) {
            ImageSet images = make(size, random);
            const auto layer = [&random] {
                const auto depth = static_cast<float>(random.uniform(1.0, 4.0));
                const auto kind = random.below(4);
                return kind == 0 ? 0.0F : (kind == 1 ? -depth : depth);
            };
            images.emplace("gloam_fetch_layers", make_image<glm::vec3>(size, [&](glm::ivec2) {
                               return glm::vec3(layer(), layer(), layer());
                           }));
            return images;
        };
    }
    return scenarios;
}

// The inputs of a method. own: its settings, if it has some.
template <class... Own>
Domain gather(const Own&... own) {
    return Domain{gather_positions(), unit_vector(3).and_special(), cameras(), gather_kernels(), own...}
        .adjusted(place_before_camera(0, 6));
}

// A whole method with settings of its own. A sample near the border of two pixels, or near the depth at which
// it is blocked, may fall to either side. Then its whole contribution differs, so the budget must include
// inputs that are moved by a few ULP.
template <class Own>
using Method = Estimate (*)(glm::dvec3, glm::dvec3, const Camera&, const Kernel&, const Own&,
                            const reference::Fetch<double>&);
template <class Own>
void add_method(Entries& entries, const char* id, Method<Own> method, const Values& own, Budget budget,
                bool (*promised)(const glm::vec3&, const glm::vec3&, const Camera&, const Kernel&) = usual) {
    add(
        entries, id,
        [method](const ImageSet& images, glm::dvec3 position, glm::dvec3 normal, const Camera& camera,
                 const Kernel& kernel, const Own& settings) {
            return method(position, normal, camera, kernel, settings, depth_of(images));
        },
        gather(own), budget, {0, most_samples},
        [promised](const glm::vec3& p, const glm::vec3& n, const Camera& camera, const Kernel& kernel,
                   const Own&) { return promised(p, n, camera, kernel); },
        depth_scenarios(depth_prototype));
}

void append_hemisphere(Entries& entries) {
    using Own = reference::GloamHemisphere;
    add(
        entries, "TSSAO-2-hemisphere",
        [](const ImageSet& images, glm::dvec3 position, glm::dvec3 normal, const Camera& camera,
           const Kernel& kernel, const Own& own) {
            return reference::gloam_hemisphere(position, normal, camera, kernel, own, layers_of(images));
        },
        gather(vector({gather_length(), integers(1, 4)})), {.ulp = 2.5, .backward_ulp = 4}, {0, most_samples},
        [](const glm::vec3& p, const glm::vec3& n, const Camera& camera, const Kernel& kernel, const Own&) {
            return usual(p, n, camera, kernel);
        },
        layer_scenarios());
}

void append_can_gather(Entries& entries) {
    const Values vectors = vector(3, uniform(-4, 4)).and_special();
    add(entries, "TSSAO-2-can", &reference::gloam_can_gather, {vectors, vectors, gather_length(), cameras()});
}

void append_tap_pixel(Entries& entries) {
    const Values distance = either(constant(0.0F), log_uniform(1, 64)).and_special();
    const Values pixel = vector({integers(0, 2000), integers(0, 1000)});
    add(entries, "TAP-pixel", &reference::gloam_tap_pixel,
        {pixel, pixel, constant(glm::ivec2(2001, 1001)), distance});
}

void append_pairs(Entries& entries) {
    const Values offset = vector(3, uniform(-4, 4));
    add(entries, "PAIR-height", &reference::gloam_height_at,
        {offset, offset, unit_vector(3), uniform(0.03, 1)}, {.absolute = 6e-5}, {-700, 700});
}

void append_volumetric(Entries& entries) {
    add(
        entries, "CS-I-gather",
        [](const ImageSet& images, glm::dvec3 position, glm::dvec3 normal, const Camera& camera,
           const Kernel& kernel) {
            return reference::gloam_volumetric(position, normal, camera, kernel, depth_of(images));
        },
        gather(), {.absolute = 2e-6, .backward_ulp = 4}, {0, most_samples}, usual,
        depth_scenarios(depth_prototype));
}

void append_estimates(Entries& entries) {
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
}

// The parts of the samples that all pixels share.
void append_shared_points(Entries& entries) {
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
}

void append_gathers(Entries& entries) {
    append_can_gather(entries);
    append_estimates(entries);
    append_shared_points(entries);
    append_hemisphere(entries);
    append_tap_pixel(entries);
    add_method(entries, "TSSAO-2-disc", &reference::gloam_disc, vector({gather_length()}),
               {.absolute = 2e-6, .backward_ulp = 4});
    append_pairs(entries);
    append_volumetric(entries);
}

using Slice = reference::GloamSlice;

void append_into_slice(Entries& entries) {
    const Values offsets = vector(3, uniform(-4, 4)).and_special();
    const Values units = unit_vector(3).and_special();
    add(entries, "SLICE-into", &reference::gloam_into_slice, {offsets, units, units}, {.absolute = 2e-5},
        {-3.5e38, 3.5e38}, [](const glm::dvec3& v, const glm::dvec3& a, const glm::dvec3& n) {
            const double turned = glm::dot(a, n);
            const bool unit = glm::dot(a, a) < 1.001 && glm::dot(n, n) < 1.001;
            return moderate(1e-9, 4, v, a, n) && unit && !(turned * turned > 0.9);
        });
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

// Slices of a surface seen edge-on are nearly parallel to its tangent plane.
bool seen_from_above(const glm::vec3& p, const glm::vec3& n, const Camera& camera, const Kernel& kernel) {
    const glm::vec3 view = camera.orthographic ? glm::vec3(0, 0, 1) : -glm::normalize(p);
    return usual(p, n, camera, kernel) && std::abs(glm::dot(glm::normalize(n), view)) > 0.2F;
}

void append_slice_parts(Entries& entries) {
    add(entries, "SLICE-axes", &reference::gloam_slice_axes, {slices().only_as_drawn(), unit_vector(3)},
        {.absolute = 1.5e-5}, {-33, 33}, [](const Slice& slice, const glm::vec3& n) {
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
}

void append_slice_gathers(Entries& entries) {
    append_into_slice(entries);
    add_method(entries, "GTAO-gather", &reference::gloam_gtao, vector({integers(1, 4)}),
               {.absolute = 6e-6, .backward_ulp = 4});
    add_method(entries, "SWEEP-gather", &reference::gloam_sweep,
               vector({integers(1, 4), uniform(0, 3).and_value(1e18F), integers(0, 3)}),
               {.absolute = 6e-6, .backward_ulp = 4}, seen_from_above);
    append_slice_parts(entries);
}

void append_ray_gathers(Entries& entries) {
    add(entries, "POISSON-disc", &reference::gloam_poisson_disc,
        {log_integers(16777216).and_near_integers({64, 16777216, 4294967295})}, {}, {-1, 1});
    add_method(entries, "RAY-gather", &reference::gloam_poisson, vector({gather_length(), integers(1, 4)}),
               {.ulp = 2.5, .backward_ulp = 4});
    add_method(entries, "PROXY-gather", &reference::gloam_sphere_proxy, vector({uniform(0, 2).and_special()}),
               {.absolute = 6e-6, .backward_ulp = 4});
}

}  // namespace

void append_occlusion_gathers(Entries& entries) {
    append_gathers(entries);
    append_slice_gathers(entries);
    append_ray_gathers(entries);
}

}  // namespace gloam::catalogue
