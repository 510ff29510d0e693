// SPDX-License-Identifier: MIT
#include "interpreter/sampling.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace gloam::interpreter {
namespace {

using backend::SampledHeader;
using backend::SampledShape;
using backend::Wrap;
using numeric::Bounds;

constexpr double relative_error = 0x1p-22;  // of a coordinate in texels
constexpr double half_error = 0x1p-10;      // of a filtered float of 16 bits
constexpr double smallest_half = 0x1p-24;
constexpr double logarithm_error = 0.125;    // of a level; SwiftShader takes the mantissa for its logarithm
constexpr double largest_gradient = 0x1p62;  // in texels: its square is a float

// A texel of one axis, and the weight of the texel behind it.
struct Choice {
    long texel;
    Bounds weight;
};

Bounds widened(const Bounds& x, double absolute, double relative) {
    return {x.low - absolute - std::abs(x.low) * relative, x.high + absolute + std::abs(x.high) * relative,
            x.nan};
}

bool is_finite(const Bounds& x) {
    return !x.nan && !x.empty() && std::isfinite(x.low) && std::isfinite(x.high);
}

// The texels of an axis from the coordinate in texels. `linear`: with the one behind each. Coordinates that
// may be anywhere may reach every texel.
std::vector<Choice> choices(const Bounds& texels, std::uint32_t size, bool linear) {
    const double shift = linear ? 0.5 : 0.0;
    const bool known = is_finite(texels) && texels.high - texels.low < size &&
                       std::abs(texels.low) < 0x1p31 && std::abs(texels.high) < 0x1p31;
    std::vector<Choice> all;
    const auto last = known ? static_cast<long>(std::floor(texels.high - shift)) : static_cast<long>(size);
    for (long i = known ? static_cast<long>(std::floor(texels.low - shift)) : -2; i <= last; ++i) {
        const auto at = static_cast<double>(i);
        Bounds weight = Bounds::point(0.0);
        if (linear && known)
            weight = {std::clamp(texels.low - shift - at, 0.0, 1.0),
                      std::clamp(texels.high - shift - at, 0.0, 1.0), false};
        else if (linear)
            weight = {0.0, 1.0, false};
        all.push_back({i, weight});
    }
    return all;
}

// The texel that a position beyond an edge means; -1: the border.
long wrapped(long i, long size, Wrap wrap) {
    const auto modulo = [](long a, long b) { return (a % b + b) % b; };
    switch (wrap) {
        case Wrap::repeat:
            return modulo(i, size);
        case Wrap::mirrored: {
            const long k = modulo(i, 2 * size);
            return k < size ? k : 2 * size - 1 - k;
        }
        case Wrap::edge:
            return std::clamp(i, 0L, size - 1);
        default:
            return i < 0 || i >= size ? -1 : i;
    }
}

// Axes that are filtered; the last coordinate of layers is not.
std::size_t axes_of(const SampledHeader& header) {
    return header.shape == SampledShape::three ? 3 : 2;
}

// One level of an image, and what may be read of it.
class Level {
  public:
    Level(const SampledView& image, std::uint32_t level, const SamplePoint& point, Precision precision,
          bool footprint)
        : image_(image),
          first_(backend::texels_before(image.header, level)),
          size_(backend::size_of_level(image.header, level)) {
        const double step =
            precision == Precision::permitted ? std::ldexp(1.0, -static_cast<int>(image.subtexel_bits)) : 0.0;
        const double relative = precision == Precision::permitted ? relative_error : 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (axis >= axes_of(image.header)) {
                axes_.at(axis) = layers(axis, point);
                continue;
            }
            const double size = size_.at(axis);
            const Bounds& at = point.at.at(axis);
            const Bounds texels{at.low * size + point.offset.at(axis), at.high * size + point.offset.at(axis),
                                at.nan};
            axes_.at(axis) = choices(widened(texels, step, relative), size_.at(axis), footprint);
        }
    }

    // Calls visit(x, y, z) for every combination of choices.
    template <class Visit>
    void for_each(Visit visit) const {
        for (const Choice& z : axes_[2])
            for (const Choice& y : axes_[1])
                for (const Choice& x : axes_[0]) visit(x, y, z);
    }

