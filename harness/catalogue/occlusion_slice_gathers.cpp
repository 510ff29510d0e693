// SPDX-License-Identifier: MIT
#include "catalogue/camera_inputs.hpp"
#include "catalogue/gather_inputs.hpp"
#include "catalogue/inputs.hpp"
#include "catalogue/occlusion_parts.hpp"
#include "catalogue/scenarios.hpp"
#include "reference/methods/gtao.hpp"
#include "reference/occlusion/closed_march.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;
using Camera = reference::GloamCamera<float>;
using Kernel = reference::GloamKernel<float>;
using Method = reference::GloamMethod<float>;
using March = reference::GloamMarch<float>;
using Slice = reference::GloamSlice<float>;
using Point = reference::GloamSlicePoint<float>;
using reference::GloamCamera;
using reference::GloamKernel;
using reference::GloamMarch;
using reference::GloamMethod;
using reference::GloamSlice;
using reference::GloamSlicePoint;
using reference::vec3;

constexpr const char* file = "passes/methods/gtao.glsl";
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
        GLOAM_REFERENCE(gloam_into_slice),
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
        const glm::vec3 normal = glm::normalize(glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), 1));
        const auto turn = static_cast<float>(random.uniform(0, 3.1415926));
        return reference::gloam_slice(glm::vec2(std::cos(turn), std::sin(turn)), view, normal);
    });
}

void append_clearance(Entries& entries) {
    using Signature = glm::vec2(Slice, glm::vec3, glm::vec2, glm::vec2, Camera, float, float);
    const Values ends = either(vector(2, uniform(0, 1)), vector(2, uniform(-0.1, 1.1))).and_special();
    const Values positions = vector({uniform(-1, 1), uniform(-1, 1), uniform(-4, -1)}).and_special();
    entries.push_back(
        equation<Signature>({.id = "SLICE-clearance",
                             .function = "gloam_slice_clearance",
                             .file = "gloam/occlusion/closed_march.glsl",
                             .title = "how near to the view axis the taps of a slice may see something",
                             .formula = "s -> (1 - B / D) (s a - b) / (1 + R / D (sqrt(1 - a^2) + b))",
                             .source = "derived from the rays of pixels beside the slice"},
                            GLOAM_REFERENCE(gloam_slice_clearance),
                            {.domain = {slices(), positions, unit_vector(2), ends, cameras(),
                                        log_uniform(0.01, 10), uniform(0, 1)},
                             .budget = {.absolute = 8e-7},
                             .codomain = {0, 1}}));
}

void append_taps(Entries& entries) {
    using Signature = unsigned(glm::vec2, float, float, unsigned);
    const Values clearances = vector({uniform(0, 1), uniform(0, 1)}).and_value(glm::vec2(0)).and_special();
    entries.push_back(
        equation<Signature>({.id = "SLICE-taps",
                             .function = "gloam_slice_taps",
                             .file = "gloam/occlusion/closed_march.glsl",
                             .title = "taps of a side of a slice that may see something within a ball",
                             .formula = "ceil(n sqrt((b + y) / x) - jitter), at most n",
                             .source = "definition"},
                            GLOAM_REFERENCE(gloam_slice_taps),
                            {.domain = {clearances, uniform(-0.25, 1.25).and_near({0.0, 1.0}).and_special(),
                                        uniform(0, 1), integers(1, 64)},
                             .budget = {.backward_ulp = 4},
                             .codomain = {0, 64}}));
}

void append_march(Entries& entries) {
    using Signature = March(March, Slice, Point, Camera, Kernel, Method);
    const Values marches =
        vector({constant(glm::vec2(-1, -0.5)), constant(glm::vec2(-1, 0.25)), uniform(0, 1), constant(0U)});
    const Values points = vector({gather_positions(), unit_vector(3), unit_vector(2), uniform(0, 1)});
    entries.push_back(equation<Signature>(
        {.id = "SLICE-march",
         .function = "gloam_slice_march",
         .file = file,
         .title = "all steps of a slice",
         .formula = "steps at R ((i + jitter) / n)^2 to both sides",
         .source = "horizon-based methods (Bavoil and Sainz 2008; Jimenez et al. 2016)"},
        []<class T>(const ImageSet& images, const GloamMarch<T>& march, const GloamSlice<T>& slice,
                    const GloamSlicePoint<T>& point, const GloamCamera<T>& camera,
                    const GloamKernel<T>& kernel, const GloamMethod<T>& method) {
            return reference::gloam_slice_march(march, slice, point, camera, kernel, method,
                                                reference::GtaoMethod<T>{}, depth_of<T>(images));
        },
        {.domain = Domain{marches, slices(), points, cameras(), gather_kernels(), gather_methods()}.adjusted(
             place_before_camera(14, 23)),
         .budget = {.backward_ulp = 4},
         .promised = make_predicate<Signature>(
             [](const March&, const Slice&, const Point& point, const Camera& c, const Kernel& k,
                const Method& m) { return usual_gather(point.position, point.normal, c, k, m); }),
         .scenarios = depth_scenarios(depth_prototype)}));
}

void append_samples(Entries& entries) {
    entries.push_back(equation<unsigned(unsigned, unsigned)>(
        {.id = "SLICE-samples",
         .function = "gloam_slice_samples",
         .file = file,
         .title = "samples of whole slices",
         .formula = "2 n max(floor(k / (2 n)), 1)",
         .source = "definition"},
        GLOAM_REFERENCE(gloam_slice_samples),
        {.domain = {log_integers(100'000).and_near_integers({64, 4294967295}), integers(0, 64)},
         .scenarios = depth_scenarios(depth_prototype)}));
}

void append_gather(Entries& entries) {
    using Gather = glm::vec2(glm::vec3, glm::vec3, Camera, Kernel, Method);
    entries.push_back(equation<Gather>(
        {.id = "GTAO-gather",
         .function = "gloam_slice_gather",
         .file = file,
         .title = "occlusion of a pixel by horizon slices",
         .formula = "n times the weighted mean over slices, n",
         .source = "GTAO (Jimenez et al. 2016)"},
        []<class T>(const ImageSet& images, vec3<T> position, vec3<T> normal, const GloamCamera<T>& camera,
                    const GloamKernel<T>& kernel, const GloamMethod<T>& method) {
            return reference::gloam_slice_gather(position, normal, camera, kernel, method,
                                                 reference::GtaoMethod<T>{}, depth_of<T>(images));
        },
        {.domain = Domain{gather_positions(), unit_vector(3).and_special(), cameras(), gather_kernels(),
                          gather_methods()}
                       .adjusted(place_before_camera(0, 6)),
         .budget = {.absolute = 6e-5, .backward_ulp = 4},
         .codomain = {0, most_samples},
         .promised = make_predicate<Gather>(usual_gather),
         .scenarios = depth_scenarios(depth_prototype)}));
}

}  // namespace

void append_slice_gathers(Entries& entries) {
    append_into_slice(entries);
    append_clearance(entries);
    append_taps(entries);
    append_march(entries);
    append_samples(entries);
    append_gather(entries);
}

}  // namespace gloam::catalogue
