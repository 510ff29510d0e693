// SPDX-License-Identifier: MIT
#pragma once

#include "interpreter/internal/state.hpp"
#include "interpreter/sampling.hpp"
#include "numeric/paths.hpp"

// Reads through samplers.
namespace gloam::interpreter::internal {

[[nodiscard]] inline numeric::Bounds point_bounds(double x) {
    return x != x ? numeric::Bounds::only_nan() : numeric::Bounds::point(x);
}

// What a sampler takes of a number and gives, on float, double and bounds.
template <class N>
[[nodiscard]] numeric::Bounds sampled_bounds(const N& x) {
    if constexpr (has_bounds<N>) {
        return permitted_of(x).bounds();
    } else {
        return point_bounds(static_cast<double>(x));
    }
}
template <class N>
[[nodiscard]] N sampled_number(const numeric::Bounds& x) {
    if constexpr (has_bounds<N>) {
        return N(numeric::Interval::within(x));
    } else {
        return static_cast<N>(x.low);
    }
}

template <class N>
[[nodiscard]] const SampledView& sampled_view(const State<N>& s, Slot image) {
    const Word resource = s.bits(image);
    const Backing<N>& backing = s.backings.at(resource);
    if (!backing.sampled)
        throw Fault{Error::Kind::missing,
                    fmt::format("no sampler is bound to \"{}\"", s.code.resources[resource].name)};
    return *backing.sampled;
}

// Where the instruction samples. bounds(x): those of a number.
template <class N, class BoundsOf>
[[nodiscard]] SamplePoint sample_point(const State<N>& s, const Instruction& i, const SampledView& view,
                                       Precision precision, BoundsOf bounds) {
    const Sampling& how = s.code.samplings[i.extra];
    SamplePoint point{.component = how.gathers ? 0 : -1};
    if (how.component) point.component = static_cast<int>(s.bits(*how.component));
    const std::uint32_t coordinates = how.projected ? i.c - 1 : i.c;
    const auto projected = [&](Slot slot) {
        const N x = s.slots[slot].number();
        return bounds(how.projected ? apply(Divide{}, x, s.slots[i.b + coordinates].number()) : x);
    };
    for (std::uint32_t k = 0; k < coordinates; ++k) point.at.at(k) = projected(i.b + k);
    if (how.reference) point.reference = projected(*how.reference);
    for (std::uint32_t k = 0; how.offset && k < std::min(how.offsets, 3U); ++k)
        point.offset.at(k) = as_int(s.bits(*how.offset + k));
    if (how.level) point.level = bounds(s.slots[*how.level].number());
    if (how.dx) {
        Gradients gradients{.of_neighbours = how.implicit};
        for (std::uint32_t k = 0; k < how.gradients; ++k) {
            gradients.dx.at(k) = bounds(s.slots[*how.dx + k].number());
            gradients.dy.at(k) = bounds(s.slots[how.dy + k].number());
        }
        point.level = level_of(view, point, gradients, precision);
    }
    if (how.bias) {
        const numeric::Bounds bias = bounds(s.slots[*how.bias].number());
        point.level = {point.level.low + bias.low, point.level.high + bias.high, point.level.nan || bias.nan};
    }
    return point;
}

// One of the texels of an image of integers; on bounds each is explored.
template <class N>
void sample_integers(State<N>& s, const Instruction& i, const SampledView& view, const SamplePoint& point,
                     Precision precision) {
    constexpr std::size_t most = 64;
    if (precision == Precision::permitted && !has_place(view, point)) throw numeric::Paths::Undetermined{};
    const auto all = sampled_texels(view, point, precision);
    if (precision == Precision::permitted && (all.empty() || all.size() > most))
        throw numeric::Paths::Undetermined{};
    const auto& words = all.at(precision == Precision::permitted ? numeric::Paths::choose(all.size()) : 0);
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const std::size_t first = words.at(point.component >= 0 ? k : 0);
        const std::size_t component = point.component >= 0 ? static_cast<std::size_t>(point.component) : k;
        s.set(i, i.result + k, first == outside ? Word{0} : Word{view.texels[first + component]});
    }
}

