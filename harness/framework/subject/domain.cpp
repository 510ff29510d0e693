// SPDX-License-Identifier: MIT
#include "subject/domain.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "numeric/numbers.hpp"

namespace gloam::check {
namespace {

using shader::Scalar;

double length_of(std::span<const Word> vector) {
    double squared = 0.0;
    for (const Word word : vector) squared += from_word<double>(word) * from_word<double>(word);
    return std::sqrt(squared);
}

std::vector<Word> scaled(std::span<const Word> vector, double factor) {
    std::vector<Word> words;
    for (const Word word : vector)
        words.push_back(to_word(static_cast<float>(from_word<double>(word) * factor)));
    return words;
}

std::vector<Word> along_axis(numeric::Random& random, std::size_t size, double length) {
    std::vector<Word> words(size, to_word(0.0F));
    words[random.below(size)] = to_word(static_cast<float>(random.below(2) == 0 ? length : -length));
    return words;
}

double factor_of(numeric::Random& random) {
    const double sign = random.below(2) == 0 ? 1.0 : -1.0;
    return random.below(2) == 0 ? sign : sign * random.uniform(0.25, 4.0);
}

// Changes of a float, and of the side of an image.
using Changed = Word (*)(Word before);
constexpr Changed to_zero = [](Word) { return 0U; };
constexpr std::array<Changed, 4> of_floats{
    to_zero, [](Word word) { return word == 0U ? to_word(-1.0F) : word | 0x80000000U; },
    [](Word) { return to_word(std::numeric_limits<float>::infinity()); },
    [](Word) { return to_word(std::numeric_limits<float>::quiet_NaN()); }};
constexpr std::array<Changed, 2> of_sides{to_zero, [](Word) { return 1U; }};

}  // namespace

Degenerate::Degenerate(const Signature& signature, const std::vector<Values>& parameters, bool only_vectors)
    : parameters_(std::make_shared<const std::vector<Values>>(parameters)) {
    std::size_t first = 0;
    std::size_t next = 0;
    for (const shader::Parameter& parameter : signature.parameters) {
        if (parameter.direction == shader::Direction::out) continue;
        const Values& values = (*parameters_)[next++];
        if (values.only_drawn) {
            add_vectors(parameter.type, first, nullptr);
        } else {
            const bool composed = parameter.type.scalar == Scalar::structure || !parameter.type.sizes.empty();
            const std::vector<Scalar> scalars = scalars_of(parameter.type);
            for (std::size_t i = 0; composed && !only_vectors && i < scalars.size(); ++i)
                for (const auto change : of_floats)
                    if (scalars[i] == Scalar::float_) changes_.push_back({first + i, change});
            add_vectors(parameter.type, first, &values);
            for (std::size_t i = 0; !only_vectors && i < 2 * values.image_sizes.size(); ++i)
                for (const auto change : of_sides)
                    changes_.push_back({first + values.image_sizes[i / 2] + i % 2, change});
        }
        first += scalars_of(parameter.type).size();
    }
}

// Vectors in a struct or an array are only copied from. They are not changed, because their valid values are
// unknown.
void Degenerate::add_vectors(const shader::Type& type, std::size_t first, const Values* values) {
    if (!type.sizes.empty()) {
        const shader::Type element = shader::element_of(type);
        for (std::uint32_t i = 0; i < type.sizes.front(); ++i, first += scalars_of(element).size())
            add_vectors(element, first, nullptr);
    } else if (type.scalar == Scalar::structure) {
        for (const shader::Member& member : type.members) {
            add_vectors(member.type, first, nullptr);
            first += scalars_of(member.type).size();
        }
    } else if (type.scalar == Scalar::float_ && type.columns == 1 && type.rows > 1) {
        vectors_.push_back({first, static_cast<std::size_t>(type.rows), values});
    }
}

void Degenerate::add_numbers(const Signature& signature, const std::vector<Values>& parameters,
                             std::span<const float> numbers) {
    if (!parameters_) parameters_ = std::make_shared<const std::vector<Values>>(parameters);
    std::vector<Word> bits;
    for (const float number : numbers) {
        if (number == 0.0F) continue;  // which Values have; beside it are subnormal numbers
        for (const float sign : {1.0F, -1.0F})
            for (const int steps : {-1, 0, 1}) bits.push_back(to_word(numeric::step(sign * number, steps)));
    }
    Number change;
    std::size_t next = 0;
    for (const shader::Parameter& parameter : signature.parameters) {
        if (parameter.direction == shader::Direction::out) continue;
        const std::vector<Scalar> scalars = scalars_of(parameter.type);
        change.parameter = next++;
        change.size = scalars.size();
        const Values& values = parameters[change.parameter];
        for (std::size_t k = 0; k < scalars.size() && values.contains && !values.only_drawn; ++k) {
            change.word = change.first + k;
            change.anywhere = std::ranges::any_of(values.fixed, [k](const Values::Fixed& fixed) {
                return std::isinf(from_word<float>(fixed.words[k]));
            });
            for (const Word number : bits) {
                change.bits = number;
                if (scalars[k] == Scalar::float_) numbers_.push_back(change);
            }
        }
        change.first += scalars.size();
    }
}

void Degenerate::change(std::size_t i, std::span<Word> row) const {
    if (i >= changes_.size()) {
        const Number& number = numbers_[i - changes_.size()];
        const Word before = std::exchange(row[number.word], number.bits);
        if (!number.anywhere &&
            !parameters_->at(number.parameter).admits(row.subspan(number.first, number.size)))
            row[number.word] = before;
        return;
    }
    Word& word = row[changes_[i].word];
    word = changes_[i].changed(word);
}

bool Degenerate::relate(numeric::Random& random, std::span<Word> row) const {
    if (vectors_.empty()) return false;
    const Vector& target = vectors_[random.below(vectors_.size())];
    const Vector& source = vectors_[random.below(vectors_.size())];
    if (target.values == nullptr) return false;
    const std::span<Word> old = row.subspan(target.first, target.size);
    const double length = length_of(old);
    const bool related = source.size == target.size && source.first != target.first;
    std::vector<Word> words = related ? scaled(row.subspan(source.first, source.size), factor_of(random))
                                      : along_axis(random, target.size, length);
    const auto& contains = target.values->contains;
    if (!contains || !target.values->admits(words)) {
        const double factor = length / length_of(words);
        if (!std::isfinite(factor)) return false;
        words = scaled(words, factor);
        if (contains && !target.values->admits(words)) return false;
    }
    std::ranges::copy(words, old.begin());
    return true;
}

namespace {

// Probabilities, in sixteenths: of an input with fixed values only, and of an input with a single fixed
// value.
constexpr std::uint64_t all_fixed_chance = 2;
constexpr std::uint64_t one_fixed_chance = 4;
constexpr std::uint64_t tie_chance = 1;
constexpr std::uint64_t degenerate_chance = 2;
constexpr std::size_t number_part = 8;  // at most one in so many inputs has a number that was added
constexpr std::size_t nothing = SIZE_MAX;
constexpr std::uint64_t chances = 16;

}  // namespace

// A fixed value of a parameter, or a degenerate change, that an input must have.
struct Domain::Forced {
    std::size_t parameter = nothing;
    std::size_t value = 0;
    std::size_t change = nothing;
};

Domain::Domain(std::vector<Values> parameters) : parameters_(std::move(parameters)) {
    for (const Values& values : parameters_)
        if (std::ranges::any_of(values.fixed, [words = values.words()](const Values::Fixed& fixed) {
                return fixed.words.size() != words;
            }))
            throw std::invalid_argument("a fixed value is of another type than those drawn");
}

Domain Domain::tied(std::size_t target, std::size_t source, double factor) const {
    if (target >= parameters_.size() || source >= parameters_.size())
        throw std::invalid_argument("Domain::tied: no such parameter");
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

void Domain::require_fits(const Signature& signature) const {
    std::vector<std::size_t> has;
    std::ranges::transform(parameters_, std::back_inserter(has), &Values::words);
    std::vector<std::size_t> wants;
    for (const shader::Parameter& parameter : signature.parameters)
        if (parameter.direction != shader::Direction::out) wants.push_back(scalars_of(parameter.type).size());
    if (has != wants)
        throw std::invalid_argument(
            fmt::format("the domain has parameters of {} words, the function takes {}", fmt::join(has, ", "),
                        fmt::join(wants, ", ")));
}

Domain Domain::and_degenerate(const Signature& signature, bool only_vectors) const {
    require_fits(signature);
    Domain more = *this;
    more.degenerate_ = Degenerate(signature, parameters_, only_vectors);
    return more;
}

Domain Domain::and_numbers(const Signature& signature, std::span<const float> numbers) const {
    require_fits(signature);
    Domain more = *this;
    more.degenerate_.add_numbers(signature, parameters_, numbers);
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
    const std::size_t numbers =
        std::min(degenerate_.count_of_numbers(), (count - inputs.count()) / number_part);
    const std::size_t room = count - inputs.count() - numbers;
    const std::size_t taken = forced.size() <= room / 2 ? forced.size() : (room + 1) / 2;
    const std::size_t start = taken == forced.size() ? 0 : random.below(forced.size());
    for (std::size_t i = 0; i < taken; ++i)
        append_row(context, inputs, forced[(start + i * forced.size() / taken) % forced.size()]);
    while (inputs.count() < count - numbers) append_row(context, inputs, {});
    for (std::size_t i = 0; i < numbers; ++i)
        append_row(context, inputs,
                   {.change = degenerate_.count() + i * degenerate_.count_of_numbers() / numbers});
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
    std::size_t first = 0;
    for (const Values& values : parameters_) {
        const std::size_t words = values.words();
        const std::span<const Word> value = input.subspan(first, words);
        if (!std::ranges::equal(value, known.subspan(first, words)) && !values.admits(value)) return false;
        first += words;
    }
    std::vector<Word> adjusted(input.begin(), input.end());
    adjust(adjusted);
    return std::ranges::equal(adjusted, input);
}

void Domain::Inputs::add(std::span<const Word> row, bool at_branch) {
    words.insert(words.end(), row.begin(), row.end());
    branch.push_back(at_branch);
    width = row.size();
}

Domain::Inputs Domain::Inputs::where(const std::function<bool(std::size_t)>& wanted) const {
    Inputs some{.width = width};
    for (std::size_t i = 0; i < count(); ++i)
        if (wanted(i)) some.add(row(i), branch[i]);
    return some;
}

Domain::Inputs Domain::draw_unadjusted(std::size_t count, std::uint64_t seed, glm::ivec2 image_size) const {
    Inputs inputs;
    append_drawn(inputs, count, seed, image_size);
    return inputs;
}

void Domain::set_image_sizes(std::span<Word> row, glm::ivec2 size) const {
    std::size_t first = 0;
    for (const Values& values : parameters_) {
        for (const std::size_t at : values.image_sizes) {
            row[first + at] = static_cast<Word>(size.x);
            row[first + at + 1] = static_cast<Word>(size.y);
        }
        first += values.words();
    }
}

Domain::Inputs Domain::draw(std::size_t count, std::uint64_t seed, glm::ivec2 image_size) const {
    Inputs inputs;
    for (const std::vector<Word>& words : given_) {
        if (inputs.count() == count) break;
        inputs.add(words);
        set_image_sizes(std::span(inputs.words).last(inputs.width), image_size);
    }
    const std::size_t given = inputs.count();
    append_drawn(inputs, count, seed, image_size);
    for (std::size_t i = given; i < inputs.count(); ++i) {
        adjust(std::span(inputs.words).subspan(i * inputs.width, inputs.width));
    }
    return inputs;
}

}  // namespace gloam::check
