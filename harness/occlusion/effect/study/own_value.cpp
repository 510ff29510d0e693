// SPDX-License-Identifier: MIT
#include "effect/study/own_value.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "effect/internal/named.hpp"
#include "effect/internal/own_integrands.hpp"

namespace gloam::effect {

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
    return named(own_values(), method, "method");
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
