// SPDX-License-Identifier: MIT
// Methods that work in slices through the eye: GTAO and the visibility bitmask.
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/occlusion_parts.hpp"
#include "numeric/constants.hpp"
#include "reference/geometry.hpp"
#include "reference/occlusion_slices.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;
using Slice = reference::GloamSlice;

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
// Unit vectors in the plane: (cosine, sine) of an angle; what stands for no direction, and NaN.
Values directions() {
    return unit_vector(2)
        .and_value(glm::vec2(1, 0))
        .and_value(glm::vec2(0, 1))
        .and_value(glm::vec2(0))
        .and_value(glm::vec2(NAN))
        .only_as_drawn();
}
Values cosines() {
    return either(uniform(-1, 1), uniform(0.99, 1)).and_near({-1.0, 0.0, 1.0}).and_special();
}
Values elevations() {
    return uniform(0, 3.1415927).and_near({0.0}).and_special();
}

// Slices of view vectors and normals that face the eye at a moderate angle.
Values slices() {
    return made_by<Slice>([](numeric::Random& random) {
        const double azimuth = random.uniform(0, 3.14159265);
        const glm::dvec3 view = glm::normalize(glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), 1.5));
        const glm::dvec3 normal = glm::normalize(glm::dvec3(random.uniform(-2, 2), random.uniform(-2, 2), 1));
        const auto slice = reference::gloam_slice(reference::dvec2(std::cos(azimuth), std::sin(azimuth)),
                                                  reference::dvec3(view), reference::dvec3(normal));
        return Slice{glm::vec3(slice.view), glm::vec3(slice.tangent), glm::vec2(slice.normal),
                     static_cast<float>(slice.angle), static_cast<float>(slice.weight)};
    });
}

// Slices, and some whose weight is zero, negative, infinite or NaN.
Values slices_of_bad_weight() {
    Values values = slices().only_as_drawn();
    numeric::Random random(3);
    DrawContext context{.random = random};
    for (const float weight : {0.0F, -0.5F, INFINITY, NAN}) {
        Values::Fixed slice;
        values.draw(context, slice.words);
        slice.words.back() = to_word(weight);
        values.fixed.push_back(std::move(slice));
    }
    return values;
}

// Whether an offset is nearly in a slice, and its length is within the range of floats.
bool lies_in_slice(glm::dvec3 offset, const Slice& slice) {
    const double length = glm::length(offset);
    const double x = glm::dot(offset, glm::dvec3(slice.tangent)) / length;
    const double y = glm::dot(offset, glm::dvec3(slice.view)) / length;
    return x * x + y * y > 0.1;
}

constexpr const char* slice_file = "gloam/geometry/slice.glsl";

void append_slice(Entries& entries) {
    using Make = Slice(glm::vec2, glm::vec3, glm::vec3);
    const Values view =
        made_by<glm::vec3>([](numeric::Random& random) {
            return glm::vec3(glm::normalize(glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), 1.5)));
        })
            .and_value(glm::vec3(0, 0, 1))
            .and_value(glm::vec3(1, 0, 0))  // along a direction of the image
            .only_as_drawn();
    entries.push_back(equation<Make>(
        {.id = "GTAO-slice",
         .function = "gloam_slice",
         .file = slice_file,
         .title = "slice through the eye, and the normal in it",
         .formula = "t = d - (d . v) v, normalised; n = atan((N . t) / (N . v)), weight |(N . t, N . v)|",
         .source = gtao_source},
        &reference::gloam_slice,
        {.domain = {unit_vector(2), view, unit_vector(3).only_as_drawn()},
         .budget = {.absolute = 6e-7},
         .codomain = {-numeric::largest_float, numeric::largest_float},
         .promised = make_predicate<Make>([](glm::dvec2 d, glm::dvec3 v, glm::dvec3 n) {
             const glm::dvec3 along(d, 0.0);
             const glm::dvec3 across = along - glm::dot(along, v) * v;
             const double x = glm::dot(n, across);
             const double y = glm::dot(n, v);
             const bool one_way = y > 0.0 || std::abs(x) > 1e-6;
             return one_way && glm::dot(across, across) > 0.1 && x * x + y * y > 0.1 &&
                    moderate(1e-9, 2, v, n);
         })}));
}