    // The first word of a texel; `outside` for the border.
    [[nodiscard]] std::size_t word(long x, long y, long z) const {
        const std::array<long, 3> at{x, y, z};
        std::size_t texel = 0;
        for (std::size_t axis = 3; axis-- > 0;) {
            const Wrap wrap = axis < axes_of(image_.header) ? image_.header.wrap : Wrap::edge;
            const long inside = wrapped(at.at(axis), static_cast<long>(size_.at(axis)), wrap);
            if (inside < 0) return outside;
            texel = texel * size_.at(axis) + static_cast<std::size_t>(inside);
        }
        return (first_ + texel) * backend::texel_words;
    }

    [[nodiscard]] double value(long x, long y, long z, std::size_t component) const {
        const std::size_t first = word(x, y, z);
        return first == outside ? 0.0
                                : static_cast<double>(std::bit_cast<float>(image_.texels[first + component]));
    }

  private:
    // The nearest layer, a half to either side.
    [[nodiscard]] std::vector<Choice> layers(std::size_t axis, const SamplePoint& point) const {
        if (image_.header.shape != SampledShape::layers) return {{0, Bounds::point(0.0)}};
        const Bounds& at = point.at.at(axis);
        const double last = size_.at(axis) - 1.0;
        const bool known = is_finite(at);
        const double first = known ? std::clamp(std::nearbyint(at.low), 0.0, last) : 0.0;
        const double end = known ? std::clamp(std::nearbyint(at.high), 0.0, last) : last;
        std::vector<Choice> all;
        for (double layer = first; layer <= end; ++layer)
            all.push_back({static_cast<long>(layer), Bounds::point(0.0)});
        return all;
    }

    const SampledView& image_;
    std::size_t first_;  // texel of the level
    std::array<std::uint32_t, 3> size_;
    std::array<std::vector<Choice>, 3> axes_;
};

double mixed(double a, double b, double weight) {
    return weight == 0.0 ? a : weight == 1.0 ? b : a + (b - a) * weight;
}

// The filtered value with these weights.
double filtered(const Level& level, const std::array<long, 3>& at, const std::array<double, 3>& weight,
                std::size_t component) {
    const auto row = [&](long y, long z) {
        const double first = level.value(at[0], y, z, component);
        return weight[0] == 0.0 ? first : mixed(first, level.value(at[0] + 1, y, z, component), weight[0]);
    };
    const auto plane = [&](long z) {
        const double first = row(at[1], z);
        return weight[1] == 0.0 ? first : mixed(first, row(at[1] + 1, z), weight[1]);
    };
    const double first = plane(at[2]);
    return weight[2] == 0.0 ? first : mixed(first, plane(at[2] + 1), weight[2]);
}

Bounds hull_with(const Bounds& bounds, double value) {
    return numeric::hull(bounds, Bounds::point(value));
}

constexpr Bounds nothing{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                         false};

// Whether the corner has the other end of this weight, which is the same.
bool ends_meet(const Choice& choice, unsigned corner, unsigned bit) {
    return (corner >> bit & 1U) != 0U && choice.weight.low == choice.weight.high;
}

// The value is linear in each weight, so that its extremes are at their ends.
std::array<Bounds, 4> filtered_level(const Level& level) {
    std::array<Bounds, 4> all{nothing, nothing, nothing, nothing};
    level.for_each([&](const Choice& x, const Choice& y, const Choice& z) {
        for (unsigned corner = 0; corner < 8; ++corner) {
            const bool repeated =
                ends_meet(x, corner, 0) || ends_meet(y, corner, 1) || ends_meet(z, corner, 2);
            if (repeated) continue;
            const auto end = [corner](const Choice& c, unsigned bit) {
                return (corner >> bit & 1U) == 0U ? c.weight.low : c.weight.high;
            };
            for (std::size_t component = 0; component < 4; ++component)
                all.at(component) =
                    hull_with(all.at(component), filtered(level, {x.texel, y.texel, z.texel},
                                                          {end(x, 0), end(y, 1), end(z, 2)}, component));
        }
    });
    return all;
}

