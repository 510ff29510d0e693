// SPDX-License-Identifier: MIT
#include "subject/domain.hpp"

#include <fmt/ranges.h>
#include <array>
#include <limits>
#include <stdexcept>
#include <utility>

#include "numeric/numbers.hpp"

namespace gloam::subject {
namespace {

using module::Scalar;

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

Domain::Domain(std::vector<Values> parameters)
    : parameters_(std::make_shared<const std::vector<Values>>(std::move(parameters))) {
    for (const Values& values : *parameters_)
        for (const std::size_t words = values.words(); const Values::Fixed& fixed : values.fixed)
            if (fixed.words.size() != words)
                throw std::invalid_argument("a fixed value is of another type than those drawn");
}

Domain Domain::tied(std::size_t target, std::size_t source, double factor) const {
    if (target >= parameters_->size() || source >= parameters_->size())
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

Domain Domain::and_words(const std::vector<Word>& words) const {
    Domain more = *this;
    more.given_.push_back(words);
    return more;
}

void Domain::require_fits(const Signature& signature, const std::string& function) const {
    const std::vector<InputSlot> slots = signature.inputs();
    if (slots.size() != parameters_->size())
        throw std::invalid_argument(fmt::format("the domain has {} entries, {} takes {} inputs",
                                                parameters_->size(), function, slots.size()));
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const module::Parameter& parameter = *slots[i].parameter;
        const std::vector<Scalar> scalars = scalars_of(parameter.type);
        const auto refused = [&](const std::string& draws) {
            return std::invalid_argument(fmt::format(
                "{}: entry {} of the domain draws {}, the parameter is {}{}{}", function, i + 1, draws,
                module::name_of(parameter.type), parameter.name.empty() ? "" : " ", parameter.name));
        };
        if (const std::size_t words = (*parameters_)[i].words(); words != scalars.size())
            throw refused(fmt::format("{} numbers", words));
        const std::vector<bool>& floats = (*parameters_)[i].floats;
        for (std::size_t k = 0; k < floats.size(); ++k)
            if (floats[k] != module::is_float(scalars[k])) throw refused(floats[k] ? "floats" : "integers");
    }
}

Domain Domain::fitted(const Signature& signature, const std::string& function) const {
    require_fits(signature, function);
    const std::vector<Scalar> scalars = signature.input_scalars();
    if (std::ranges::find(scalars, Scalar::float16_) == scalars.end()) return *this;
    return adjusted([scalars](std::span<Word> words) {
        for (std::size_t k = 0; k < words.size(); ++k)
            if (scalars[k] == Scalar::float16_)
                words[k] = float_word(scalars[k], from_word<double>(words[k]));
    });
}

Domain Domain::and_degenerate(const Signature& signature, bool only_vectors) const {
    require_fits(signature);
    Domain more = *this;
    more.degenerate_ = {};
    Degenerate& all = more.degenerate_;
    std::size_t parameter = 0;
    for (const InputSlot& slot : signature.inputs()) {
        const module::Type& type = slot.parameter->type;
        const std::size_t first = slot.first;
        const Values& values = (*parameters_)[parameter];
        const bool composed = type.scalar == Scalar::structure || !type.sizes.empty();
        // Vectors in a struct or an array are only copied from: their valid values are unknown.
        for_each_value(type, [&, at = first](const module::Type& one) mutable {
            const auto size = static_cast<std::size_t>(one.columns * one.rows);
            if (one.scalar == Scalar::float_ && one.columns == 1 && one.rows > 1)
                all.vectors.push_back(
                    {at, size, values.only_drawn || composed ? std::nullopt : std::optional(parameter)});
            at += size;
        });
        ++parameter;
        if (values.only_drawn || only_vectors) continue;
        const std::vector<Scalar> scalars = scalars_of(type);
        for (std::size_t i = 0; composed && i < scalars.size(); ++i)
            for (const auto change : of_floats)
                if (scalars[i] == Scalar::float_) all.changes.push_back({first + i, change});
        for (const std::size_t size : values.image_sizes)
            for (const std::size_t side : {size, size + 1})
                for (const auto change : of_sides) all.changes.push_back({first + side, change});
    }
    return more;
}

Domain Domain::and_numbers(const Signature& signature, std::span<const float> numbers) const {
    require_fits(signature);
    std::vector<Word> bits;
    for (const float number : numbers) {
        if (number == 0.0F) continue;  // which Values have; beside it are subnormal numbers
        for (const float sign : {1.0F, -1.0F})
            for (const int steps : {-1, 0, 1}) bits.push_back(to_word(numeric::step(sign * number, steps)));
    }
    Domain more = *this;
    const std::vector<InputSlot> slots = signature.inputs();
    for (std::size_t parameter = 0; parameter < slots.size(); ++parameter) {
        const std::vector<Scalar> scalars = scalars_of(slots[parameter].parameter->type);
        const Values& values = (*parameters_)[parameter];
        for (std::size_t k = 0; k < scalars.size() && values.contains && !values.only_drawn; ++k) {
            if (scalars[k] != Scalar::float_) continue;
            const bool anywhere = std::ranges::any_of(values.fixed, [k](const Values::Fixed& fixed) {
                return std::isinf(from_word<float>(fixed.words[k]));
            });
            for (const Word number : bits)
                more.degenerate_.numbers.push_back({slots[parameter].first + k, number, parameter, anywhere});
        }
    }
    return more;
}

// Draws the inputs of one run.
class Domain::Drawing {
  public:
    Drawing(const Domain& domain, std::uint64_t seed, glm::ivec2 image_size)
        : parameters_(*domain.parameters_),
          ties_(domain.ties_),
          degenerate_(domain.degenerate_),
          random_(seed),
          context_{.random = random_, .image_size = image_size} {
        for (const Values& values : parameters_) offsets_.push_back(offsets_.back() + values.words());
    }

