// SPDX-License-Identifier: MIT
// Methods that work in slices through the eye: GTAO and the visibility bitmask.
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/occlusion_parts.hpp"
#include "reference/geometry/slice.hpp"
#include "reference/occlusion/gtao.hpp"
#include "reference/occlusion/visibility_bitmask.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;
using Slice = reference::GloamSlice<float>;

constexpr const char* gtao_file = "gloam/occlusion/gtao.glsl";
constexpr const char* gtao_source = "Jimenez et al. 2016";
constexpr const char* bitmask_file = "gloam/occlusion/visibility_bitmask.glsl";
constexpr const char* bitmask_source = "Therrien et al. 2023";
constexpr double half_pi = 1.5707964;

Values offsets() {
    return either(vector_of_length(3, uniform(0.05, 1.5)), vector_of_length(3, log_uniform(1e-30, 1e30)))
        .and_value(glm::vec3(0))
        .and_special();
}
Values projected_angles() {
    return uniform(-1.5707963, 1.5707963).and_near({0.0}).and_special();
}
Values slice_angles() {
    return uniform(-3.1415926, 3.1415926).and_near({0.0}).and_special();
}
Values cosines() {
    return either(uniform(-1, 1), uniform(0.99, 1)).and_near({-1.0, 0.0, 1.0}).and_special();
}
Values elevations() {
    return uniform(0, 3.1415927).and_near({0.0}).and_special();
}

// Slices of view vectors and normals that face the eye, somewhat.
Values slices() {
    return made_by<Slice>([](numeric::Random& random) {
        const double azimuth = random.uniform(0, 3.14159265);
        const glm::dvec3 view = glm::normalize(glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), 1.5));
        const glm::dvec3 normal = glm::normalize(glm::dvec3(random.uniform(-2, 2), random.uniform(-2, 2), 1));
        const auto slice =
            reference::gloam_slice(reference::vec2<double>(std::cos(azimuth), std::sin(azimuth)),
                                   reference::vec3<double>(view), reference::vec3<double>(normal));
        return Slice{glm::vec3(slice.view), glm::vec3(slice.tangent), static_cast<float>(slice.angle),
                     static_cast<float>(slice.weight)};
    });
}

void append_slices(Entries& entries) {
    constexpr const char* file = "gloam/geometry/slice.glsl";
    using Make = Slice(glm::vec2, glm::vec3, glm::vec3);
    const Values view =
        made_by<glm::vec3>([](numeric::Random& random) {
            return glm::vec3(glm::normalize(glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), 1.5)));
        })
            .and_value(glm::vec3(0, 0, 1))
            .and_special();
    entries.push_back(equation<Make>(
        {.id = "GTAO-slice",
         .function = "gloam_slice",
         .file = file,
         .title = "slice through the eye, and the normal in it",
         .formula = "t = d - (d . v) v, normalised; n = atan((N . t) / (N . v)), weight |(N . t, N . v)|",
         .source = gtao_source},
        GLOAM_REFERENCE(gloam_slice),
        {.domain = {unit_vector(2), view, unit_vector(3).and_special()},
         .budget = {.absolute = 6e-7},
         .promised = make_predicate<Make>([](glm::dvec2 d, glm::dvec3 v, glm::dvec3 n) {
             const glm::dvec3 along(d, 0.0);
             const glm::dvec3 across = along - glm::dot(along, v) * v;
             const double x = glm::dot(n, across);
             const double y = glm::dot(n, v);
             return glm::dot(across, across) > 0.1 && x * x + y * y > 0.1 && moderate(1e-9, 2, v, n);
         })}));
    using Angle = float(glm::vec3, Slice);
    entries.push_back(
        equation<Angle>({.id = "GTAO-slice-angle",
                         .function = "gloam_slice_angle",
                         .file = file,
                         .title = "angle of a sample in a slice",
                         .formula = "atan2(v . t, v . view)",
                         .source = gtao_source},
                        GLOAM_REFERENCE(gloam_slice_angle),
                        {.domain = {offsets(), slices()},
                         .budget = {.absolute = 6e-7},
                         .codomain = {-3.1415928, 3.1415928},
                         .promised = make_predicate<Angle>([](glm::dvec3 offset, const Slice& slice) {
                             const double length = glm::length(offset);
                             const double x = glm::dot(offset, glm::dvec3(slice.tangent)) / length;
                             const double y = glm::dot(offset, glm::dvec3(slice.view)) / length;
                             // Away from the cut at pi.
                             return x * x + y * y > 0.1 && !(y < 0.0 && std::abs(x) < 1e-5);
                         })}));
}