// In the order of textureGather: (0, 1), (1, 1), (1, 0), (0, 0).
constexpr std::array<std::array<long, 2>, 4> gathered{{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};

std::array<Bounds, 4> gathered_level(const Level& level, std::size_t component) {
    std::array<Bounds, 4> all{nothing, nothing, nothing, nothing};
    level.for_each([&](const Choice& x, const Choice& y, const Choice& z) {
        for (std::size_t k = 0; k < 4; ++k)
            all.at(k) = hull_with(all.at(k), level.value(x.texel + gathered.at(k)[0],
                                                         y.texel + gathered.at(k)[1], z.texel, component));
    });
    return all;
}

// Levels and the weight of the next smaller one.
std::vector<Choice> levels_of(const SampledView& image, const Bounds& level, Precision precision) {
    const double last = image.header.levels - 1.0;
    const double step =
        precision == Precision::permitted ? std::ldexp(1.0, -static_cast<int>(image.level_bits)) : 0.0;
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

}  // namespace

std::size_t SampledView::word_of(std::uint32_t level, const std::array<std::uint32_t, 3>& texel) const {
    const auto [width, height, depth] = backend::size_of_level(header, level);
    const std::size_t index = (std::size_t{texel[2]} * height + texel[1]) * width + texel[0];
    return (backend::texels_before(header, level) + index) * backend::texel_words;
}

SampledView sampled_view_of(std::span<const backend::Word> words, std::uint32_t subtexel_bits,
                            std::uint32_t level_bits) {
    SampledView view{.header = backend::sampled_header(words),
                     .texels = words.subspan(backend::sampled_header_words),
                     .subtexel_bits = subtexel_bits,
                     .level_bits = level_bits};
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
    for (std::size_t axis = 0; axis < axes_of(image.header); ++axis)
        if (!near_zero(point.at.at(axis), size.at(axis))) return false;
    return image.header.shape != SampledShape::layers || near_zero(point.at[2], 1.0);
}

std::array<Bounds, 4> sampled(const SampledView& image, const SamplePoint& point, Precision precision) {
    if (precision == Precision::permitted && !has_place(image, point)) {
        const Bounds any = Bounds::anything();
        return {any, any, any, any};
    }
    if (point.component >= 0)
        return gathered_level(Level(image, 0, point, precision, true),
                              static_cast<std::size_t>(point.component));
    const bool linear = image.header.linear != 0;
    std::array<Bounds, 4> all{nothing, nothing, nothing, nothing};
    for (const Choice& choice : levels_of(image, point.level, precision)) {
        const auto at = static_cast<std::uint32_t>(choice.texel);
        const auto level = [&](std::uint32_t l) {
            return filtered_level(Level(image, l, point, precision, linear));
        };
        const std::array<Bounds, 4> first = level(at);
        hull_into(all, choice.weight.high > 0.0 ? mixed_levels(first, level(at + 1), choice.weight) : first);
    }
    if (linear && precision == Precision::permitted)
        for (Bounds& bounds : all) bounds = widened(bounds, smallest_half + half_error * image.largest, 0.0);
    return all;
}

std::vector<std::array<std::size_t, 4>> sampled_texels(const SampledView& image, const SamplePoint& point,
                                                       Precision precision) {
    std::vector<std::array<std::size_t, 4>> all;
    const bool gathers = point.component >= 0;
    const auto add = [&](std::uint32_t at) {
        const Level level(image, at, point, precision, gathers);
        level.for_each([&](const Choice& x, const Choice& y, const Choice& z) {
            std::array<std::size_t, 4> words{};
            for (std::size_t k = 0; k < 4; ++k)
                words.at(k) = level.word(x.texel + (gathers ? gathered.at(k)[0] : 0),
                                         y.texel + (gathers ? gathered.at(k)[1] : 0), z.texel);
            if (std::ranges::find(all, words) == all.end()) all.push_back(words);
        });
    };
    if (gathers) {
        add(0);
    } else {
        for (const Choice& choice : levels_of(image, point.level, precision))
            add(static_cast<std::uint32_t>(choice.texel));
    }
    return all;
}

Bounds level_of(const SampledView& image, std::span<const Bounds> dx, std::span<const Bounds> dy,
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

}  // namespace gloam::interpreter
