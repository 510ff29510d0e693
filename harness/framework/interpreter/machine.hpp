// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "base/hidden.hpp"
#include "interpreter/number.hpp"
#include "interpreter/program.hpp"
#include "interpreter/sampling.hpp"

namespace gloam::interpreter {

using backend::Word;

// One scalar of a running shader: a number of the machine's type, or bits (integers, bools, and floats in
// memory). Each form is converted to the other on demand.
template <class Number>
class Value {
  public:
    Value() = default;  // undefined: never written
    // Undefined, as an instruction made it: its number in the program, from 1.
    static Value undefined(Word origin) {
        Value value;
        value.bits_ = origin;
        return value;
    }
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
    [[nodiscard]] bool is_undefined() const { return state_ == State::undefined; }
    // Of an undefined value.
    [[nodiscard]] Word origin() const { return bits_; }

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
    static Value undefined(Word) { return {}; }
    [[nodiscard]] bool is_number() const { return false; }
    [[nodiscard]] bool is_bits() const { return false; }
    [[nodiscard]] bool is_undefined() const { return false; }
    [[nodiscard]] Word origin() const { return 0; }

  private:
    Word bits_ = 0;
};

namespace internal {
template <class Number>
struct State;
}

// An image: four words for each texel (the bits of floats or integers, as the shader reads them), row by row,
// layer by layer.
struct ImageView {
    std::array<std::uint32_t, 3> size{1, 1, 1};
    std::span<const Word> texels;
};

// One invocation of a dispatch: {x, y, z}.
struct Invocation {
    std::array<std::uint32_t, 3> group{};
    std::array<std::uint32_t, 3> local{};
    std::array<std::uint32_t, 3> group_size{1, 1, 1};
    std::array<std::uint32_t, 3> groups{1, 1, 1};
    std::uint32_t subgroup_size = 1;
};

// In which order the invocations of a group run between two barriers. A group without races has the same
// results in each, but for those of atomic operations.
enum class Order { forward, backward };

[[nodiscard]] std::string name_of_operation(std::uint16_t opcode);
// Whether its results are bools.
[[nodiscard]] bool gives_truth(std::uint16_t opcode);

// Why a value is undefined.
struct Undefined {
    std::string cause;  // "a shift by less than 0 or by more than 31"
    Location place;     // of the operation, or of the first read of what was never written
    // Whether an operation reads it, or made it; false for a variable that was never written and only copied.
    bool is_used = true;
};

// One executed instruction, with the value of every scalar of its result.
template <class Number>
struct Step {
    const Location& place;
    std::uint16_t opcode;  // of SPIR-V, or an Operation of the decoder above those
    std::span<const Value<Number>> results;
    const numeric::FloatFormat& format;  // of floats among them

    // Its name: "OpFAdd", "GLSL.std.450 Sqrt".
    [[nodiscard]] std::string operation() const { return name_of_operation(opcode); }
};

// Runs a program on one number type (number.hpp), one invocation at a time. A machine is not thread-safe; the
// program is. Bound memory must outlive the runs. On intervals a run must be inside
// numeric::Paths::explore(), which repeats it for every way of undecided branches.
template <class Number>
class Machine {
  public:
    explicit Machine(const Program& program);

    // Binds a buffer or image. It has no effect if the program does not use the binding. Writes of a shader
    // are visible to itself and to read() until the next run, which starts with the bound contents.
    void bind(std::uint32_t set, std::uint32_t binding, std::span<const Word> words);
    void bind(std::uint32_t set, std::uint32_t binding, const ImageView& image);
    void bind(std::uint32_t set, std::uint32_t binding, const SampledView& image);
    void bind_push_constants(std::span<const Word> words);

    // Selects the invocation. It runs alone: a barrier waits for nobody, and what needs others is an Error.
    void set_invocation(const Invocation& invocation);

    // Selects all invocations of the first one's group, which run together. Consecutive ones are a subgroup.
    // A fragment quad is a group of 2 x 2: gl_FragCoord is the centre of its pixel, and group and local give
    // the pixel. Runs throw Error for a race and a divergent barrier as well. Throws Error (malformed) for
    // more than most_invocations. `local` is not used.
    void set_group(const Invocation& first, Order order = Order::forward);
    static constexpr std::uint32_t most_invocations = 1024;

    // Runs the entry point to its end. Throws Error with the instruction's place.
    void run();
    // The same, and reports every instruction with a result.
    void run(const std::function<void(const Step<Number>&)>& tell);
    // The same, and counts what ran. `coverage`: of this program.
    void run(Coverage& coverage);

    // A word of a buffer or image after the run. Throws Error (missing, out_of_bounds).
    [[nodiscard]] Value<Number> read(std::uint32_t set, std::uint32_t binding, std::size_t word) const;

    // Why a value of the last run is undefined; nullopt if it is not. Machine<float> does not know.
    [[nodiscard]] std::optional<Undefined> why_undefined(const Value<Number>& value) const;

    // Lets the next run start with what the last one wrote: keep(word, bits) is called for each written word,
    // and returns what is kept there. It changes the bound memory in the same way.
    void keep_writes(std::uint32_t set, std::uint32_t binding,
                     const std::function<Word(std::size_t word, Word bits)>& keep);

    // On Interval: acts as one driver that keeps the rules. Each result becomes a number of its interval, an
    // end or one between, so that no comparison is undecided. What has no numbers, or may be NaN, stays.
    void set_sampling(std::uint64_t seed);

    // Limit of instructions in one run; a run with more throws Error (too_many_steps).
    void set_limit(std::uint64_t steps);
    // Instructions of all runs so far.
    [[nodiscard]] std::uint64_t steps() const;

  private:
    Program program_;
    base::Hidden<internal::State<Number>> state_;
};

}  // namespace gloam::interpreter
