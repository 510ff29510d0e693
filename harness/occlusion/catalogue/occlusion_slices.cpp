// SPDX-License-Identifier: MIT
// Methods that work in slices through the eye: horizon-based occlusion, GTAO and the visibility bitmask.
#include <cmath>

#include "catalogue/inputs.hpp"
#include "numeric/numbers.hpp"
#include "reference/geometry.hpp"
#include "reference/occlusion_slices.hpp"

namespace gloam::catalogue {
namespace {

using namespace subject;

constexpr double half_pi = 1.5707964;

void append_tangents(Entries& entries) {
    add(entries, "CS-C-slope", &reference::gloam_tangent_slope, {unit_vector(3), unit_vector(2)},
        {.absolute = 4e-6}, {-1e6, 1e6}, [](glm::dvec3 n, glm::dvec2) { return n.z > 0.05; });
    const Values small = uniform(-0.2, 0.2);
    add(entries, "CS-C-derivatives", &reference::gloam_tangent_slope_of_derivatives,
        {unit_vector(2), vector({uniform(0.5, 1), small, signed_log_uniform(0.01, 100)}).and_special(),
         vector({small, uniform(-1, -0.5), signed_log_uniform(0.01, 100)}).and_special()},
        {.ulp = 6, .absolute = 8e-6}, {-1e6, 1e6}, [](glm::dvec2, glm::dvec3 u, glm::dvec3 v) {
            return moderate(1e-9, 1e9, u, v) && std::abs(u.x) >= 0.4 && std::abs(v.y) >= 0.4 &&
                   std::abs(u.y) <= 0.3 && std::abs(v.x) <= 0.3;
        });
    add(entries, "CS-C-sine", &reference::gloam_sine_of_tangent,
        {either(uniform(-4, 4), signed_log_uniform(1e-30, 1e30)).and_near({1e6, -1e6}).and_special()},
        {.absolute = 2e-7}, {-1, 1});
}

void append_hbao(Entries& entries) {
    const Values bias = made_by<glm::vec2>([](numeric::Random& random) {
                            const double angle = random.uniform(0.0, 1.5707963);
                            return glm::vec2(std::cos(angle), std::sin(angle));
                        })
                            .and_value(glm::vec2(1, 0))
                            .only_as_drawn();
    add(entries, "CS-C-horizon", &reference::gloam_hbao_horizon,
        {unit_vector(3).and_value(glm::vec3(0, 0, 1)).only_as_drawn(), unit_vector(2), bias},
        {.absolute = 4e-7}, {-1.000001, 1.000001}, [](glm::dvec3 n, glm::dvec2 direction, const glm::vec2&) {
            const double across = n.x * direction.x + n.y * direction.y;
            return !(n.z * n.z + across * across < 0.05) && (n.z > 0.0 || std::abs(across) > 1e-5);
        });
    add(entries, "CS-C-start-slope", &reference::gloam_hbao_start_slope,
        {either(uniform(-4, 4), signed_log_uniform(1e-3, 1e6)).and_special(),
         uniform(0, 0.6).and_near({0.0, 1.5707963}).and_special()},
        {.absolute = 5e-7}, {-1, 1});
    add(entries, "CS-C", &reference::gloam_hbao_step,
        {vector({uniform(-1, 1), uniform(0, 1)}).only_as_drawn(), uniform(-2, 2).only_as_drawn(),
         uniform(0.01, 4).only_as_drawn(), uniform(0.5, 2).only_as_drawn()},
        {.absolute = 9e-7, .backward_ulp = 4}, {-1.000001, 3.000001});
    add(entries, "CS-C-visibility", &reference::gloam_hbao_visibility,
        {uniform(0, 1).and_special(), uniform(0, 0.8).and_near({0.0}).and_special(),
         uniform(0.5, 2).and_special()},
        {.absolute = 5e-7}, {0, 1}, [](double occlusion, double bias, double contrast) {
            return moderate(1e-9, 4, occlusion, contrast) && !(std::abs(bias) > 0.8 && std::abs(bias) < 1.6);
        });
}

using Slice = reference::GloamSlice;

// Unit vectors in the plane: (cosine, sine) of an angle; what stands for no direction, and NaN.
Values directions() {
    return unit_vector(2)
        .and_value(glm::vec2(1, 0))
        .and_value(glm::vec2(0, 1))
        .and_value(glm::vec2(0))
        .and_value(glm::vec2(NAN))
        .only_as_drawn();
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

void append_slice(Entries& entries) {
    const Values view =
        made_by<glm::vec3>([](numeric::Random& random) {
            return glm::vec3(glm::normalize(glm::dvec3(random.uniform(-1, 1), random.uniform(-1, 1), 1.5)));
        })
            .and_value(glm::vec3(0, 0, 1))
            .and_value(glm::vec3(1, 0, 0))  // along a direction of the image
            .only_as_drawn();
    add(entries, "GTAO-slice", &reference::gloam_slice,
        {unit_vector(2), view, unit_vector(3).only_as_drawn()}, {.absolute = 6e-7},
        {-numeric::largest_float, numeric::largest_float}, [](glm::dvec2 d, glm::dvec3 v, glm::dvec3 n) {
            const glm::dvec3 along(d, 0.0);
            const glm::dvec3 across = along - glm::dot(along, v) * v;
            const double x = glm::dot(n, across);
            const double y = glm::dot(n, v);
            const bool one_way = y > 0.0 || std::abs(x) > 1e-6;
            return one_way && glm::dot(across, across) > 0.1 && x * x + y * y > 0.1 &&
                   moderate(1e-9, 2, v, n);
        });
    add(entries, "GTAO-slice-whole", &reference::gloam_slice_whole, {slices().only_as_drawn()},
        {.absolute = 3e-7}, {0.99999, 1.571});
}

}  // namespace

void append_occlusion_slices(Entries& entries) {
    append_tangents(entries);
    append_hbao(entries);
    append_slice(entries);
    add(entries, "GTAO-horizon", &reference::gloam_gtao_horizon,
        {uniform(-1, 1), uniform(-1, 1).and_value(-1.0F),
         either(vector_of_length(2, uniform(0, 2)), vector_of_length(2, log_uniform(1e-18, 1e18))),
         uniform(0.5, 2)},
        {.absolute = 4e-7}, {-1.000001, 1.000001}, [](double horizon, double lowest, glm::dvec2 v, double) {
            return horizon >= lowest && !(glm::length(v) < 1e-17);
        });
    add(entries, "GTAO-arc", &reference::gloam_gtao_arc,
        {uniform(0, 3.1415927).and_near({0.0}).and_special(), directions(), directions()}, {.absolute = 3e-7},
        {0, half_pi}, [](double, const glm::dvec2& h, const glm::dvec2& n) {
            return glm::dot(h, h) < 1.001 && glm::dot(n, n) < 1.001;
        });
    add(entries, "GTAO-side", &reference::gloam_gtao_side,
        {either(uniform(-1, 1), uniform(0.99, 1)).and_near({-1.0, 0.0, 1.0}).and_special(),
         uniform(-1.5707963, 1.5707963).and_near({0.0}).and_special(), directions()},
        {.absolute = 8e-7}, {0, half_pi}, [](double, double n, const glm::dvec2& normal) {
            return std::abs(n) <= 1.6 && glm::dot(normal, normal) < 1.001;
        });
    add(entries, "BITMASK-fraction-cosine", &reference::gloam_slice_fraction_cosine,
        {directions(), slices().only_as_drawn()}, {.absolute = 5e-7}, {0, 1},
        [](const glm::dvec2& d, const Slice&) {  // not at the cut at pi
            return glm::dot(d, d) < 1.001 && !(d.x < 0 && std::abs(d.y) < 1e-5);
        });
    const Values fractions =
        vector(2, either(uniform(0, 1), uniform(-0.1, 1.1)).and_near({0.0, 1.0})).and_special();
    add(entries, "BITMASK-sectors", &reference::gloam_bitmask_sectors, {fractions});
    const Values bits = either(log_integers(2147483647), integers(-2147483648L, 2147483647));
    add(entries, "BIT-count", &reference::gloam_bit_count, {bits});
    const Values index = integers(0, 32).and_near_integers({0, 31, 32});
    add(entries, "BIT-range", &reference::gloam_bit_range, {index, index});
    add(entries, "BITMASK", &reference::gloam_bitmask_occlusion, {bits}, {}, {0, 1});
}

}  // namespace gloam::catalogue
