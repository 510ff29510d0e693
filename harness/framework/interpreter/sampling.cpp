// SPDX-License-Identifier: MIT
#include "interpreter/sampling.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "interpreter/internal/cube.hpp"
#include "interpreter/internal/level.hpp"

namespace gloam::interpreter {
namespace {

using backend::SampledHeader;
using backend::SampledShape;
using internal::Choice;
using internal::is_finite;
using internal::Level;
using internal::mixed;
using internal::nothing;
using internal::relative_error;
using internal::widened;
using numeric::Bounds;

constexpr double half_error = 0x1p-10;  // of a filtered float of 16 bits
constexpr double smallest_half = 0x1p-24;
constexpr double logarithm_error = 0.125;    // of a level; SwiftShader takes the mantissa for its logarithm
constexpr double largest_gradient = 0x1p62;  // in texels: its square is a float

// Of a direction into a cube a point on each face that it may select: the coordinates on it, and the layer of
// the image. Other points stay.
std::vector<SamplePoint> places_of(const SampledView& image, const SamplePoint& point, Precision precision) {
    if (!backend::is_cube(image.header.shape)) return {point};
    const bool layered = image.header.shape == SampledShape::cube_layers;
    const double error = precision == Precision::permitted ? relative_error : 0.0;
    std::vector<SamplePoint> all;
    for (const std::uint32_t cube : internal::layers_at(layered ? point.at[3] : Bounds::point(0.0),
                                                        image.header.depth / backend::cube_faces))
        for (const internal::FacePoint& on : internal::faces_of(point.at, error)) {
            SamplePoint place = point;
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const Bounds& at = on.quotients.at(axis);
                place.at.at(axis) = widened({at.low / 2.0 + 0.5, at.high / 2.0 + 0.5, at.nan}, error, 0.0);
            }
            place.at[2] = Bounds::point(cube * backend::cube_faces + on.face);
            all.push_back(place);
        }
    return all;
}

// Levels and the weight of the next smaller one.
std::vector<Choice> levels_of(const SampledView& image, const Bounds& level, Precision precision) {
    const double last = image.header.levels - 1.0;
    const double step = precision == Precision::permitted
                            ? std::ldexp(1.0, -static_cast<int>(image.precision.level_bits))
                            : 0.0;
    Bounds at{0.0, last, false};
    if (!level.nan && !level.empty())
        at = {std::clamp(level.low - step, 0.0, last), std::clamp(level.high + step, 0.0, last), false};
    const bool linear = image.header.linear != 0;
    const double first = linear ? std::floor(at.low) : std::ceil(at.low + 0.5) - 1.0;
    const double end = linear || precision == Precision::exact ? at.high : std::floor(at.high + 0.5);
    std::vector<Choice> all;
    for (double l = std::max(first, 0.0); all.empty() || l <= std::min(end, last); ++l) {
        const Bounds weight{std::clamp(at.low - l, 0.0, 1.0), std::clamp(at.high - l, 0.0, 1.0), false};
        all.push_back({static_cast<long>(l), linear && l < last ? weight : Bounds::point(0.0)});
    }
    return all;
}

std::array<Bounds, 4> mixed_levels(const std::array<Bounds, 4>& a, const std::array<Bounds, 4>& b,
                                   const Bounds& weight) {
    std::array<Bounds, 4> all{nothing, nothing, nothing, nothing};
    for (std::size_t k = 0; k < 4; ++k)
        for (const double w : {weight.low, weight.high})
            all.at(k) = numeric::hull(
                all.at(k), {mixed(a.at(k).low, b.at(k).low, w), mixed(a.at(k).high, b.at(k).high, w), false});
    return all;
}

void hull_into(std::array<Bounds, 4>& all, const std::array<Bounds, 4>& more) {
    for (std::size_t k = 0; k < 4; ++k) all.at(k) = numeric::hull(all.at(k), more.at(k));
}

std::array<Bounds, 4> sampled_place(const SampledView& image, const SamplePoint& point, Precision precision) {
    if (point.component >= 0)
        return internal::gathered_level(Level(image, 0, point, precision, true),
                                        static_cast<std::size_t>(point.component));
    const bool linear = image.header.linear != 0;
    std::array<Bounds, 4> all{nothing, nothing, nothing, nothing};
    for (const Choice& choice : levels_of(image, point.level, precision)) {
        const auto at = static_cast<std::uint32_t>(choice.texel);
        const auto level = [&](std::uint32_t l) {
            return internal::filtered_level(Level(image, l, point, precision, linear));
        };
        const std::array<Bounds, 4> first = level(at);
        hull_into(all, choice.weight.high > 0.0 ? mixed_levels(first, level(at + 1), choice.weight) : first);
    }
    return all;
}

Bounds level_of_slopes(const SampledView& image, std::span<const Bounds> dx, std::span<const Bounds> dy,
                       Precision precision) {
    const auto [width, height, depth] = backend::size_of_level(image.header, 0);
    const std::array<double, 3> size{static_cast<double>(width), static_cast<double>(height),
                                     static_cast<double>(depth)};
    // A length is at least the largest component, and at most the sum of all.
    const auto length = [&](std::span<const Bounds> d) -> Bounds {
        Bounds length = Bounds::point(0.0);
        double squared = 0.0;
        for (std::size_t k = 0; k < d.size(); ++k) {
            const double most = std::max(std::abs(d[k].low), std::abs(d[k].high)) * size.at(k);
            const bool zero = d[k].low <= 0.0 && d[k].high >= 0.0;
            const double least = zero ? 0.0 : std::min(std::abs(d[k].low), std::abs(d[k].high)) * size.at(k);
            length.low = std::max(length.low, least);
            length.high += most;
            length.nan = length.nan || d[k].nan || d[k].empty();
            squared += most * most;
        }
        return precision == Precision::exact ? Bounds{std::sqrt(squared), std::sqrt(squared), length.nan}
                                             : length;
    };
    const Bounds x = length(dx);
    const Bounds y = length(dy);
    constexpr double freedom = 1.4142135623730951;  // of a driver's approximation
    const double most = std::max(x.high, y.high) * (precision == Precision::exact ? 1.0 : freedom);
    const bool overflows = precision == Precision::permitted && most >= largest_gradient;
    const double error = precision == Precision::permitted ? logarithm_error : 0.0;
    return {std::log2(std::max(x.low, y.low)) - error, std::log2(most) + error, x.nan || y.nan || overflows};
}

// Whether the equation for the slopes on a face holds: it divides products by a square, which are to be
// normal floats. Neighbours far apart are no slope: a driver may subtract their places on their faces
// instead.
bool has_slope(const internal::FacePoint& on, const Gradients& gradients) {
    constexpr double smallest = 0x1p-62;
    if (on.major.low < smallest || on.major.high > 1.0 / smallest) return false;
    const auto fits = [&](const Bounds& change) {
        const double most = std::max(std::abs(change.low), std::abs(change.high));
        return on.major.high * most < 0x1p124 && !(gradients.of_neighbours && most > on.major.low / 4.0);
    };
    return std::ranges::all_of(gradients.dx, fits) && std::ranges::all_of(gradients.dy, fits);
}

}  // namespace