void append_slice_parts(Entries& entries) {
    entries.push_back(equation<float(Slice)>(
        {.id = "GTAO-slice-whole",
         .function = "gloam_slice_whole",
         .file = slice_file,
         .title = "amount of an empty half plane",
         .formula = "cos n + n sin n",
         .source = gtao_source},
        &reference::gloam_slice_whole,
        {.domain = {slices().only_as_drawn()}, .budget = {.absolute = 3e-7}, .codomain = {0.99999, 1.571}}));
    using Direction = glm::vec2(glm::vec3, Slice);
    entries.push_back(equation<Direction>({.id = "GTAO-slice-direction",
                                           .function = "gloam_slice_direction",
                                           .file = slice_file,
                                           .title = "direction of a sample in a slice",
                                           .formula = "(v . view, v . t), normalised",
                                           .source = gtao_source},
                                          &reference::gloam_slice_direction,
                                          {.domain = {offsets(), slices()},
                                           .budget = {.absolute = 4e-7},
                                           .codomain = {-1.000001, 1.000001},
                                           .promised = make_predicate<Direction>(lies_in_slice)}));
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
                          &reference::gloam_gtao_horizon,
                          {.domain = {uniform(-1, 1).and_value(-1.0F), uniform(-1, 1), offsets(),
                                      unit_vector(3), uniform(0, 1).and_near({0.0, 1.0}).and_special()},
                           .budget = {.absolute = 4e-7},
                           .codomain = {-1, 1}}));
    entries.push_back(equation<glm::vec2(Slice)>(
        {.id = "GTAO-lowest",
         .function = "gloam_gtao_lowest",
         .file = gtao_file,
         .title = "horizons of the tangent plane",
         .formula = "(cos(n - pi / 2), cos(n + pi / 2))",
         .source = gtao_source},
        &reference::gloam_gtao_lowest,
        {.domain = {slices().only_as_drawn()}, .codomain = {-1.000001, 1.000001}}));
    entries.push_back(
        equation<float(float, float)>({.id = "GTAO-elevation",
                                       .function = "gloam_gtao_elevation",
                                       .file = gtao_file,
                                       .title = "how far a horizon rises above the tangent plane",
                                       .formula = "max(n + pi / 2 - acos c, 0)",
                                       .source = gtao_source},
                                      &reference::gloam_gtao_elevation,
                                      {.domain = {cosines(), projected_angles()},
                                       .budget = {.absolute = 6e-7},
                                       .codomain = {0, 3.1415928}}));
}

void append_gtao_arcs(Entries& entries) {
    using Inner = float(float, float);
    entries.push_back(equation<Inner>(
        {.id = "GTAO-inner",
         .function = "gloam_gtao_inner",
         .file = gtao_file,
         .title = "inner integral of a slice as printed, one side",
         .formula = "1/4 (-cos(2 h - n) + cos n + 2 h sin n)",
         .source = "Jimenez et al. 2016, eq 10"},
        &reference::gloam_gtao_inner,
        {.domain = {uniform(-3.1415926, 3.1415926).and_near({0.0}).and_special(), projected_angles()},
         .budget = {.absolute = 5e-7},
         .codomain = {0, half_pi},
         .promised = make_predicate<Inner>(
             [](double h, double n) { return !(std::abs(h) > 4) && !(std::abs(n) > 4); })}));
    using Arc = float(float, glm::vec2, glm::vec2);
    entries.push_back(
        equation<Arc>({.id = "GTAO-arc",
                       .function = "gloam_gtao_arc",
                       .file = gtao_file,
                       .title = "what a horizon takes from a slice, cosine-weighted",
                       .formula = "1/2 (e sin n + cos h cos(h - n))",
                       .source = "derived from Jimenez et al. 2016, eq 10"},
                      &reference::gloam_gtao_arc,
                      {.domain = {elevations(), directions(), directions()},
                       .budget = {.absolute = 3e-7},
                       .codomain = {0, half_pi},
                       .promised = make_predicate<Arc>([](double, const glm::dvec2& h, const glm::dvec2& n) {
                           return glm::dot(h, h) < 1.001 && glm::dot(n, n) < 1.001;
                       })}));
}

