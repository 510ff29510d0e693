// SPDX-License-Identifier: MIT
#include "check/degenerate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

}  // namespace

Degenerate::Degenerate(const Signature& signature, const std::vector<Values>& parameters)
    : parameters_(std::make_shared<const std::vector<Values>>(parameters)) {
    std::size_t first = 0;
    std::size_t next = 0;
    for (const shader::Parameter& parameter : signature.parameters) {
        if (parameter.direction == shader::Direction::out) continue;
        const Values& values = parameters_->at(next++);
        if (values.only_drawn) {
            add_vectors(parameter.type, first, nullptr);
        } else {
            if (parameter.type.scalar == Scalar::structure) add_struct(parameter.type, first);
            add_vectors(parameter.type, first, &values);
            add_sides(values, first);
        }
        first += scalars_of(parameter.type).size();
    }
}

void Degenerate::add_struct(const shader::Type& type, std::size_t first) {
    for (const Scalar scalar : scalars_of(type)) {
        if (scalar == Scalar::float_) {
            for (const Kind kind : {Kind::zero, Kind::negative, Kind::infinite, Kind::nan}) {
                changes_.push_back({first, kind});
            }
        }
        ++first;
    }
}

// Vectors in a struct are only copied from. They are not changed, because their valid values are unknown.
void Degenerate::add_vectors(const shader::Type& type, std::size_t first, const Values* values) {
    if (type.scalar == Scalar::structure) {
        for (const shader::Member& member : type.members) {
            add_vectors(member.type, first, nullptr);
            first += scalars_of(member.type).size();
        }
    } else if (type.scalar == Scalar::float_ && type.columns == 1 && type.rows > 1) {
        vectors_.push_back({first, static_cast<std::size_t>(type.rows), values});
    }
}

void Degenerate::add_sides(const Values& values, std::size_t first) {
    for (const std::size_t size : values.image_sizes) {
        for (const std::size_t side : {first + size, first + size + 1}) {
            changes_.push_back({side, Kind::zero});
            changes_.push_back({side, Kind::one});
        }
    }
}

void Degenerate::change(std::size_t i, std::span<Word> row) const {
    Word& word = row[changes_[i].word];
    switch (changes_[i].kind) {
        case Kind::zero:
            word = 0U;
            break;
        case Kind::negative:
            word = word == 0U ? to_word(-1.0F) : word | 0x80000000U;
            break;
        case Kind::infinite:
            word = to_word(std::numeric_limits<float>::infinity());
            break;
        case Kind::nan:
            word = to_word(std::numeric_limits<float>::quiet_NaN());
            break;
        case Kind::one:
            word = 1U;
            break;
    }
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

}  // namespace gloam::check