std::size_t SampledView::word_of(std::uint32_t level, const std::array<std::uint32_t, 3>& texel) const {
    const auto [width, height, depth] = backend::size_of_level(header, level);
    const std::size_t index = (std::size_t{texel[2]} * height + texel[1]) * width + texel[0];
    return (backend::texels_before(header, level) + index) * backend::texel_words;
}

SampledView sampled_view_of(std::span<const backend::Word> words,
                            const backend::SamplerPrecision& precision) {
    SampledView view{.header = backend::sampled_header(words),
                     .texels = words.subspan(backend::sampled_header_words),
                     .precision = precision};
    if (view.header.texel == backend::SampledTexel::depth) view.largest = 1.0;
    if (view.header.texel == backend::SampledTexel::real)
        for (const backend::Word word : view.texels)
            view.largest = std::max(view.largest, std::abs(static_cast<double>(std::bit_cast<float>(word))));
    return view;
}

bool has_place(const SampledView& image, const SamplePoint& point) {
    constexpr double most = 0x1p31;
    const auto near_zero = [](const Bounds& x, double scale) {
        return is_finite(x) && std::max(std::abs(x.low), std::abs(x.high)) * scale < most;
    };
    if (point.level.nan || point.level.high >= most) return false;
    const auto size = backend::size_of_level(image.header, 0);
    if (backend::is_cube(image.header.shape)) {
        constexpr double largest = 0x1p126;  // its reciprocal is a normal number
        double most = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Bounds& x = point.at.at(axis);
            if (!is_finite(x) || std::max(std::abs(x.low), std::abs(x.high)) > largest) return false;
            most = std::max(most, x.low > 0.0 ? x.low : -x.high);
        }
        return most >= internal::smallest_normal &&
               (image.header.shape == SampledShape::cube || near_zero(point.at[3], 1.0));
    }
    for (std::size_t axis = 0; axis < internal::axes_of(image.header); ++axis)
        if (!near_zero(point.at.at(axis), size.at(axis))) return false;
    return image.header.shape != SampledShape::layers || near_zero(point.at[2], 1.0);
}

