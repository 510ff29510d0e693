// SPDX-License-Identifier: MIT
#include "effect/study/score.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace gloam::effect {
namespace {

std::size_t index_of(Against reference) {
    return static_cast<std::size_t>(reference);
}
std::size_t index_of(PixelClass which) {
    return static_cast<std::size_t>(which);
}

SquaredErrors squared_errors(std::span<const float> image, std::span<const float> truth, const Mask& mask) {
    if (image.size() != truth.size())
        throw std::invalid_argument("a reference of another size than the image");
    SquaredErrors errors;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const double error = double{image[i]} - double{truth[i]};
        if ((!mask.empty() && mask[i] == 0) || std::isnan(error)) continue;
        errors.sum += error * error;
        ++errors.count;
    }
    return errors;
}

void add(Score::Table& to, const Score::Table& from) {
    for (std::size_t r = 0; r < references; ++r)
        for (std::size_t c = 0; c < pixel_classes; ++c) to[r][c] += from[r][c];
}

}  // namespace

std::string_view name_of(Against reference) {
    constexpr std::array<std::string_view, references> names{"limit", "depth", "geometry"};
    return names.at(index_of(reference));
}

std::string_view name_of(PixelClass which) {
    constexpr std::array<std::string_view, pixel_classes> names{"all", "settled", "young", "disoccluded",
                                                                "near_moving"};
    return names.at(index_of(which));
}

Mask mask_of(const PixelClasses& classes, PixelClass which) {
    switch (which) {
        case PixelClass::all:
            return {};
        case PixelClass::settled:
            return classes.settled();
        case PixelClass::disoccluded:
            return classes.disoccluded();
        case PixelClass::near_moving:
            return classes.near_moving();
        case PixelClass::young:
            break;
    }
    Mask rest(classes.settled().size(), 0);
    for (std::size_t i = 0; i < rest.size(); ++i)
        rest[i] = (classes.settled()[i] | classes.disoccluded()[i] | classes.near_moving()[i]) == 0 ? 1 : 0;
    return rest;
}

SquaredErrors& SquaredErrors::operator+=(const SquaredErrors& other) {
    sum += other.sum;
    count += other.count;
    return *this;
}

double SquaredErrors::rmse() const {
    return count == 0 ? std::numeric_limits<double>::quiet_NaN()
                      : std::sqrt(sum / static_cast<double>(count));
}

Score& Score::operator+=(const Score& other) {
    add(raw, other.raw);
    add(filtered, other.filtered);
    return *this;
}

double Score::rmse_raw(Against reference, PixelClass which) const {
    return raw.at(index_of(reference)).at(index_of(which)).rmse();
}

double Score::rmse_filtered(Against reference, PixelClass which) const {
    return filtered.at(index_of(reference)).at(index_of(which)).rmse();
}

Score score_of(const Frame& frame, const References& references, const PixelClasses& classes) {
    Score score;
    for (const PixelClass which : all_classes) {
        const Mask mask = mask_of(classes, which);
        for (std::size_t r = 0; r < references.size(); ++r) {
            if (references[r].empty()) continue;
            score.raw[r][index_of(which)] = squared_errors(frame.occlusion, references[r], mask);
            score.filtered[r][index_of(which)] = squared_errors(frame.filtered, references[r], mask);
        }
    }
    return score;
}

}  // namespace gloam::effect
