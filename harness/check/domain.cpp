// SPDX-License-Identifier: MIT
#include "check/domain.hpp"

#include <algorithm>
#include <stdexcept>

#include "numeric/ulp.hpp"

namespace gloam::check {
namespace {

// Probabilities, in sixteenths: of an input with fixed values only, and of an input with a single fixed
// value.
constexpr std::uint64_t all_fixed_chance = 2;
constexpr std::uint64_t one_fixed_chance = 4;
constexpr std::uint64_t tie_chance = 1;
constexpr std::uint64_t degenerate_chance = 2;
constexpr std::size_t nothing = SIZE_MAX;
constexpr std::uint64_t chances = 16;

}  // namespace

// A fixed value of a parameter, or a degenerate change, that an input must have.
struct Domain::Forced {
    std::size_t parameter = nothing;
    std::size_t value = 0;
    std::size_t change = nothing;
};

Domain Domain::tied(std::size_t target, std::size_t source, double factor) const {
    if (target >= parameters_.size() || source >= parameters_.size()) {
        throw std::invalid_argument("Domain::tied: no such parameter");
    }
    Domain more = *this;
    more.ties_.push_back({target, source, factor});
    return more;
}

Domain Domain::adjusted(std::function<void(std::span<Word>)> adjust) const {
    Domain more = *this;
    more.adjustments_.push_back(std::move(adjust));
    return more;
}

bool Domain::apply_tie(DrawContext& context, std::span<Word> row,
                       const std::vector<std::size_t>& offsets) const {
    if (ties_.empty() || context.random.below(chances) >= tie_chance) return false;
    const Tie& tie = ties_[context.random.below(ties_.size())];
    const auto source = static_cast<double>(from_word<float>(row[offsets[tie.source]]));
    const int steps = static_cast<int>(context.random.below(3)) - 1;
    row[offsets[tie.target]] = to_word(numeric::step(static_cast<float>(source * tie.factor), steps));
    return true;
}

Domain Domain::and_degenerate(const Signature& signature) const {
    Domain more = *this;
    more.degenerate_ = Degenerate(signature, parameters_);
    return more;
}

bool Domain::make_degenerate(DrawContext& context, std::span<Word> row, const Forced& forced) const {
    if (forced.change != nothing) {
        degenerate_.change(forced.change, row);
        return true;
    }
    if (forced.parameter != nothing || context.random.below(chances) >= degenerate_chance) return false;
    if (degenerate_.count() > 0 && context.random.below(4) == 0) {
        degenerate_.change(context.random.below(degenerate_.count()), row);
        return true;
    }
    const bool once = degenerate_.relate(context.random, row);
    return degenerate_.relate(context.random, row) || once;
}

void Domain::append_row(DrawContext& context, Inputs& inputs, const Forced& forced) const {
    const bool any_forced = forced.parameter != nothing || forced.change != nothing;
    const std::uint64_t lot = context.random.below(chances);
    const bool all_fixed = !any_forced && lot < all_fixed_chance;
    const bool one_fixed = !any_forced && !all_fixed && lot < all_fixed_chance + one_fixed_chance;
    const std::size_t chosen =
        one_fixed && !parameters_.empty() ? context.random.below(parameters_.size()) : 0;
    std::vector<Word>& words = inputs.words;
    const std::size_t first = words.size();
    std::vector<std::size_t> offsets;
    bool branch = false;
    for (std::size_t p = 0; p < parameters_.size(); ++p) {
        const Values& values = parameters_[p];
        offsets.push_back(words.size() - first);
        const bool fixed = p == forced.parameter || all_fixed || (one_fixed && p == chosen);
        if (fixed && !values.fixed.empty()) {
            const std::size_t pick =
                p == forced.parameter ? forced.value : context.random.below(values.fixed.size());
            const Values::Fixed& value = values.fixed[pick];
            words.insert(words.end(), value.words.begin(), value.words.end());
            branch = branch || value.branch;
        } else {
            values.draw(context, words);
        }
    }
    const std::span<Word> drawn = std::span(words).subspan(first);
    branch = apply_tie(context, drawn, offsets) || branch;
    branch = make_degenerate(context, drawn, forced) || branch;
    inputs.branch.push_back(branch);
    inputs.width = drawn.size();
}

Domain Domain::and_words(const std::vector<Word>& words) const {
    Domain more = *this;
    more.given_.push_back(words);
    return more;
}

void Domain::adjust(std::span<Word> row) const {
    for (const auto& adjustment : adjustments_) adjustment(row);
}

void Domain::append_drawn(Inputs& inputs, std::size_t count, std::uint64_t seed,
                          glm::ivec2 image_size) const {
    numeric::Random random(seed);
    DrawContext context{.random = random, .image_size = image_size};
    const std::vector<Forced> forced = all_forced();
    const std::size_t room = count - inputs.count();
    const std::size_t taken = forced.size() <= room / 2 ? forced.size() : (room + 1) / 2;
    const std::size_t start = taken == forced.size() ? 0 : random.below(forced.size());
    for (std::size_t i = 0; i < taken; ++i) {
        append_row(context, inputs, forced[(start + i * forced.size() / taken) % forced.size()]);
    }
    while (inputs.count() < count) append_row(context, inputs, {});
}

std::vector<Domain::Forced> Domain::all_forced() const {
    std::vector<Forced> all;
    for (std::size_t p = 0; p < parameters_.size(); ++p) {
        for (std::size_t value = 0; value < parameters_[p].fixed.size(); ++value) {
            all.push_back({.parameter = p, .value = value});
        }
    }
    for (std::size_t change = 0; change < degenerate_.count(); ++change) all.push_back({.change = change});
    return all;
}

bool Domain::holds(std::span<const Word> input, std::span<const Word> known) const {
    numeric::Random random(0);
    DrawContext context{.random = random};
    std::vector<Word> drawn;
    for (const Values& values : parameters_) {
        const std::size_t first = drawn.size();
        values.draw(context, drawn);  // to find its number of words
        const std::size_t words = drawn.size() - first;
        const std::span<const Word> value = input.subspan(first, words);
        if (!std::ranges::equal(value, known.subspan(first, words)) && !values.admits(value)) return false;
    }
    std::vector<Word> adjusted(input.begin(), input.end());
    adjust(adjusted);
    return std::ranges::equal(adjusted, input);
}

Domain::Inputs Domain::draw_unadjusted(std::size_t count, std::uint64_t seed, glm::ivec2 image_size) const {
    Inputs inputs;
    append_drawn(inputs, count, seed, image_size);
    return inputs;
}

Domain::Inputs Domain::draw(std::size_t count, std::uint64_t seed, glm::ivec2 image_size) const {
    Inputs inputs;
    for (const std::vector<Word>& words : given_) {
        if (inputs.count() == count) break;
        inputs.words.insert(inputs.words.end(), words.begin(), words.end());
        inputs.branch.push_back(false);
        inputs.width = words.size();
    }
    const std::size_t given = inputs.count();
    append_drawn(inputs, count, seed, image_size);
    for (std::size_t i = given; i < inputs.count(); ++i) {
        adjust(std::span(inputs.words).subspan(i * inputs.width, inputs.width));
    }
    return inputs;
}

}  // namespace gloam::check