void append_gtao_horizons(Entries& entries) {
    using Horizon = float(float, float, glm::vec3, glm::vec3, float);
    entries.push_back(
        equation<Horizon>({.id = "GTAO-horizon",
                           .function = "gloam_gtao_horizon",
                           .file = gtao_file,
                           .title = "higher of the horizon so far and a sample's",
                           .formula = "max(c, c_0 + w (v . view / |v| - c_0))",
                           .source = gtao_source},
                          GLOAM_REFERENCE(gloam_gtao_horizon),
                          {.domain = {uniform(-1, 1).and_value(-1.0F), uniform(-1, 1), offsets(),
                                      unit_vector(3), uniform(0, 1).and_near({0.0, 1.0}).and_special()},
                           .budget = {.absolute = 4e-7},
                           .codomain = {-1, 1}}));
    entries.push_back(equation<glm::vec2(float)>(
        {.id = "GTAO-lowest",
         .function = "gloam_gtao_lowest",
         .file = gtao_file,
         .title = "horizons of the tangent plane",
         .formula = "(cos(n - pi / 2), cos(n + pi / 2))",
         .source = gtao_source},
        GLOAM_REFERENCE(gloam_gtao_lowest),
        {.domain = {projected_angles()}, .budget = {.absolute = 2e-7}, .codomain = {-1.000001, 1.000001}}));
    entries.push_back(
        equation<float(float, float)>({.id = "GTAO-elevation",
                                       .function = "gloam_gtao_elevation",
                                       .file = gtao_file,
                                       .title = "how far a horizon rises above the tangent plane",
                                       .formula = "max(n + pi / 2 - acos c, 0)",
                                       .source = gtao_source},
                                      GLOAM_REFERENCE(gloam_gtao_elevation),
                                      {.domain = {cosines(), projected_angles()},
                                       .budget = {.absolute = 6e-7},
                                       .codomain = {0, 3.1415928}}));
}

// One function of an angle and the angle of the normal.
template <class Reference>
void append_of_angles(Entries& entries, Description description, Reference reference, Values first,
                      double most, Budget budget) {
    entries.push_back(equation<float(float, float)>(
        std::move(description), reference,
        {.domain = {std::move(first), projected_angles()},
         .budget = budget,
         .codomain = {0, most},
         .promised = make_predicate<float(float, float)>(
             [](double a, double n) { return !(std::abs(a) > 4) && !(std::abs(n) > 4); })}));
}

void append_gtao_arcs(Entries& entries) {
    append_of_angles(entries,
                     {.id = "GTAO-inner",
                      .function = "gloam_gtao_inner",
                      .file = gtao_file,
                      .title = "inner integral of a slice as printed, one side",
                      .formula = "1/4 (-cos(2 h - n) + cos n + 2 h sin n)",
                      .source = "Jimenez et al. 2016, eq 10"},
                     GLOAM_REFERENCE(gloam_gtao_inner), slice_angles(), half_pi, {.absolute = 5e-7});
    append_of_angles(entries,
                     {.id = "GTAO-arc",
                      .function = "gloam_gtao_arc",
                      .file = gtao_file,
                      .title = "what a horizon takes from a slice, cosine-weighted",
                      .formula = "1/2 (e sin n + sin(e - n) sin e)",
                      .source = "derived from Jimenez et al. 2016, eq 10"},
                     GLOAM_REFERENCE(gloam_gtao_arc), elevations(), half_pi, {.absolute = 5e-7});
    append_of_angles(entries,
                     {.id = "GTAO-arc-uniform",
                      .function = "gloam_gtao_arc_uniform",
                      .file = gtao_file,
                      .title = "what a horizon takes from a slice, all directions alike",
                      .formula = "sin(e / 2) cos(n - e / 2)",
                      .source = "derived: the integral of |sin| over the arc"},
                     GLOAM_REFERENCE(gloam_gtao_arc_uniform), elevations(), 1.0, {.absolute = 4e-7});
}