std::array<Bounds, 4> sampled(const SampledView& image, const SamplePoint& point, Precision precision) {
    if (precision == Precision::permitted && !has_place(image, point)) {
        const Bounds any = Bounds::anything();
        return {any, any, any, any};
    }
    std::array<Bounds, 4> all{nothing, nothing, nothing, nothing};
    for (const SamplePoint& place : places_of(image, point, precision))
        hull_into(all, sampled_place(image, place, precision));
    if (image.header.linear == 0 || point.component >= 0 || precision == Precision::exact) return all;
    for (Bounds& bounds : all) {
        const bool mixes = image.header.texel == backend::SampledTexel::depth && bounds.low < bounds.high;
        // The rules promise no more than a share of the comparisons that hold.
        if (mixes && !image.precision.filters_depth) bounds = {0.0, 1.0, false};
        bounds = widened(bounds, smallest_half + half_error * image.largest, 0.0);
    }
    return all;
}

std::vector<std::array<std::size_t, 4>> sampled_texels(const SampledView& image, const SamplePoint& point,
                                                       Precision precision) {
    std::vector<std::array<std::size_t, 4>> all;
    const bool gathers = point.component >= 0;
    bool corner = false;
    const auto add = [&](std::uint32_t at, const SamplePoint& place) {
        const Level level(image, at, place, precision, gathers);
        level.for_each([&](const Choice& x, const Choice& y, const Choice& z) {
            std::array<std::size_t, 4> words{};
            for (std::size_t k = 0; k < 4; ++k) {
                const auto word = level.word(x.texel + (gathers ? internal::gathered.at(k)[0] : 0),
                                             y.texel + (gathers ? internal::gathered.at(k)[1] : 0), z.texel);
                corner = corner || !word;
                words.at(k) = word.value_or(outside);
            }
            if (std::ranges::find(all, words) == all.end()) all.push_back(words);
        });
    };
    for (const SamplePoint& place : places_of(image, point, precision))
        for (const Choice& choice : levels_of(image, gathers ? Bounds::point(0.0) : place.level, precision))
            add(gathers ? 0 : static_cast<std::uint32_t>(choice.texel), place);
    if (corner && precision == Precision::permitted) all.clear();
    return all;
}

Bounds level_of(const SampledView& image, const SamplePoint& point, const Gradients& gradients,
                Precision precision) {
    const bool permitted = precision == Precision::permitted;
    if (!backend::is_cube(image.header.shape)) {
        const std::size_t axes = internal::axes_of(image.header);
        return level_of_slopes(image, std::span(gradients.dx).first(axes),
                               std::span(gradients.dy).first(axes), precision);
    }
    Bounds all = nothing;
    for (const internal::FacePoint& on : internal::faces_of(point.at, permitted ? relative_error : 0.0)) {
        all = numeric::hull(
            all, level_of_slopes(image, slope_on(on, gradients.dx), slope_on(on, gradients.dy), precision));
        all.nan = all.nan || (permitted && !has_slope(on, gradients));
    }
    return all;
}

}  // namespace gloam::interpreter