template <class N>
void do_image_sample(State<N>& s, const Instruction& i) {
    constexpr std::uint64_t steps = 64;  // about as long as so many others
    s.cost = steps;
    const SampledView& view = sampled_view(s, i.a);
    const bool integers = view.header.texel == backend::SampledTexel::integer ||
                          view.header.texel == backend::SampledTexel::natural;
    if constexpr (std::is_same_v<N, Explained>) {
        const SamplePoint value = sample_point(s, i, view, Precision::exact,
                                               [](const Explained& x) { return point_bounds(x.value); });
        if (integers) return sample_integers(s, i, view, value, Precision::exact);
        const SamplePoint exact = sample_point(s, i, view, Precision::exact,
                                               [](const Explained& x) { return point_bounds(x.exact); });
        const SamplePoint any = sample_point(s, i, view, Precision::permitted,
                                             [](const Explained& x) { return x.permitted.bounds(); });
        const auto values = sampled(view, value, Precision::exact);
        const auto exacts = sampled(view, exact, Precision::exact);
        const auto permitted = sampled(view, any, Precision::permitted);
        for (std::uint32_t k = 0; k < i.count; ++k) {
            Explained result{.value = static_cast<float>(values.at(k).low), .exact = exacts.at(k).low};
            result.permitted = numeric::Interval::within(permitted.at(k));
            s.set(i, i.result + k, result);
        }
    } else {
        constexpr Precision precision = has_bounds<N> ? Precision::permitted : Precision::exact;
        const SamplePoint point = sample_point(s, i, view, precision, sampled_bounds<N>);
        if (integers) return sample_integers(s, i, view, point, precision);
        const auto results = sampled(view, point, precision);
        for (std::uint32_t k = 0; k < i.count; ++k) s.set(i, i.result + k, sampled_number<N>(results.at(k)));
    }
}

// The level of a fetch or of a size. Throws Fault if the image lacks it.
template <class N>
[[nodiscard]] std::uint32_t level_operand(const State<N>& s, const Instruction& i, const SampledView& view) {
    const Word level = i.extra == 0 ? 0 : s.bits(i.extra - 1);
    if (level >= view.header.levels)
        throw Fault{Error::Kind::out_of_bounds,
                    fmt::format("level {} of an image of {}", as_int(level), view.header.levels)};
    return level;
}

template <class N>
void fetch_sampled(State<N>& s, const Instruction& i, const SampledView& view) {
    const std::uint32_t level = level_operand(s, i, view);
    const auto size = backend::size_of_level(view.header, level);
    std::array<std::uint32_t, 3> at{};
    for (std::uint32_t k = 0; k < i.c; ++k) {
        at.at(k) = s.bits(i.b + k);
        if (at.at(k) >= size.at(k))
            throw Fault{Error::Kind::out_of_bounds,
                        fmt::format("texel {} of {} (dimension {})", as_int(at.at(k)), size.at(k), k)};
    }
    const std::size_t first = view.word_of(level, at);
    for (std::uint32_t k = 0; k < i.count; ++k)
        s.slots[i.result + k] = Value<N>::of_bits(view.texels[first + k]);
}

template <class N>
void size_of_sampled(State<N>& s, const Instruction& i, const SampledView& view) {
    auto size = backend::size_of_level(view.header, level_operand(s, i, view));
    if (backend::is_cube(view.header.shape)) size[2] /= backend::cube_faces;
    for (std::uint32_t k = 0; k < i.count; ++k) s.set(i, i.result + k, Word{size.at(k)});
}

template <class N>
void do_image_levels(State<N>& s, const Instruction& i) {
    s.set(i, i.result, Word{sampled_view(s, i.a).header.levels});
}

}  // namespace gloam::interpreter::internal