    // Until there are so many.
    void append(Inputs& inputs, std::size_t count) {
        std::vector<Forced> forced;
        for (std::size_t p = 0; p < parameters_.size(); ++p)
            for (std::size_t value = 0; value < parameters_[p].fixed.size(); ++value)
                forced.push_back({.parameter = p, .value = value});
        for (std::size_t change = 0; change < degenerate_.changes.size(); ++change)
            forced.push_back({.change = change});
        const std::size_t all_numbers = degenerate_.numbers.size();
        const std::size_t numbers = std::min(all_numbers, (count - inputs.count()) / number_part);
        const std::size_t room = count - inputs.count() - numbers;
        const std::size_t taken = forced.size() <= room / 2 ? forced.size() : (room + 1) / 2;
        const std::size_t start = taken == forced.size() ? 0 : random_.below(forced.size());
        for (std::size_t i = 0; i < taken; ++i)
            append_row(inputs, forced[(start + i * forced.size() / taken) % forced.size()]);
        while (inputs.count() < count - numbers) append_row(inputs, {});
        for (std::size_t i = 0; i < numbers; ++i)
            append_row(inputs, {.change = degenerate_.changes.size() + i * all_numbers / numbers});
    }

  private:
    // A fixed value of a parameter, or a change, that an input must have. Numbers follow the other changes.
    struct Forced {
        std::size_t parameter = nothing;
        std::size_t value = 0;
        std::size_t change = nothing;
    };

    void append_row(Inputs& inputs, const Forced& forced) {
        const bool any_forced = forced.parameter != nothing || forced.change != nothing;
        const std::uint64_t lot = random_.below(chances);
        const bool all_fixed = !any_forced && lot < all_fixed_chance;
        const bool one_fixed = !any_forced && !all_fixed && lot < all_fixed_chance + one_fixed_chance;
        const std::size_t chosen =
            one_fixed && !parameters_.empty() ? random_.below(parameters_.size()) : nothing;
        std::vector<Word> row;
        bool branch = false;
        for (std::size_t p = 0; p < parameters_.size(); ++p) {
            const Values& values = parameters_[p];
            if ((p == forced.parameter || all_fixed || p == chosen) && !values.fixed.empty()) {
                const Values::Fixed& value =
                    values.fixed[p == forced.parameter ? forced.value : random_.below(values.fixed.size())];
                row.insert(row.end(), value.words.begin(), value.words.end());
                branch = branch || value.branch;
            } else {
                values.draw(context_, row);
            }
        }
        branch = apply_tie(row) || branch;
        branch = make_degenerate(row, forced) || branch;
        inputs.add(row, branch);
    }

