// SPDX-License-Identifier: MIT
#pragma once

#include "effect/settings.hpp"
#include "effect/study/own_value.hpp"

// The integrands of own_values(), by family of methods. Lengths are in units of the radius.
namespace gloam::effect::own {

// Methods that compare points of the ball or half ball with the depth buffer.
[[nodiscard]] Integrand hemisphere(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand filion(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand crytek(const SeenSurface& seen, const Settings& settings);

// Methods that sample surface points under a disc.
[[nodiscard]] Integrand disc(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand alchemy(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand sao(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand issao(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand issao_attenuated(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand issao_basic(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand aksoy_phaneuf(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand aksoy_phaneuf_two(const SeenSurface& seen, const Settings& settings);

// Methods that sample opposite pairs of surface points.
[[nodiscard]] Integrand volumetric(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand volumetric_two(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand tangent_sphere(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand angle(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand depth_darkening(const SeenSurface& seen, const Settings& settings);

// Methods that sample slices through the eye. MethodValues::steps: steps to each side.
[[nodiscard]] Integrand hbao(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand hbao_study(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand gtao(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand sweep(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand bitmask(const SeenSurface& seen, const Settings& settings);

// Methods that sample rays. MethodValues::steps: steps of a ray.
[[nodiscard]] Integrand poisson(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand ssdo(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand hsao(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand unreal(const SeenSurface& seen, const Settings& settings);

// Methods that treat pixels as pieces of surface, or fit a quadric through them.
[[nodiscard]] Integrand sphere_proxy(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand disc_proxy(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand mixture(const SeenSurface& seen, const Settings& settings);
[[nodiscard]] Integrand curvature(const SeenSurface& seen, const Settings& settings);

}  // namespace gloam::effect::own
