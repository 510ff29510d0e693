// SPDX-License-Identifier: MIT
#include "effect/study/own_value.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "effect/internal/named.hpp"
#include "effect/internal/own_integrands.hpp"

namespace gloam::effect {
namespace {

constexpr std::size_t shifts = 8;
constexpr std::uint32_t fewest = 1U << 11U;
constexpr std::uint32_t most = 1U << 17U;

// Powers of 1 / 1.2207440846, the root of x^4 = x + 1: the additive recurrence with the most even
// distribution in three dimensions.
constexpr std::array<double, 3> generator{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};

// Evenly distributed shifts, by the golden ratio and related numbers; as good as random ones.
std::array<double, 3> shift_of(std::size_t number) {
    const double n = static_cast<double>(number) + 0.5;
    return {n * 0.6180339887498949, n * 0.7548776662466927, n * 0.4142135623730951};
}

double fraction(double x) {
    return x - std::floor(x);
}

// The sum over the points `from` to `to` (excluded) of a shifted lattice.
glm::dvec2 sum_of(const Integrand& integrand, const std::array<double, 3>& shift, std::uint32_t from,
                  std::uint32_t to) {
    glm::dvec2 sum(0.0);
    for (std::uint32_t i = from; i < to; ++i) {
        std::array<double, 3> point{};
        for (std::size_t k = 0; k < 3; ++k)
            point.at(k) = fraction(shift.at(k) + generator.at(k) * static_cast<double>(i));
        sum += integrand(point);
    }
    return sum;
}

double mean_of(const glm::dvec2& sum) {
    return sum.y > 0.0 ? std::clamp(sum.x / sum.y, 0.0, 1.0) : 0.0;
}

Estimate summary(const std::array<glm::dvec2, shifts>& sums) {
    glm::dvec2 total(0.0);
    double mean = 0.0;
    for (const glm::dvec2& sum : sums) {
        total += sum;
        mean += mean_of(sum) / shifts;
    }
    double squares = 0.0;
    for (const glm::dvec2& sum : sums) squares += std::pow(mean_of(sum) - mean, 2.0);
    return {mean_of(total), std::sqrt(squares / (shifts * (shifts - 1.0)))};
}

}  // namespace

Estimate expectation(const Integrand& integrand, double tolerance) {
    std::array<glm::dvec2, shifts> sums{};
    std::uint32_t taken = 0;
    for (std::uint32_t count = fewest; count <= most; count *= 2) {
        for (std::size_t s = 0; s < shifts; ++s) sums.at(s) += sum_of(integrand, shift_of(s), taken, count);
        taken = count;
        if (const Estimate found = summary(sums); found.error <= tolerance) return found;
    }
    return summary(sums);
}

SeenSurface::SeenSurface(const scene::ClosedFormView& view, std::uint32_t pixels)
    : view_(&view), orthographic_(view.camera.projection == scene::Projection::orthographic) {
    half_ = orthographic_ ? 0.5 * view.camera.view_height : std::tan(0.5 * view.camera.fovy_rad);
    if (pixels > 0) pitch_ = 2.0 * half_ / pixels;
}

glm::dvec2 SeenSurface::snapped(const glm::dvec2& place) const {
    if (pitch_ == 0.0) return place;
    const double last = std::round((half_ - 0.5 * pitch_) / pitch_);
    return pitch_ * glm::clamp(glm::floor(place / pitch_ + 0.5), -last, last);
}

Seen SeenSurface::at(const glm::dvec2& place) const {
    const glm::dvec2 center = snapped(place);
    const glm::dvec3 origin(orthographic_ ? center : glm::dvec2(0.0), 0.0);
    const glm::dvec3 direction(orthographic_ ? glm::dvec2(0.0) : center, -1.0);
    Seen seen{.own_pixel = pitch_ > 0.0 && center == glm::dvec2(0.0)};
    const auto hit = view_->scene.first_hit(origin, direction);
    seen.background = !hit;
    seen.depth = hit ? hit->distance : std::numeric_limits<double>::infinity();
    if (!hit) return seen;
    seen.offset = origin + hit->distance * direction - view_->point;
    seen.normal = glm::dot(hit->normal, direction) > 0.0 ? -hit->normal : hit->normal;
    return seen;
}

SeenSurface::Compared SeenSurface::compared(const glm::dvec3& point) const {
    if (!(point.z < 0.0)) return {};
    const glm::dvec2 place = glm::dvec2(point) / (orthographic_ ? 1.0 : -point.z);
    const double buffer = at(place).depth;
    if (pitch_ == 0.0) return {-point.z, buffer};
    const glm::dvec3 origin(orthographic_ ? snapped(place) : glm::dvec2(0.0), 0.0);
    const glm::dvec3 ray(orthographic_ ? glm::dvec2(0.0) : snapped(place), -1.0);
    const double facing = glm::dot(normal(), ray);
    const double depth = glm::dot(normal(), point - origin) / facing;
    return {facing < 0.0 && depth > 0.0 ? depth : -point.z, buffer};
}

const std::vector<OwnValue>& own_values() {
    static const std::vector<OwnValue> all{
        {"hemisphere", own::hemisphere},
        {"disc", own::disc},
        {"crytek", own::crytek},
        {"filion", own::filion},
        {"alchemy", own::alchemy},
        {"sao", own::sao},
        {"sao_chain", own::sao},
        {"issao", own::issao},
        {"issao_distinct", nullptr, "which of its taps count depends on where pixels lie"},
        {"issao_attenuated", own::issao_attenuated},
        {"issao_basic", own::issao_basic},
        {"aksoy_phaneuf", own::aksoy_phaneuf},
        {"volumetric", own::volumetric},
        {"volumetric_two", own::volumetric_two},
        {"volumetric_spiral", own::volumetric},  // the same ball by another pattern
        {"tangent_sphere", own::tangent_sphere},
        {"angle", own::angle},
        {"hbao", own::hbao},
        {"hbao_study", own::hbao_study},
        {"dual_resolution", own::hbao},  // whose results it takes, or interpolates
        {"gtao", own::gtao},
        {"sweep", own::sweep},
        {"bitmask", own::bitmask},
        {"separable", nullptr, "half of a pixel's result is that of the pixels beside it"},
        {"mssao", nullptr,
         "most of its samples lie in images of other resolutions, made of the depths' medians"},
        {"volumetric_area", nullptr, "its samples are blocks of pixels, larger the fewer there are"},
        {"hsao", own::hsao},
        {"poisson", own::poisson},
        {"ssdo", own::ssdo},
        {"unreal", own::unreal},
        {"sphere_proxy", own::sphere_proxy, "", true},
        {"disc_proxy", own::disc_proxy},
        {"disc_proxy_two", nullptr, "its discs count by what other pixels see"},
        {"mixture", own::mixture, "", true},
        {"curvature", own::curvature},
        {"depth_darkening", own::depth_darkening},
        {"aksoy_phaneuf_two", own::aksoy_phaneuf_two},
    };
    return all;
}

const OwnValue& own_value_of(std::string_view method) {
    return named(own_values(), method, "own value of the method");
}

std::optional<Estimate> own_value(const scene::ClosedFormView& view, const Settings& settings,
                                  std::uint32_t pixels, double tolerance) {
    if (settings.radius != 1.0F)
        throw std::invalid_argument(
            fmt::format("radius {:g}: expected 1, the unit of the views", settings.radius));
    const OwnValue& own = own_value_of(settings.method);
    if (own.integrand == nullptr || (own.of_pixels && pixels == 0)) return std::nullopt;
    return expectation(own.integrand(SeenSurface(view, pixels), settings), tolerance);
}

}  // namespace gloam::effect
