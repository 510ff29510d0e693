// SPDX-License-Identifier: MIT
#include "effect/pixel_classes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "numeric/numbers.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

namespace {

using scene::is_surface;

glm::dmat4 camera_change(const scene::CameraFrame& camera) {
    if (camera.previous_from_current) return glm::dmat4(*camera.previous_from_current);
    if (camera.previous_view)
        return glm::dmat4(*camera.previous_view) * glm::inverse(glm::dmat4(camera.view));
    return glm::dmat4(1.0);
}

// The positions of a view's surface points in the previous frame.
class Earlier {
  public:
    Earlier(const scene::GBuffer& view, const scene::GBuffer& previous)
        : view_(view), now_(view), then_(previous), change_(camera_change(view.camera)) {}

    struct Point {
        glm::dvec3 position{0};  // in the previous frame's view space
        glm::dvec3 normal{0};
        glm::dvec3 if_still{0};  // the position if only the camera had moved
        double footprint = 0.0;  // width of a pixel there, world units
    };

    [[nodiscard]] std::optional<Point> of(std::size_t pixel) const {
        const double depth = view_.depth[pixel];
        const glm::dvec3 here = now_.at(pixel, depth);
        Point point;
        point.if_still = glm::dvec3(change_ * glm::dvec4(here, 1.0));
        point.normal = glm::dmat3(change_) * glm::dvec3(view_.normal[pixel]);
        point.position = position_of(pixel, point.if_still);
        const double d = -point.position.z;
        if (!(d > 0.0) && !then_.orthographic()) return std::nullopt;
        if (!view_.motion.empty() && view_.previous_position.empty() && !(view_.motion[pixel].z > 0.5F))
            return std::nullopt;
        point.footprint = 1.0 / then_.pixels_of_length(1.0, d);
        return point;
    }

  private:
    [[nodiscard]] glm::dvec3 position_of(std::size_t pixel, const glm::dvec3& if_still) const {
        if (!view_.previous_position.empty()) return view_.previous_position[pixel];
        if (view_.motion.empty()) return if_still;
        return then_.at(pixel, -if_still.z, -glm::dvec2(view_.motion[pixel]));
    }

    const scene::GBuffer& view_;
    scene::PixelPositions now_;
    scene::PixelPositions then_;
    glm::dmat4 change_;
};

struct Candidate {
    long x;
    long y;
    double weight;
};

// The four pixels around a position in the image, with bilinear weights.
std::array<Candidate, 4> around(const glm::dvec2& place) {
    const double left = std::floor(place.x - 0.5);
    const double top = std::floor(place.y - 0.5);
    const double u = place.x - 0.5 - left;
    const double v = place.y - 0.5 - top;
    const auto x = static_cast<long>(left);
    const auto y = static_cast<long>(top);
    return {
        {{x, y, (1 - u) * (1 - v)}, {x + 1, y, u * (1 - v)}, {x, y + 1, (1 - u) * v}, {x + 1, y + 1, u * v}}};
}

// Whether a pixel of the image can be among the four around the position; false for NaN.
bool near_image(const glm::dvec2& place, backend::Extent extent) {
    return place.x > -1.0 && place.y > -1.0 && place.x < extent.width + 1.0 && place.y < extent.height + 1.0;
}

constexpr int always = 1 << 20;  // frames

using numeric::infinity;

// Squared distances along one line: the lower envelope of parabolas at the positions where `square` is
// finite.
void transform_line(std::vector<double>& square) {
    const std::size_t count = square.size();
    std::vector<std::size_t> place(count);
    std::vector<double> from(count + 1);
    std::size_t parabolas = 0;
    for (std::size_t q = 0; q < count; ++q) {
        if (!std::isfinite(square[q])) continue;
        const auto height = [&](std::size_t p) {
            return square[p] + static_cast<double>(p) * static_cast<double>(p);
        };
        double start = -infinity;
        while (parabolas > 0) {
            const std::size_t p = place[parabolas - 1];
            start = (height(q) - height(p)) / (2.0 * static_cast<double>(q - p));
            if (start > from[parabolas - 1]) break;
            --parabolas;
            start = -infinity;
        }
        place[parabolas] = q;
        from[parabolas] = start;
        ++parabolas;
    }
    if (parabolas == 0) return;
    from[parabolas] = infinity;
    std::vector<double> result(count);
    std::size_t k = 0;
    for (std::size_t q = 0; q < count; ++q) {
        while (from[k + 1] < static_cast<double>(q)) ++k;
        const double step = static_cast<double>(q) - static_cast<double>(place[k]);
        result[q] = step * step + square[place[k]];
    }
    square = result;
}

}  // namespace

