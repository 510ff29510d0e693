// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "audit/internal/search.hpp"

namespace gloam::audit::internal {
namespace {

using namespace subject;

using Words = std::vector<Word>;
using module::Scalar;

// A number of the input, and where it may be special: the middle and the quarters of its range first.
struct Axis {
    const Slot* slot;
    std::size_t word;  // in the input
    std::vector<Word> places;
};

constexpr std::size_t most_axes = 16;
constexpr std::size_t most_zeros = 24;
constexpr std::size_t most_of_pairs = 10;  // places of each of two

// b, -b, and -b / a of a x + b.
std::vector<double> zeros_of(std::span<const float> numbers) {
    std::vector<double> zeros;
    for (const float b : numbers) zeros.insert(zeros.end(), {b, -b});
    for (const double b : numbers)
        for (const double a : numbers)
            if (std::isfinite(b / a)) zeros.insert(zeros.end(), {b / a, -b / a});
    zeros.resize(std::min(zeros.size(), most_zeros));
    return zeros;
}

Axis axis_of(const Slot& slot, std::size_t k, Scalar scalar, const std::vector<double>& zeros) {
    double low = numeric::infinity;
    double high = -numeric::infinity;
    for (const Values::Fixed& fixed : slot.values->fixed) {
        const double end = number_at(scalar, fixed.words[k]);
        if (!std::isfinite(end)) continue;
        low = std::min(low, end);
        high = std::max(high, end);
    }
    std::vector<double> all;
    for (const double share : {0.5, 0.25, 0.75}) all.push_back(low + (high - low) * share);
    all.insert(all.end(), zeros.begin(), zeros.end());
    all.insert(all.end(), {0.0, 0.5, 0.25, 0.75, 1.0});
    Axis axis{.slot = &slot, .word = slot.first + k, .places = {}};
    for (const double place : all) {
        const bool whole = !module::is_float(scalar);
        if (!std::isfinite(place) || (whole && std::abs(place) > 0x1p32)) continue;
        axis.places.push_back(whole ? static_cast<Word>(static_cast<std::int64_t>(std::floor(place)))
                                    : float_word(scalar, place));
    }
    return axis;
}

// All signs of (1, 1, 1), (1, 1, 0) and the like.
std::vector<std::vector<double>> diagonals(std::size_t components) {
    std::vector<std::vector<double>> all{{}};
    for (std::size_t k = 0; k < components; ++k) {
        std::vector<std::vector<double>> longer;
        for (const auto& part : all)
            for (const double next : {1.0, -1.0, 0.0}) (longer.emplace_back(part)).push_back(next);
        all = std::move(longer);
    }
    all.pop_back();  // zero
    for (std::vector<double>& vector : all) {
        double squared = 0.0;
        for (const double x : vector) squared += x * x;
        for (double& x : vector) x /= std::sqrt(squared);
    }
    return all;
}

}  // namespace

std::vector<Words> places_of(const judge::Question& question, std::span<const float> numbers,
                             const Domain::Inputs& drawn, std::size_t most) {
    const std::vector<Slot> slots = slots_of(question);
    const std::vector<double> zeros = zeros_of(numbers);
    std::vector<Axis> axes;
    std::vector<Words> all;
    const auto place = [&](const auto& put) {
        if (drawn.count() == 0 || all.size() >= most) return;
        const auto row = drawn.row(all.size() % drawn.count());
        Words words(row.begin(), row.end());
        put(words);
        if (std::ranges::all_of(slots, [&](const Slot& slot) {
                return slot.values->admits(std::span(words).subspan(slot.first, slot.count));
            }))
            all.push_back(std::move(words));
    };
    for (const Slot& slot : slots) {
        const module::Type& type = slot.parameter->type;
        const std::vector<Scalar> scalars = scalars_of(type);
        for (std::size_t k = 0; k < slot.count && axes.size() < most_axes; ++k)
            if (scalars[k] != Scalar::bool_) axes.push_back(axis_of(slot, k, scalars[k], zeros));
        if (type.scalar != Scalar::float_ || !type.sizes.empty() || type.columns != 1) continue;
        for (const std::vector<double>& vector : diagonals(slot.count))
            place([&](Words& words) {
                for (std::size_t k = 0; k < slot.count; ++k)
                    words[slot.first + k] = to_word(static_cast<float>(vector[k]));
            });
    }
    // All numbers, or all of one parameter, at like places.
    for (std::size_t i = 0; i < most_zeros; ++i)
        for (std::size_t s = 0; s <= slots.size(); ++s)
            place([&](Words& words) {
                for (const Axis& axis : axes)
                    if (i < axis.places.size() && (s == slots.size() || axis.slot == &slots[s]))
                        words[axis.word] = axis.places[i];
            });
    // Middles and quarters of three.
    for (std::size_t a = 0; a + 2 < axes.size(); ++a) {
        const std::array three{&axes[a], &axes[a + 1], &axes[a + 2]};
        if (std::ranges::any_of(three, [](const Axis* axis) { return axis->places.size() < 3; })) continue;
        for (std::size_t n = 0; n < 27; ++n)
            place([&](Words& words) {
                const std::array<std::size_t, 3> places{n / 9, n / 3 % 3, n % 3};
                for (std::size_t i = 0; i < 3; ++i) words[three[i]->word] = three[i]->places[places[i]];
            });
    }
    for (const Axis& a : axes)
        for (const Word at : a.places) place([&](Words& words) { words[a.word] = at; });
    for (const Axis& a : axes)
        for (const Axis& b : axes)
            for (std::size_t i = 0; a.word < b.word && i < most_of_pairs * most_of_pairs; ++i)
                if (i / most_of_pairs < a.places.size() && i % most_of_pairs < b.places.size())
                    place([&](Words& words) {
                        words[a.word] = a.places[i / most_of_pairs];
                        words[b.word] = b.places[i % most_of_pairs];
                    });
    return all;
}

}  // namespace gloam::audit::internal
