// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "interpreter/internal/code.hpp"
#include "interpreter/internal/races.hpp"
#include "interpreter/internal/scalars.hpp"
#include "interpreter/internal/undefinedness.hpp"
#include "interpreter/machine.hpp"
#include "interpreter/number.hpp"
#include "numeric/paths.hpp"
#include "numeric/random.hpp"

namespace gloam::interpreter::internal {

// Converts a number of any type to one that the functions take; an expression that may be rearranged becomes
// its interval.
template <class N>
[[nodiscard]] const N& settled(const N& x) {
    return x;
}
[[nodiscard]] inline numeric::Interval settled(const numeric::Rearranged& x) {
    return x.interval();
}

// apply(f, x...): calls the function object f, which takes any of float, double and Interval, on a number
// type.
template <class F, class N, class... More>
[[nodiscard]] auto apply(const F& f, const N& x, const More&... more) {
    return f(x, more...);
}

// On Explained: calls f on every number type. If the result is a number, it also gets the local error.
template <class F, class... More>
[[nodiscard]] auto apply(const F& f, const Explained& x, const More&... more) {
    const auto rounded = [&] { return f(static_cast<float>(x.value), static_cast<float>(more.value)...); };
    if constexpr (std::is_same_v<decltype(rounded()), float>) {
        Explained result;
        const double reached = f(x.value, more.value...);
        result.value = rounded();
        result.exact = f(x.exact, more.exact...);
        result.local = result.value - reached;
        result.permitted = f(x.permitted, more.permitted...);
        return result;
    } else {
        return rounded();
    }
}

template <class F, class... More>
[[nodiscard]] auto apply(const F& f, const numeric::Rearranged& x, const More&... more) {
    const auto result = f(settled(x), settled(more)...);
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(result)>, numeric::Interval>) {
        return numeric::Rearranged(result);
    } else {
        return result;
    }
}

// A constant as a number.
template <class N>
[[nodiscard]] N constant(double x) {
    return N(x);
}
template <>
[[nodiscard]] inline numeric::Rearranged constant(double x) {
    return numeric::Rearranged(numeric::Interval(x));
}
template <>
[[nodiscard]] inline Explained constant(double x) {
    return {.value = x, .exact = x, .local = 0.0, .permitted = numeric::Interval(x)};
}

// The result of a half-precision operation: on intervals it may have the precision of float16.
template <class N>
[[nodiscard]] N relaxed(const N& x) {
    return with_permitted([](const numeric::Interval& any) { return numeric::enclose(any.bounds()); }, x);
}

// An end of the bounds, or a float32 between them; the same where there is none, or NaN may be.
[[nodiscard]] inline numeric::Interval sampled(const numeric::Interval& x, numeric::Random& random) {
    const numeric::Bounds& b = x.bounds();
    if (b.empty() || b.nan || !std::isfinite(b.low) || !std::isfinite(b.high)) return x;
    const std::uint64_t lot = random.below(4);
    const double between = static_cast<float>(random.uniform(b.low, b.high));
    const double chosen = lot == 0 ? b.low : lot == 1 ? b.high : std::clamp(between, b.low, b.high);
    return numeric::Interval::within(chosen, chosen);
}

// Whether a machine knows which of its values are undefined.
template <class N>
inline constexpr bool knows_undefined = !std::is_same_v<N, float>;

template <class N>
struct State;

template <class N>
using Handler = void (*)(State<N>&, const Instruction&);

// The contents of one resource during runs.
template <class N>
struct Backing {
    std::span<const Word> words;       // as the caller bound it
    std::vector<Value<N>> values;      // the same, if the shader may write to it
    std::vector<std::uint32_t> dirty;  // indices of written words, restored before the next run
    std::optional<ImageView> image;
    std::optional<SampledView> sampled;
};

// A selection, loop or call in which an invocation is. Invocations that entered it together come together
// again behind it, and at the continue target of each iteration.
struct Construct {
    std::uint32_t behind = 0;     // instruction
    std::uint32_t continues = 0;  // instruction; 0: it is no loop
    std::uint64_t path = 0;       // on which it was entered
    std::uint64_t iteration = 0;  // path on which the iteration began
    std::uint32_t count = 0;      // iterations before
};

// The way that an invocation of a group has taken: two are at the same dynamic instance of an instruction if
// they are at the instruction, on the same path.
class Path {
  public:
    [[nodiscard]] std::uint64_t path() const { return path_; }

    // Whether it is in an earlier iteration of a loop than the other; nullopt: in the same ones.
    [[nodiscard]] std::optional<bool> is_before(const Path& other) const {
        for (std::size_t k = 0; k < std::min(constructs_.size(), other.constructs_.size()); ++k) {
            const Construct& a = constructs_[k];
            const Construct& b = other.constructs_[k];
            if (a.behind != b.behind) break;
            if (a.count != b.count) return a.count < b.count;
        }
        return std::nullopt;
    }

