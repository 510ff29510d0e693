// SPDX-License-Identifier: MIT
#include "effect/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "numeric/similarity.hpp"

namespace gloam::effect {

namespace {

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

// Projects in double, independently of the shaders.
class Projector {
  public:
    explicit Projector(const scene::GBuffer& view)
        : p_(view.camera.p00_p11()),
          size_(view.extent.width, view.extent.height),
          off_centre_(view.off_centre),
          world_from_view_(glm::inverse(glm::dmat4(view.camera.view))),
          orthographic_(view.camera.orthographic()) {}

    [[nodiscard]] glm::dvec3 world(const glm::dvec3& at) const {
        return glm::dvec3(world_from_view_ * glm::dvec4(at, 1.0));
    }

    // Whether the ball around a point projects into the image, at least a pixel from its border. The ball
    // does so if it is in front of the four planes through the eye and the border.
    [[nodiscard]] bool ball_inside(const glm::dvec3& center, double radius) const {
        for (const double side : {-1.0, 1.0}) {
            // Where the border is at depth 1; orthographic: at any depth. Outside is where p * side points.
            const glm::dvec2 edge = (side * (1.0 - 2.0 / size_) + off_centre_ / size_) / p_;
            for (int axis = 0; axis < 2; ++axis) {
                const double limit = orthographic_ ? edge[axis] : -center.z * edge[axis];
                const double scale = orthographic_ ? 1.0 : std::sqrt(1.0 + edge[axis] * edge[axis]);
                const double inside = (limit - center[axis]) * (p_[axis] > 0.0 ? side : -side);
                if (!(inside > radius * scale)) return false;
            }
        }
        return orthographic_ || -center.z > radius;
    }

  private:
    glm::dvec2 p_;
    glm::dvec2 size_;
    glm::dvec2 off_centre_;
    glm::dmat4 world_from_view_;
    bool orthographic_;
};

}  // namespace

Errors errors_of(std::span<const float> occlusion, std::span<const float> truth) {
    std::vector<double> magnitudes;
    Errors errors;
    double squares = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (!std::isfinite(truth[i])) continue;
        const double difference = double{occlusion[i]} - double{truth[i]};
        magnitudes.push_back(std::abs(difference));
        squares += difference * difference;
        errors.bias += difference;
        errors.mean += std::abs(difference);
    }
    if (magnitudes.empty()) return errors;
    errors.compared = magnitudes.size();
    const auto count = static_cast<double>(errors.compared);
    errors.rmse = std::sqrt(squares / count);
    errors.mean /= count;
    errors.bias /= count;
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.99 * count)) - 1;
    std::nth_element(magnitudes.begin(), magnitudes.begin() + rank, magnitudes.end());
    errors.percentile_99 = magnitudes[static_cast<std::size_t>(rank)];
    errors.max = *std::max_element(magnitudes.begin(), magnitudes.end());
    return errors;
}

Truth truth_of(const scene::GBuffer& view, double radius, const TrueOcclusion& true_occlusion) {
    const Projector projector(view);
    const scene::PixelPositions positions(view);
    Truth truth(view.depth.size(), unknown);
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (!std::isfinite(view.depth[i])) continue;
        const glm::dvec3 at = positions.at(i, double{view.depth[i]});
        if (!projector.ball_inside(at, radius)) continue;
        truth[i] = static_cast<float>(true_occlusion(projector.world(at), radius));
    }
    return truth;
}

Truth truth_from(const scene::GBuffer& view, std::span<const float> reference) {
    Truth truth(reference.begin(), reference.end());
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (!std::isfinite(view.depth[i])) truth[i] = unknown;
    }
    return truth;
}

double structural_similarity(std::span<const float> occlusion, std::span<const float> truth,
                             backend::Extent extent) {
    const auto visibility = [](std::span<const float> of) {
        std::vector<double> values;
        for (const float value : of) values.push_back(1.0 - double{value});
        return values;
    };
    return numeric::structural_similarity(visibility(occlusion), visibility(truth), extent.width,
                                          extent.height);
}

Metrics metrics_of(std::span<const float> occlusion, std::span<const float> truth, backend::Extent extent) {
    Metrics metrics{.raw = errors_of(occlusion, truth),
                    .similarity = structural_similarity(occlusion, truth, extent),
                    .remap = best_remap(occlusion, truth)};
    const std::vector<float> nearest = remapped(occlusion, metrics.remap);
    metrics.after_remap = errors_of(nearest, truth);
    metrics.similarity_after_remap = structural_similarity(nearest, truth, extent);
    return metrics;
}

Truth masked(std::span<const float> truth, const Mask& mask) {
    Truth result(truth.begin(), truth.end());
    for (std::size_t i = 0; i < result.size(); ++i)
        if (mask[i] == 0) result[i] = unknown;
    return result;
}

ClassErrors class_errors_of(std::span<const float> occlusion, std::span<const float> truth,
                            const PixelClasses& classes) {
    ClassErrors errors;
    for (std::size_t i = 0; i < errors.size(); ++i)
        errors[i] = errors_of(occlusion, masked(truth, classes.mask(static_cast<PixelClass>(i))));
    return errors;
}

}  // namespace gloam::effect
