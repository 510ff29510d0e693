// SPDX-License-Identifier: MIT
#include "check/internal/input_class.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/float_class.hpp"

namespace gloam::check::internal {
namespace {

using shader::Scalar;

InputClass class_of(float value) {
    switch (numeric::classify(value)) {
        case numeric::FloatClass::zero:
            return InputClass::zero;
        case numeric::FloatClass::subnormal:
            return InputClass::subnormal;
        case numeric::FloatClass::huge:
            return InputClass::huge;
        case numeric::FloatClass::infinite:
            return InputClass::infinite;
        case numeric::FloatClass::nan:
            return InputClass::nan;
        case numeric::FloatClass::ordinary:
            break;
    }
    return InputClass::ordinary;
}

}  // namespace

InputClass class_of(std::span<const Word> inputs, const std::vector<Scalar>& scalars, bool branch) {
    auto worst = branch ? InputClass::branch : InputClass::ordinary;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        if (scalars[i] == Scalar::float_) worst = std::max(worst, class_of(from_word<float>(inputs[i])));
    return worst;
}

void set_positive_zeros(std::span<Word> words, const std::vector<Scalar>& scalars) {
    constexpr Word negative_zero = 0x80000000U;
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == negative_zero && scalars[i % scalars.size()] == Scalar::float_) words[i] = 0;
}

bool holds_special(const Sample& sample, const std::vector<Scalar>& scalars) {
    for (std::size_t i = 0; i < sample.inputs.size(); ++i) {
        if (scalars[i] != Scalar::float_) continue;
        const auto value = from_word<float>(sample.inputs[i]);
        if (!std::isfinite(value) || (value == 0.0F && std::signbit(value))) return true;
    }
    return std::ranges::any_of(sample.want, [](double want) { return !std::isfinite(want); });
}

}  // namespace gloam::check::internal
