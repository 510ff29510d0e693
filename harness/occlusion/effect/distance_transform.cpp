// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <stdexcept>

#include "effect/pixel_classes.hpp"
#include "numeric/numbers.hpp"

namespace gloam::effect {
namespace {

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

std::vector<float> distance_to(const Mask& mask, gpu::Extent extent) {
    const std::size_t width = extent.width;
    const std::size_t height = extent.height;
    if (mask.size() != width * height) throw std::invalid_argument("distance: a mask of another size");
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