void append_gtao_sides(Entries& entries) {
    using Pair = float(float, float);
    entries.push_back(
        equation<Pair>({.id = "GTAO-arc-uniform",
                        .function = "gloam_gtao_arc_uniform",
                        .file = gtao_file,
                        .title = "what a horizon takes from a slice, all directions alike",
                        .formula = "1/2 (sin n + cos h)",
                        .source = "derived: the integral of |sin| over the arc"},
                       &reference::gloam_gtao_arc_uniform,
                       {.domain = {cosines(), cosines()}, .budget = {.absolute = 1e-7}, .codomain = {0, 1}}));
    using Side = float(float, float, glm::vec2);
    entries.push_back(
        equation<Side>({.id = "GTAO-side",
                        .function = "gloam_gtao_side",
                        .file = gtao_file,
                        .title = "what a horizon takes from a slice, from its cosine",
                        .formula = "arc(n + pi / 2 - acos c, (c, sqrt(1 - c^2)), n)",
                        .source = "derived from Jimenez et al. 2016, eq 10"},
                       &reference::gloam_gtao_side,
                       {.domain = {cosines(), projected_angles(), directions()},
                        .budget = {.absolute = 8e-7},
                        .codomain = {0, half_pi},
                        .promised = make_predicate<Side>([](double, double n, const glm::dvec2& normal) {
                            return std::abs(n) <= 1.6 && glm::dot(normal, normal) < 1.001;
                        })}));
}

void append_gtao_sums(Entries& entries) {
    const Values sum = vector(2, uniform(0, 4));
    const Values horizons = vector(2, cosines());
    const Values any_weight = slices_of_bad_weight();
    using Add = glm::vec2(glm::vec2, Slice, glm::vec2);
    entries.push_back(equation<Add>(
        {.id = "GTAO-add",
         .function = "gloam_gtao_add",
         .file = gtao_file,
         .title = "one more slice in the cosine-weighted occlusion",
         .formula = "(sum + w (side(c_1, -n) + side(c_2, n)), whole + w (cos n + n sin n))",
         .source = gtao_source},
        &reference::gloam_gtao_add,
        {.domain = {sum, any_weight, horizons}, .budget = {.absolute = 1.2e-6}, .codomain = {0, 7.2}}));
    entries.push_back(equation<Add>(
        {.id = "GTAO-add-uniform",
         .function = "gloam_gtao_add_uniform",
         .file = gtao_file,
         .title = "one more slice in the occlusion of all directions alike",
         .formula = "(sum + arc(c_1, -n) + arc(c_2, n), whole + 1)",
         .source = gtao_source},
        &reference::gloam_gtao_add_uniform,
        {.domain = {sum, any_weight, horizons}, .budget = {.absolute = 1e-6}, .codomain = {0, 8}}));
    entries.push_back(equation<float(glm::vec2)>({.id = "GTAO",
                                                  .function = "gloam_gtao_occlusion",
                                                  .file = gtao_file,
                                                  .title = "occlusion of all slices",
                                                  .formula = "occluded / whole",
                                                  .source = "Jimenez et al. 2016, self-normalised"},
                                                 &reference::gloam_gtao_occlusion,
                                                 {.domain = {sum.and_value(glm::vec2(0)).and_special()},
                                                  .budget = {.ulp = 0.5, .absolute = 1e-37},
                                                  .codomain = {0, 1}}));
}