    // Enters a construct, or begins a loop's next iteration.
    void enter(std::uint32_t behind, std::uint32_t continues) {
        if (!constructs_.empty() && constructs_.back().behind == behind) return;
        constructs_.push_back({.behind = behind, .continues = continues, .path = path_, .iteration = path_});
    }

    // Takes an edge to an instruction.
    void take(std::uint32_t edge, std::uint32_t target) {
        for (std::size_t k = constructs_.size(); k-- > 0;) {
            Construct& in = constructs_[k];
            if (in.behind == target) {
                path_ = in.path;
                constructs_.resize(k);
                return;
            }
            if (in.continues != 0 && in.continues == target) {
                path_ = in.iteration = onward(in.iteration, target);
                ++in.count;
                constructs_.resize(k + 1);
                return;
            }
        }
        path_ = onward(path_, std::uint64_t{edge} + 1);
    }

  private:
    static std::uint64_t onward(std::uint64_t path, std::uint64_t step) {
        constexpr std::uint64_t odd = 0x9e3779b97f4a7c15U;
        constexpr int turn = 17;
        return (std::rotl(path, turn) ^ step) * odd;
    }

    std::uint64_t path_ = 0;
    std::vector<Construct> constructs_;
};

// An invocation of a group while another one runs.
template <class N>
struct Lane {
    enum class Progress { runs, waits, ended };
    std::vector<Value<N>> slots;
    std::vector<Pointer> pointers;
    Path way;
    std::uint32_t next = 0;
    Progress progress = Progress::runs;
    std::uint32_t fenced = 0;  // semantics of its fences since the last barrier
};

template <class N>
struct State {
    const Code& code;
    std::vector<Value<N>> slots;
    std::vector<Pointer> pointers;
    std::vector<Backing<N>> backings;
    std::vector<Handler<N>> handlers;
    std::vector<Value<N>> moving;  // sources of an edge's copies, while these are made
    std::uint32_t next = 0;        // instruction
    bool running = false;
    bool waits = false;          // for other invocations, at the last instruction
    std::vector<Lane<N>> lanes;  // of a group (internal/group.hpp); empty: one invocation alone
    std::uint32_t lane = 0;      // that runs
    Path way;                    // of that one
    std::uint32_t subgroup_size = 1;
    std::uint32_t fenced = 0;                 // see Lane
    mutable std::optional<Races> races;       // of a group
    std::vector<Word> shared;                 // as many words as the largest shared variable has
    std::optional<numeric::Random> sampling;  // see Machine::set_sampling()
    std::uint64_t cost = 0;                   // of the last instruction, in steps besides its own
    std::uint32_t at = 0;                     // the instruction that runs
    std::uint64_t steps = 0;                  // instructions of all runs so far
    std::uint64_t limit = 50'000'000;         // of one run
    std::uint64_t end = 0;                    // of the steps of this run
    std::uint8_t format = 0;                  // the flags of numeric::Paths's format
    Order order = Order::forward;             // of the lanes

    mutable Undefinedness undefinedness;

    // Whether an operand is undefined, which its reader has to respect.
    bool touch([[maybe_unused]] Slot slot) const {
        if constexpr (knows_undefined<N>) {
            if (!slots[slot].is_undefined()) return false;
            undefinedness.touch(slots[slot].origin(), next - 1);
            return true;
        }
        return false;
    }
    // After an instruction: on intervals every result is permitted where an undefined operand has gone into
    // something else than a value.
    void forget_touched() {
        if (has_bounds<N> && !undefinedness.spread) throw numeric::Paths::Undetermined{};
        undefinedness.touched = false;
    }

    [[nodiscard]] Word bits(Slot slot) const { return touch(slot) ? 0U : slots[slot].bits(); }

    // The bits on which a branch or an index depends. Throws Fault if they are undefined.
    [[nodiscard]] Word known_bits(Slot slot) const {
        if (!touch(slot)) return slots[slot].bits();
        if (has_bounds<N>) throw numeric::Paths::Undetermined{};
        const Undefined why = why_undefined(slots[slot].origin());
        throw Fault{Error::Kind::undefined, fmt::format("{}{}, and a branch or an index depends on it",
                                                        why.cause, where_text(why.place))};
    }
    [[nodiscard]] Undefined why_undefined(Word origin) const;

    // A float operand with the precision that the instruction asks for.
    [[nodiscard]] N number(const Instruction& i, Slot slot) const {
        touch(slot);
        const N x = slots[slot].number();
        if ((i.flags & flags::relaxed) != 0) return relaxed(x);
        return x;
    }
    void set(const Instruction& i, Slot slot, const N& x) {
        if (spreads(i, slot)) return;
        if constexpr (std::is_same_v<N, numeric::Interval>) {
            if (sampling) {
                slots[slot] = Value<N>::of(sampled(x, *sampling));
                return;
            }
        }
        slots[slot] = Value<N>::of((i.flags & flags::half) != 0 ? halved(x) : x);
    }
    void set(const Instruction& i, Slot slot, Word x) {
        if (!spreads(i, slot)) slots[slot] = Value<N>::of_bits(x);
    }
    void set(const Instruction& i, Slot slot, int x) { set(i, slot, static_cast<Word>(x)); }
    void set(const Instruction& i, Slot slot, bool x) { set(i, slot, x ? Word{1} : Word{0}); }
    // The result of an operation that is defined for some operands only.
    template <class T>
    void set_if(bool defined, const Instruction& i, Slot slot, const T& x) {
        if (knows_undefined<N> && !defined && !undefinedness.touched) {
            slots[slot] = Value<N>::undefined(next);
        } else {
            set(i, slot, x);
        }
    }

