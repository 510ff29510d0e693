// SPDX-License-Identifier: MIT
#include "numeric/similarity.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace gloam::numeric {
namespace {

constexpr int half_window = 5;
constexpr double deviation = 1.5;  // pixels
constexpr double c1 = 0.01 * 0.01;
constexpr double c2 = 0.03 * 0.03;

// Sums over a window: the number of known pixels, the two images, their squares and their product.
using Sums = std::array<double, 6>;

std::array<double, half_window + 1> gaussian() {
    std::array<double, half_window + 1> weights{};
    for (int i = 0; i <= half_window; ++i)
        weights[static_cast<std::size_t>(i)] = std::exp(-0.5 * i * i / (deviation * deviation));
    return weights;
}

// Applies the separable window along one axis, whose pixels are `stride` apart.
void blur_line(std::vector<Sums>& image, std::size_t start, std::size_t stride, std::size_t count) {
    static const std::array<double, half_window + 1> weights = gaussian();
    std::vector<Sums> line(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t first = i < half_window ? 0 : i - half_window;
        const std::size_t last = std::min(count - 1, i + half_window);
        for (std::size_t k = first; k <= last; ++k) {
            const double weight = weights[k > i ? k - i : i - k];
            const Sums& from = image[start + k * stride];
            for (std::size_t s = 0; s < from.size(); ++s) line[i][s] += weight * from[s];
        }
    }
    for (std::size_t i = 0; i < count; ++i) image[start + i * stride] = line[i];
}

double similarity_of(const Sums& s) {
    const double x = s[1] / s[0];
    const double y = s[2] / s[0];
    const double xx = s[3] / s[0] - x * x;
    const double yy = s[4] / s[0] - y * y;
    const double xy = s[5] / s[0] - x * y;
    return (2.0 * x * y + c1) * (2.0 * xy + c2) / ((x * x + y * y + c1) * (xx + yy + c2));
}

}  // namespace

double structural_similarity(std::span<const double> image, std::span<const double> truth, std::size_t width,
                             std::size_t height) {
    const std::size_t pixels = width * height;
    if (image.size() != pixels || truth.size() != pixels) {
        throw std::invalid_argument(fmt::format("similarity of {} and {} pixels, expected {} x {}",
                                                image.size(), truth.size(), width, height));
    }
    std::vector<Sums> sums(pixels, Sums{});
    for (std::size_t i = 0; i < pixels; ++i) {
        if (!std::isfinite(truth[i])) continue;
        const double x = image[i];
        const double y = truth[i];
        sums[i] = {1.0, x, y, x * x, y * y, x * y};
    }
    for (std::size_t y = 0; y < height; ++y) blur_line(sums, y * width, 1, width);
    for (std::size_t x = 0; x < width; ++x) blur_line(sums, x, width, height);
    double total = 0.0;
    std::size_t known = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (!std::isfinite(truth[i])) continue;
        total += similarity_of(sums[i]);
        ++known;
    }
    return known == 0 ? 1.0 : total / static_cast<double>(known);
}

}  // namespace gloam::numeric