    bool apply_tie(std::span<Word> row) {
        if (ties_.empty() || random_.below(chances) >= tie_chance) return false;
        const Tie& tie = ties_[random_.below(ties_.size())];
        const auto source = static_cast<double>(from_word<float>(row[offsets_[tie.source]]));
        const int steps = static_cast<int>(random_.below(3)) - 1;
        row[offsets_[tie.target]] = to_word(numeric::step(static_cast<float>(source * tie.factor), steps));
        return true;
    }

    bool make_degenerate(std::span<Word> row, const Forced& forced) {
        if (forced.change != nothing) return change(forced.change, row);
        if (forced.parameter != nothing || random_.below(chances) >= degenerate_chance) return false;
        const std::size_t changes = degenerate_.changes.size();
        if (changes > 0 && random_.below(4) == 0) return change(random_.below(changes), row);
        const bool once = relate(row);
        return relate(row) || once;
    }

    // Returns true.
    bool change(std::size_t i, std::span<Word> row) const {
        const std::size_t changes = degenerate_.changes.size();
        if (i < changes) {
            Word& word = row[degenerate_.changes[i].word];
            word = degenerate_.changes[i].changed(word);
            return true;
        }
        const Degenerate::Number& number = degenerate_.numbers[i - changes];
        const Word before = std::exchange(row[number.word], number.bits);
        const std::size_t first = offsets_[number.parameter];
        const auto value = row.subspan(first, offsets_[number.parameter + 1] - first);
        if (!number.anywhere && !parameters_[number.parameter].admits(value)) row[number.word] = before;
        return true;
    }

    // Replaces one vector, chosen at random, by an axis or by another vector of the input, if its Values
    // admit the result. Values without a test admit every vector of the same length. Returns whether a vector
    // was changed.
    bool relate(std::span<Word> row) {
        const auto& vectors = degenerate_.vectors;
        if (vectors.empty()) return false;
        const Degenerate::Vector& target = vectors[random_.below(vectors.size())];
        const Degenerate::Vector& source = vectors[random_.below(vectors.size())];
        if (!target.parameter) return false;
        const std::span<Word> old = row.subspan(target.first, target.size);
        const double length = length_of(old);
        const bool related = source.size == target.size && source.first != target.first;
        std::vector<Word> words = related ? scaled(row.subspan(source.first, source.size), factor_of(random_))
                                          : along_axis(random_, target.size, length);
        const Values& values = parameters_[*target.parameter];
        if (!values.contains || !values.admits(words)) {
            const double factor = length / length_of(words);
            if (!std::isfinite(factor)) return false;
            words = scaled(words, factor);
            if (values.contains && !values.admits(words)) return false;
        }
        std::ranges::copy(words, old.begin());
        return true;
    }

    const std::vector<Values>& parameters_;
    const std::vector<Tie>& ties_;
    const Degenerate& degenerate_;
    numeric::Random random_;
    DrawContext context_;
    std::vector<std::size_t> offsets_{0};  // of the parameters' words, and of the end
};

Domain::Inputs Domain::draw_unadjusted(std::size_t count, std::uint64_t seed, glm::ivec2 image_size) const {
    Inputs inputs;
    Drawing(*this, seed, image_size).append(inputs, count);
    return inputs;
}

Domain::Inputs Domain::draw(std::size_t count, std::uint64_t seed, glm::ivec2 image_size) const {
    Inputs inputs;
    for (std::vector<Word> words : given_) {
        if (inputs.count() == count) break;
        std::size_t first = 0;
        for (const Values& values : *parameters_) {
            for (const std::size_t at : values.image_sizes) {
                words[first + at] = static_cast<Word>(image_size.x);
                words[first + at + 1] = static_cast<Word>(image_size.y);
            }
            first += values.words();
        }
        inputs.add(words);
    }
    const std::size_t given = inputs.count();
    Drawing(*this, seed, image_size).append(inputs, count);
    for (std::size_t i = given; i < inputs.count(); ++i)
        adjust(std::span(inputs.words).subspan(i * inputs.width, inputs.width));
    return inputs;
}

void Domain::adjust(std::span<Word> row) const {
    for (const auto& adjustment : adjustments_) adjustment(row);
}

bool Domain::holds(std::span<const Word> input, std::span<const Word> known) const {
    std::size_t first = 0;
    for (const Values& values : *parameters_) {
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

}  // namespace gloam::subject
