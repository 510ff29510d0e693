// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "interpreter/number.hpp"

namespace gloam::interpreter {

using Word = std::uint32_t;

// One scalar of a running shader: a number of the machine's type, or 32 bits (integers, bools, and floats in
// memory). Each form is converted to the other on demand.
template <class Number>
class Value {
  public:
    Value() = default;  // undefined
    static Value of(const Number& number) {
        Value value;
        value.number_ = number;
        value.state_ = State::number;
        return value;
    }
    static Value of_bits(Word bits) {
        Value value;
        value.bits_ = bits;
        value.state_ = State::bits;
        return value;
    }

    // From the bits of a float; both forms are stored.
    static Value of_float(Word bits) {
        Value value;
        value.number_ = number_from_bits<Number>(bits);
        value.bits_ = bits;
        value.state_ = State::both;
        return value;
    }

    // As a float. Bits are converted like a constant of the module. The result is arbitrary if the value is
    // undefined.
    [[nodiscard]] Number number() const {
        if (state_ >= State::number) return number_;
        return state_ == State::bits ? number_from_bits<Number>(bits_) : undefined_number<Number>();
    }
    // As bits: those of the float nearest to the number. On intervals each possible float is explored.
    [[nodiscard]] Word bits() const {
        if (state_ == State::bits || state_ == State::both) return bits_;
        return state_ == State::number ? bits_from_number(number_) : undefined_bits<Number>();
    }
    // Whether it is a number and not bits.
    [[nodiscard]] bool is_number() const { return state_ == State::number; }
    [[nodiscard]] bool is_bits() const { return state_ == State::bits; }

  private:
    enum class State : std::uint8_t { undefined, bits, number, both };

    Number number_{};
    Word bits_ = 0;
    State state_ = State::undefined;
};

// A float is stored as its bits; an undefined value becomes zero.
template <>
class Value<float> {
  public:
    Value() = default;
    static Value of(float number) { return of_bits(std::bit_cast<Word>(number)); }
    static Value of_bits(Word bits) {
        Value value;
        value.bits_ = bits;
        return value;
    }
    [[nodiscard]] float number() const { return std::bit_cast<float>(bits_); }
    [[nodiscard]] Word bits() const { return bits_; }
    static Value of_float(Word bits) { return of_bits(bits); }
    [[nodiscard]] bool is_number() const { return false; }
    [[nodiscard]] bool is_bits() const { return false; }

  private:
    Word bits_ = 0;
};

}  // namespace gloam::interpreter