    // The index of a word in a resource. Throws Fault if it is outside.
    [[nodiscard]] std::size_t word_of(const Pointer& pointer, std::uint32_t offset) const {
        const std::size_t index = (std::size_t{pointer.offset} + offset) / sizeof(Word);
        const Backing<N>& backing = backings[pointer.resource];
        if (index >= backing.words.size()) {
            const Resource& resource = code.resources[pointer.resource];
            if (backing.words.empty())
                throw Fault{Error::Kind::missing,
                            fmt::format("nothing is bound to \"{}\" (set {}, binding {})", resource.name,
                                        resource.set, resource.binding)};
            throw Fault{Error::Kind::out_of_bounds, fmt::format("word {} of the {} of \"{}\"", index,
                                                                backing.words.size(), resource.name)};
        }
        return index;
    }
    [[nodiscard]] Value<N> read(const Pointer& pointer, std::uint32_t offset,
                                Races::Use use = Races::Use::read) const {
        const std::size_t index = word_of(pointer, offset);
        const Backing<N>& backing = backings[pointer.resource];
        if (races && !backing.values.empty()) watch(pointer.resource, index, use);
        return backing.values.empty() ? Value<N>::of_bits(backing.words[index]) : backing.values[index];
    }
    void write(const Pointer& pointer, std::uint32_t offset, const Value<N>& value,
               Races::Use use = Races::Use::write) {
        const std::size_t index = word_of(pointer, offset);
        if (races) watch(pointer.resource, index, use);
        Backing<N>& backing = backings[pointer.resource];
        backing.values[index] = value;
        backing.dirty.push_back(static_cast<std::uint32_t>(index));
    }

    // The resource's word of a pointer, for Races.
    [[nodiscard]] Races::Where where(const Pointer& pointer) const {
        return {pointer.resource, static_cast<std::uint32_t>(word_of(pointer, 0))};
    }

  private:
    // Whether the result is undefined, because an operand is. The components of an operation follow one
    // another, but some operations read all operands before their first result.
    bool spreads(const Instruction& i, Slot slot) {
        if (!knows_undefined<N> || !undefinedness.touched) return false;
        slots[slot] = Value<N>::undefined(undefinedness.origin);
        undefinedness.spread = true;
        undefinedness.touched = (i.flags & flags::reads_first) != 0;
        return true;
    }
    static N halved(const N& x);

    // Throws Fault for a race.
    void watch(std::uint32_t resource, std::size_t word, Races::Use use) const {
        const Races::Access now{.lane = lane, .instruction = next - 1, .use = use};
        const auto other = races->add({resource, static_cast<std::uint32_t>(word)}, now);
        if (!other) return;
        const bool writes = use != Races::Use::read;
        throw Fault{
            Error::Kind::race,
            fmt::format("a race: invocation {} {} word {} of \"{}\", which invocation {} {} at {} with "
                        "no barrier between them",
                        lane, writes ? "writes" : "reads", word, code.resources[resource].name, other->lane,
                        other->use == Races::Use::read ? "reads" : "writes",
                        to_text(code.places[code.instructions[other->instruction].place]))};
    }
};

template <class N>
Undefined State<N>::why_undefined(Word origin) const {
    const bool was_made = origin != 0 && code.instructions[origin - 1].op != undefine;
    if (was_made)
        return {cause_of(code, code.instructions[origin - 1]),
                code.places[code.instructions[origin - 1].place]};
    const auto read = undefinedness.read_of(origin);
    const std::string cause =
        origin == 0 ? "a value was never written or returned" : cause_of(code, code.instructions[origin - 1]);
    if (read) return {cause, code.places[code.instructions[*read].place]};
    return {cause, origin == 0 ? Location{} : code.places[code.instructions[origin - 1].place], false};
}

// A number stored in 16 bits. Intervals are not rounded here: their operations have that format.
template <class N>
N State<N>::halved(const N& x) {
    if constexpr (std::is_same_v<N, float>) {
        return scalars::quantize_to_half(x);
    } else if constexpr (std::is_same_v<N, Explained>) {
        N result = x;
        result.value = scalars::quantize_to_half(x.value);
        if (std::isfinite(result.value)) result.local += result.value - x.value;
        return result;
    } else {
        return x;
    }
}

}  // namespace gloam::interpreter::internal
