// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "subject/domain.hpp"

namespace gloam::subject {
namespace {

using Words = std::vector<Word>;

constexpr std::size_t quad = 4;

// Whether to go one step along x, y, in the invocation.
constexpr bool is_right(std::size_t invocation) {
    return (invocation & 1U) != 0;
}
constexpr bool is_below(std::size_t invocation) {
    return (invocation & 2U) != 0;
}

// A quarter has no step: one of the two derivatives is zero then.
double small_step(numeric::Random& random) {
    constexpr double smallest = 1e-5;
    constexpr double largest = 0.25;
    if (random.below(4) == 0) return 0.0;
    const double size = std::exp(random.uniform(std::log(smallest), std::log(largest)));
    return random.below(2) == 0 ? size : -size;
}

// The value moved by a share of its size, of 1 at least.
double moved(double value, double x, double y) {
    return value + (x + y) * std::max(std::abs(value), 1.0);
}

void append_stepped(const Values& one, const std::vector<module::Scalar>& scalars, DrawContext& context,
                    Words& words) {
    Words first;
    one.draw(context, first);
    Words all;
    for (std::size_t k = 0; k < quad; ++k) all.insert(all.end(), first.begin(), first.end());
    for (std::size_t s = 0; s < scalars.size(); ++s) {
        if (!module::is_float(scalars[s])) continue;
        const double dx = small_step(context.random);
        const double dy = small_step(context.random);
        for (std::size_t k = 1; k < quad; ++k)
            all[k * first.size() + s] = float_word(
                scalars[s],
                moved(from_word<double>(first[s]), is_right(k) ? dx : 0.0, is_below(k) ? dy : 0.0));
    }
    // Steps that lead out of the values are not made.
    for (std::size_t k = 0; k < quad; ++k) {
        const auto value = std::span(all).subspan(k * first.size(), first.size());
        if (one.contains && !one.contains(value)) std::ranges::copy(first, value.begin());
    }
    words.insert(words.end(), all.begin(), all.end());
}

void append_pixels(DrawContext& context, Words& words) {
    constexpr std::uint64_t side = 2048;
    const auto x = static_cast<float>(2 * context.random.below(side));
    const auto y = static_cast<float>(2 * context.random.below(side));
    for (std::size_t k = 0; k < quad; ++k)
        append_words(glm::vec4(x + (is_right(k) ? 1.5F : 0.5F), y + (is_below(k) ? 1.5F : 0.5F),
                               static_cast<float>(context.random.uniform(0.0, 1.0)), 1.0F),
                     words);
}

}  // namespace

Values neighbours(const module::Type& type, const Values& one, bool pixels) {
    if (pixels) return {.draw = append_pixels};
    Values all;
    all.draw = [one, scalars = scalars_of(type)](DrawContext& context, Words& words) {
        const std::uint64_t lot = context.random.below(4);
        if (lot < 2) return append_stepped(one, scalars, context, words);
        const std::size_t first = words.size();
        one.draw(context, words);
        const std::size_t width = words.size() - first;
        for (std::size_t k = 1; k < quad; ++k) {
            if (lot == 2) one.draw(context, words);
            for (std::size_t w = 0; lot != 2 && w < width; ++w) words.push_back(words[first + w]);
        }
    };
    if (one.contains)
        all.contains = [contains = one.contains](std::span<const Word> words) {
            const std::size_t width = words.size() / quad;
            for (std::size_t k = 0; k < quad; ++k)
                if (!contains(words.subspan(k * width, width))) return false;
            return true;
        };
    for (const Values::Fixed& fixed : one.fixed) {
        Values::Fixed& equal = all.fixed.emplace_back(Values::Fixed{.words = {}, .branch = fixed.branch});
        for (std::size_t k = 0; k < quad; ++k)
            equal.words.insert(equal.words.end(), fixed.words.begin(), fixed.words.end());
    }
    return all;
}

}  // namespace gloam::subject
