// SPDX-License-Identifier: MIT
#include "interpreter/internal/level.hpp"

#include <algorithm>
#include <bit>

#include "interpreter/internal/cube.hpp"

namespace gloam::interpreter::internal {
namespace {

using backend::SampledShape;
using backend::SampledTexel;
using backend::Wrap;
using numeric::Bounds;

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

// Whether the reference may (high), or must (low), compare with a depth.
bool holds(backend::Compare compare, const Bounds& reference, double depth, End end) {
    using backend::Compare;
    const bool upwards = compare == Compare::less || compare == Compare::less_equal;
    // At this end of the reference the comparison holds if it does anywhere, or only if it does everywhere.
    const double at = upwards == (end == End::high) ? reference.low : reference.high;
    if (reference.nan || reference.empty()) return end == End::high;
    if (compare == Compare::less_equal) return at <= depth;
    if (compare == Compare::greater_equal) return at >= depth;
    return compare == Compare::less ? at < depth : at > depth;
}

Bounds hull_with(const Bounds& bounds, double value) {
    return numeric::hull(bounds, Bounds::point(value));
}

// The filtered value with these weights.
double filtered(const Level& level, const std::array<long, 3>& at, const std::array<double, 3>& weight,
                std::size_t component, End end) {
    const auto row = [&](long y, long z) {
        const double first = level.value(at[0], y, z, component, end);
        return weight[0] == 0.0 ? first
                                : mixed(first, level.value(at[0] + 1, y, z, component, end), weight[0]);
    };
    const auto plane = [&](long z) {
        const double first = row(at[1], z);
        return weight[1] == 0.0 ? first : mixed(first, row(at[1] + 1, z), weight[1]);
    };
    const double first = plane(at[2]);
    return weight[2] == 0.0 ? first : mixed(first, plane(at[2] + 1), weight[2]);
}

// Whether the corner has the other end of this weight, which is the same.
bool ends_meet(const Choice& choice, unsigned corner, unsigned bit) {
    return (corner >> bit & 1U) != 0U && choice.weight.low == choice.weight.high;
}

// Of texels with one value, once.
std::vector<End> ends_of(const Level& level) {
    return level.has_ends() ? std::vector{End::low, End::high} : std::vector{End::low};
}

}  // namespace

std::size_t axes_of(const backend::SampledHeader& header) {
    return header.shape == SampledShape::three ? 3 : 2;
}

std::vector<std::uint32_t> layers_at(const Bounds& at, std::uint32_t layers) {
    const double last = layers - 1.0;
    const bool known = is_finite(at);
    const double first = known ? std::clamp(std::nearbyint(at.low), 0.0, last) : 0.0;
    const double end = known ? std::clamp(std::nearbyint(at.high), 0.0, last) : last;
    std::vector<std::uint32_t> all;
    for (double layer = first; layer <= end; ++layer) all.push_back(static_cast<std::uint32_t>(layer));
    return all;
}

Level::Level(const SampledView& image, std::uint32_t level, const SamplePoint& point, Precision precision,
             bool footprint)
    : image_(image),
      reference_(point.reference),
      precision_(precision),
      footprint_(footprint),
      first_(backend::texels_before(image.header, level)),
      size_(backend::size_of_level(image.header, level)) {
    const bool permitted = precision == Precision::permitted;
    const auto bits = static_cast<int>(image.precision.subtexel_bits);
    const double step = permitted ? std::ldexp(1.0, -bits) : 0.0;
    const double relative = permitted ? relative_error : 0.0;
    // Flushed, if it is subnormal.
    if (permitted)
        reference_ = {reference_.low - smallest_normal, reference_.high + smallest_normal, reference_.nan};
    const bool layered = image.header.shape == SampledShape::layers || is_cube(image.header.shape);
    for (const std::uint32_t layer : layers_at(layered ? point.at[2] : Bounds::point(0.0), size_[2]))
        axes_[2].push_back({static_cast<long>(layer), Bounds::point(0.0)});
    for (std::size_t axis = 0; axis < axes_of(image.header); ++axis) {
        const double size = size_.at(axis);
        const Bounds& at = point.at.at(axis);
        const Bounds texels{at.low * size + point.offset.at(axis), at.high * size + point.offset.at(axis),
                            at.nan};
        axes_.at(axis) = choices(widened(texels, step, relative), size_.at(axis), footprint);
    }
}

std::optional<std::size_t> Level::word(long x, long y, long z) const {
    if (!footprint_ || !is_cube(image_.header.shape)) return word_inside({x, y, z});
    const auto face = static_cast<std::uint32_t>(z) % backend::cube_faces;
    const auto on = internal::folded({face, x, y}, static_cast<long>(size_[0]));
    if (!on) return std::nullopt;
    return word_inside({on->x, on->y, z - static_cast<long>(face) + static_cast<long>(on->face)});
}

double Level::value(long x, long y, long z, std::size_t component, End end) const {
    if (const auto at = word(x, y, z)) return value_of(*at, component, end);
    const auto last = static_cast<long>(size_[0]) - 1;
    const long inside_x = std::clamp(x, 0L, last);
    const long inside_y = std::clamp(y, 0L, last);
    const std::array<double, 3> around{value(inside_x, inside_y, z, component, end),
                                       value(x, inside_y, z, component, end),
                                       value(inside_x, y, z, component, end)};
    if (precision_ == Precision::exact) return (around[0] + around[1] + around[2]) / 3.0;
    return end == End::low ? std::ranges::min(around) : std::ranges::max(around);
}

std::size_t Level::word_inside(const std::array<long, 3>& at) const {
    std::size_t texel = 0;
    for (std::size_t axis = 3; axis-- > 0;) {
        const bool wraps = axis < axes_of(image_.header) && !is_cube(image_.header.shape);
        const Wrap wrap = wraps ? image_.header.wrap : Wrap::edge;
        const long inside = wrapped(at.at(axis), static_cast<long>(size_.at(axis)), wrap);
        if (inside < 0) return outside;
        texel = texel * size_.at(axis) + static_cast<std::size_t>(inside);
    }
    return (first_ + texel) * backend::texel_words;
}

double Level::value_of(std::size_t first, std::size_t component, End end) const {
    const bool compares = image_.header.texel == SampledTexel::depth;
    const double texel =
        first == outside
            ? 0.0
            : static_cast<double>(std::bit_cast<float>(image_.texels[first + (compares ? 0 : component)]));
    if (!compares) return texel;
    return holds(image_.header.compare, reference_, texel, end) ? 1.0 : 0.0;
}

// The value is linear in each weight, so that its extremes are at their ends.
std::array<Bounds, 4> filtered_level(const Level& level) {
    std::array<Bounds, 4> all{nothing, nothing, nothing, nothing};
    const std::vector<End> ends = ends_of(level);
    level.for_each([&](const Choice& x, const Choice& y, const Choice& z) {
        for (unsigned corner = 0; corner < 8; ++corner) {
            const bool repeated =
                ends_meet(x, corner, 0) || ends_meet(y, corner, 1) || ends_meet(z, corner, 2);
            if (repeated) continue;
            const auto end = [corner](const Choice& c, unsigned bit) {
                return (corner >> bit & 1U) == 0U ? c.weight.low : c.weight.high;
            };
            const std::array<double, 3> weight{end(x, 0), end(y, 1), end(z, 2)};
            for (std::size_t component = 0; component < 4; ++component)
                for (const End of_texel : ends)
                    all.at(component) =
                        hull_with(all.at(component),
                                  filtered(level, {x.texel, y.texel, z.texel}, weight, component, of_texel));
        }
    });
    return all;
}

std::array<Bounds, 4> gathered_level(const Level& level, std::size_t component) {
    std::array<Bounds, 4> all{nothing, nothing, nothing, nothing};
    level.for_each([&](const Choice& x, const Choice& y, const Choice& z) {
        for (std::size_t k = 0; k < 4; ++k)
            for (const End end : ends_of(level))
                all.at(k) =
                    hull_with(all.at(k), level.value(x.texel + gathered.at(k)[0], y.texel + gathered.at(k)[1],
                                                     z.texel, component, end));
    });
    return all;
}

}  // namespace gloam::interpreter::internal