HistoryMap::HistoryMap(const scene::GBuffer& view, const scene::GBuffer& previous)
    : taps_(view.depth.size()), moved_(view.depth.size(), 0) {
    const Earlier earlier(view, previous);
    const scene::PixelPositions then(previous);
    const auto width = static_cast<long>(view.extent.width);
    const auto height = static_cast<long>(view.extent.height);
    for (std::size_t i = 0; i < taps_.size(); ++i) {
        if (!is_surface(view.depth[i])) continue;
        const auto point = earlier.of(i);
        if (!point) continue;
        moved_[i] = glm::distance(point->position, point->if_still) > 0.02 * point->footprint ? 1 : 0;
        const glm::dvec2 place = then.pixel_of(point->position);
        if (!near_image(place, view.extent)) continue;
        double sum = 0.0;
        std::size_t count = 0;
        for (const Candidate& c : around(place)) {
            if (c.x < 0 || c.y < 0 || c.x >= width || c.y >= height || !(c.weight > 1e-6)) continue;
            const auto pixel = static_cast<std::size_t>(c.y * width + c.x);
            if (!is_surface(previous.depth[pixel])) continue;
            const glm::dvec3 there = then.at(pixel, previous.depth[pixel]);
            if (std::abs(glm::dot(there - point->position, point->normal)) > 2.0 * point->footprint) continue;
            taps_[i][count++] = {static_cast<std::uint32_t>(pixel), static_cast<float>(c.weight)};
            sum += c.weight;
        }
        for (Tap& tap : taps_[i]) tap.weight = static_cast<float>(tap.weight / (sum > 0.0 ? sum : 1.0));
        std::ranges::stable_sort(taps_[i], std::greater{}, &Tap::weight);
    }
}

double HistoryMap::sample(std::size_t pixel, std::span<const float> previous) const {
    double sum = 0.0;
    for (const Tap& tap : taps_[pixel]) {
        if (tap.weight > 0.0F) sum += double{tap.weight} * double{previous[tap.pixel]};
    }
    return sum;
}

std::optional<double> mean_change(const HistoryMap& history, std::span<const float> image,
                                  std::span<const float> previous, std::span<const float> due,
                                  const Mask& mask) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (!history.seen(i) || (!mask.empty() && mask[i] == 0)) continue;
        sum +=
            std::abs(double{image[i]} - history.sample(i, previous) - (due.empty() ? 0.0 : double{due[i]}));
        ++count;
    }
    return count == 0 ? std::nullopt : std::optional(sum / static_cast<double>(count));
}

void PixelClasses::advance(const scene::GBuffer& view, const std::optional<HistoryMap>& history) {
    const std::size_t pixels = view.depth.size();
    // Pixels whose surface moved in this frame, or that showed a moving surface in the previous one.
    Mask moved(pixels, 0);
    Mask swept(pixels, 0);
    for (std::size_t i = 0; history && i < pixels; ++i) {
        moved[i] = history->moved(i) ? 1 : 0;
        swept[i] = moved[i] != 0 || moving_[i] != 0 ? 1 : 0;
    }
    const std::vector<float> distance = distance_to(swept, view.extent);
    const scene::PixelPositions positions(view);
    std::vector<int> quiet(pixels, 0);
    std::vector<int> calm(pixels, always);
    const auto class_of = [&](std::size_t i, bool seen) {
        if (!seen) return PixelClass::disoccluded;
        if (moved[i] != 0) return PixelClass::moving;
        if (calm[i] < settings_.memory) return PixelClass::near_moving;
        return quiet[i] >= settings_.settled_frames ? PixelClass::settled : PixelClass::young;
    };
    classes_.assign(pixels, PixelClass::background);
    for (std::size_t i = 0; i < pixels; ++i) {
        if (!is_surface(view.depth[i])) continue;
        const bool seen = history && history->seen(i);
        if (seen) {
            quiet[i] = std::min(always, quiet_[history->nearest(i)] + 1);
            calm[i] = std::min(always, calm_[history->nearest(i)] + 1);
        }
        const double reach = positions.pixels_of_length(settings_.radius, double{view.depth[i]});
        if (double{distance[i]} <= reach) quiet[i] = 0;
        if (double{distance[i]} <= std::min(reach, settings_.near)) calm[i] = 0;
        classes_[i] = class_of(i, seen);
    }
    quiet_ = std::move(quiet);
    calm_ = std::move(calm);
    moving_ = std::move(moved);
}

Mask PixelClasses::mask(PixelClass one) const {
    Mask found(classes_.size());
    std::ranges::transform(classes_, found.begin(), [one](PixelClass of) { return of == one ? 1 : 0; });
    return found;
}

std::vector<float> distance_to(const Mask& mask, backend::Extent extent) {
    const std::size_t width = extent.width;
    const std::size_t height = extent.height;
    std::vector<double> square(mask.size());
    for (std::size_t i = 0; i < mask.size(); ++i) square[i] = mask[i] != 0 ? 0.0 : infinity;
    const auto along = [&](std::size_t start, std::size_t stride, std::size_t count) {
        std::vector<double> line(count);
        for (std::size_t i = 0; i < count; ++i) line[i] = square[start + i * stride];
        transform_line(line);
        for (std::size_t i = 0; i < count; ++i) square[start + i * stride] = line[i];
    };
    for (std::size_t x = 0; x < width; ++x) along(x, width, height);
    for (std::size_t y = 0; y < height; ++y) along(y * width, 1, width);
    std::vector<float> distance;
    distance.reserve(square.size());
    for (const double s : square) distance.push_back(static_cast<float>(std::sqrt(s)));
    return distance;
}

}  // namespace gloam::effect