void append_gtao_sums(Entries& entries) {
    const Values sum = vector(2, uniform(0, 4));
    const Values both = vector(2, uniform(0, 1.5)).and_value(glm::vec2(0)).and_special();
    entries.push_back(equation<glm::vec2(glm::vec2, float, glm::vec2, float)>(
        {.id = "GTAO-add",
         .function = "gloam_gtao_add",
         .file = gtao_file,
         .title = "one more slice in the cosine-weighted occlusion",
         .formula = "(sum + w (arc(e_1, -n) + arc(e_2, n)), whole + w (cos n + n sin n))",
         .source = gtao_source},
        GLOAM_REFERENCE(gloam_gtao_add),
        {.domain = {sum, uniform(0, 1).and_special(), both, projected_angles()},
         .budget = {.absolute = 1e-6},
         .promised = make_predicate<glm::vec2(glm::vec2, float, glm::vec2, float)>(
             [](glm::dvec2, double weight, glm::dvec2, double) { return weight <= 1; })}));
    entries.push_back(equation<glm::vec2(glm::vec2, glm::vec2, float)>(
        {.id = "GTAO-add-uniform",
         .function = "gloam_gtao_add_uniform",
         .file = gtao_file,
         .title = "one more slice in the occlusion of all directions alike",
         .formula = "(sum + arc(e_1, -n) + arc(e_2, n), whole + 1)",
         .source = gtao_source},
        GLOAM_REFERENCE(gloam_gtao_add_uniform),
        {.domain = {sum, both, projected_angles()}, .budget = {.absolute = 1e-6}, .codomain = {0, 8}}));
    entries.push_back(equation<float(glm::vec2)>({.id = "GTAO",
                                                  .function = "gloam_gtao_occlusion",
                                                  .file = gtao_file,
                                                  .title = "occlusion of all slices",
                                                  .formula = "occluded / whole",
                                                  .source = "Jimenez et al. 2016, self-normalised"},
                                                 GLOAM_REFERENCE(gloam_gtao_occlusion),
                                                 {.domain = {sum.and_value(glm::vec2(0)).and_special()},
                                                  .budget = {.ulp = 0.5, .absolute = 1e-37},
                                                  .codomain = {0, 1}}));
}

void append_fractions(Entries& entries) {
    append_of_angles(entries,
                     {.id = "BITMASK-fraction",
                      .function = "gloam_slice_fraction_angle",
                      .file = bitmask_file,
                      .title = "part of a slice below an angle, all angles alike",
                      .formula = "(a - n) / pi + 1/2",
                      .source = bitmask_source},
                     GLOAM_REFERENCE(gloam_slice_fraction_angle), slice_angles(), 1.0, {.absolute = 2e-7});
    append_of_angles(entries,
                     {.id = "BITMASK-fraction-cosine",
                      .function = "gloam_slice_fraction_cosine",
                      .file = bitmask_file,
                      .title = "part of a slice below an angle, cosine-weighted",
                      .formula = "integral of cos(b - n) |sin b| from n - pi / 2 to a, over the whole",
                      .source = "derived: the measure of Jimenez et al. 2016"},
                     GLOAM_REFERENCE(gloam_slice_fraction_cosine), slice_angles(), 1.0, {.absolute = 6e-7});
    append_of_angles(entries,
                     {.id = "BITMASK-fraction-uniform",
                      .function = "gloam_slice_fraction_uniform",
                      .file = bitmask_file,
                      .title = "part of a slice below an angle, by solid angle",
                      .formula = "half the integral of |sin b| from n - pi / 2 to a",
                      .source = "derived"},
                     GLOAM_REFERENCE(gloam_slice_fraction_uniform), slice_angles(), 1.0, {.absolute = 5e-7});
}