void append_fractions(Entries& entries) {
    const auto append = [&](std::string id, std::string function, std::string title, std::string formula,
                            std::string source, auto reference, double error) {
        using Fraction = float(glm::vec2, Slice);
        entries.push_back(
            equation<Fraction>({.id = std::move(id),
                                .function = std::move(function),
                                .file = bitmask_file,
                                .title = std::move(title),
                                .formula = std::move(formula),
                                .source = std::move(source)},
                               reference,
                               {.domain = {directions(), slices().only_as_drawn()},
                                .budget = {.absolute = error},
                                .codomain = {0, 1},
                                // Not at the cut at pi.
                                .promised = make_predicate<Fraction>([](const glm::dvec2& d, const Slice&) {
                                    return glm::dot(d, d) < 1.001 && !(d.x < 0 && std::abs(d.y) < 1e-5);
                                })}));
    };
    append("BITMASK-fraction", "gloam_slice_fraction_angle",
           "part of a slice below a direction, all angles alike", "(a - n) / pi + 1/2", bitmask_source,
           &reference::gloam_slice_fraction_angle, 3.5e-7);
    append("BITMASK-fraction-cosine", "gloam_slice_fraction_cosine",
           "part of a slice below a direction, cosine-weighted",
           "integral of cos(b - n) |sin b| from n - pi / 2 to a, over the whole",
           "derived: the measure of Jimenez et al. 2016", &reference::gloam_slice_fraction_cosine, 5e-7);
    append("BITMASK-fraction-uniform", "gloam_slice_fraction_uniform",
           "part of a slice below a direction, by solid angle",
           "half the integral of |sin b| from n - pi / 2 to a", "derived",
           &reference::gloam_slice_fraction_uniform, 1.5e-7);
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
           "bit i where lower <= (i + 1/2) / 32 < upper", &reference::gloam_bitmask_sectors, {});
    append("BITMASK-sectors-outward", "gloam_bitmask_sectors_outward", "sectors by the rounding of the paper",
           "ceil(32 (upper - lower)) bits from floor(32 lower) on", &reference::gloam_bitmask_sectors_outward,
           {.backward_ulp = 1});
    const Values bits = either(log_integers(2147483647), integers(-2147483648L, 2147483647));
    entries.push_back(equation<unsigned(unsigned)>({.id = "BIT-count",
                                                    .function = "gloam_bit_count",
                                                    .file = "gloam/numeric/bit_count.glsl",
                                                    .title = "number of bits set",
                                                    .formula = "sum of the digits in base 2",
                                                    .source = "definition"},
                                                   &reference::gloam_bit_count, {.domain = {bits}}));
    const Values index = integers(0, 32).and_near_integers({0, 31, 32});
    entries.push_back(equation<unsigned(unsigned, unsigned)>({.id = "BIT-range",
                                                              .function = "gloam_bit_range",
                                                              .file = bitmask_file,
                                                              .title = "bits first to last - 1",
                                                              .formula = "2^last - 2^first",
                                                              .source = "definition"},
                                                             &reference::gloam_bit_range,
                                                             {.domain = {index, index}}));
    entries.push_back(equation<float(unsigned)>({.id = "BITMASK",
                                                 .function = "gloam_bitmask_occlusion",
                                                 .file = bitmask_file,
                                                 .title = "occlusion of a slice by the sectors covered",
                                                 .formula = "bits set / 32",
                                                 .source = bitmask_source},
                                                &reference::gloam_bitmask_occlusion,
                                                {.domain = {bits}, .codomain = {0, 1}}));
}

void append_bitmask_back(Entries& entries) {
    using Back = glm::vec2(glm::vec3, Slice, float);
    entries.push_back(equation<Back>(
        {.id = "BITMASK-back",
         .function = "gloam_bitmask_back",
         .file = bitmask_file,
         .title = "direction of the back of a sample of some thickness",
         .formula = "direction of v - thickness view",
         .source = bitmask_source},
        &reference::gloam_bitmask_back,
        {.domain = {offsets(), slices(), log_uniform(0.01, 1).and_special()},
         .budget = {.absolute = 1e-6},
         .codomain = {-1.000001, 1.000001},
         .promised = make_predicate<Back>([](glm::dvec3 offset, const Slice& slice, double thickness) {
             const double across = glm::dot(offset, glm::dvec3(slice.tangent));
             return std::abs(across) > 0.1 && glm::length(offset) < 3 &&
                    !(thickness > 2 && thickness < 1e38) && moderate(1e-9, 2, thickness);
         })}));
}

}  // namespace

void append_slice_methods(Entries& entries) {
    append_slice(entries);
    append_slice_parts(entries);
    append_gtao_horizons(entries);
    append_gtao_arcs(entries);
    append_gtao_sides(entries);
    append_gtao_sums(entries);
    append_bitmask_back(entries);
    append_fractions(entries);
    append_sectors(entries);
}

}  // namespace gloam::catalogue