void append_sectors(Entries& entries) {
    const Values fractions =
        vector(2, either(uniform(0, 1), uniform(-0.1, 1.1)).and_near({0.0, 1.0})).and_special();
    const auto append = [&](std::string id, std::string function, std::string title, std::string formula,
                            auto reference, Budget budget) {
        entries.push_back(equation<unsigned(glm::vec2)>({.id = std::move(id),
                                                         .function = std::move(function),
                                                         .file = bitmask_file,
                                                         .title = std::move(title),
                                                         .formula = std::move(formula),
                                                         .source = bitmask_source},
                                                        reference,
                                                        {.domain = {fractions}, .budget = budget}));
    };
    append("BITMASK-sectors", "gloam_bitmask_sectors", "sectors whose centres a sample covers",
           "bit i where lower <= (i + 1/2) / 32 < upper", GLOAM_REFERENCE(gloam_bitmask_sectors), {});
    append("BITMASK-sectors-outward", "gloam_bitmask_sectors_outward", "sectors by the rounding of the paper",
           "ceil(32 (upper - lower)) bits from floor(32 lower) on",
           GLOAM_REFERENCE(gloam_bitmask_sectors_outward), {.backward_ulp = 1});
    const Values bits = either(log_integers(2147483647), integers(-2147483648L, 2147483647));
    entries.push_back(equation<unsigned(unsigned)>({.id = "BIT-count",
                                                    .function = "gloam_bit_count",
                                                    .file = "gloam/numeric/bit_count.glsl",
                                                    .title = "number of bits set",
                                                    .formula = "sum of the digits in base 2",
                                                    .source = "definition"},
                                                   GLOAM_REFERENCE(gloam_bit_count), {.domain = {bits}}));
    const Values index = integers(0, 32).and_near_integers({0, 31, 32});
    entries.push_back(equation<unsigned(unsigned, unsigned)>({.id = "BIT-range",
                                                              .function = "gloam_bit_range",
                                                              .file = bitmask_file,
                                                              .title = "bits first to last - 1",
                                                              .formula = "2^last - 2^first",
                                                              .source = "definition"},
                                                             GLOAM_REFERENCE(gloam_bit_range),
                                                             {.domain = {index, index}}));
    entries.push_back(equation<float(unsigned)>({.id = "BITMASK",
                                                 .function = "gloam_bitmask_occlusion",
                                                 .file = bitmask_file,
                                                 .title = "occlusion of a slice by the sectors covered",
                                                 .formula = "bits set / 32",
                                                 .source = bitmask_source},
                                                GLOAM_REFERENCE(gloam_bitmask_occlusion),
                                                {.domain = {bits}, .codomain = {0, 1}}));
}

void append_bitmask_angles(Entries& entries) {
    using Angles = glm::vec2(glm::vec3, Slice, float);
    entries.push_back(equation<Angles>(
        {.id = "BITMASK-angles",
         .function = "gloam_bitmask_angles",
         .file = bitmask_file,
         .title = "angles that a sample of some thickness covers",
         .formula = "angles of v and v - thickness view, in order",
         .source = bitmask_source},
        GLOAM_REFERENCE(gloam_bitmask_angles),
        {.domain = {offsets(), slices(), log_uniform(0.01, 1).and_special()},
         .budget = {.absolute = 1.5e-6},
         .codomain = {-3.1415928, 3.1415928},
         .promised = make_predicate<Angles>([](glm::dvec3 offset, const Slice& slice, double thickness) {
             const double across = glm::dot(offset, glm::dvec3(slice.tangent));
             return std::abs(across) > 0.1 && glm::length(offset) < 3 &&
                    !(thickness > 2 && thickness < 1e38) && moderate(1e-9, 2, thickness);
         })}));
}

}  // namespace

void append_slice_methods(Entries& entries) {
    append_slices(entries);
    append_gtao_horizons(entries);
    append_gtao_arcs(entries);
    append_gtao_sums(entries);
    append_bitmask_angles(entries);
    append_fractions(entries);
    append_sectors(entries);
}

}  // namespace gloam::catalogue
