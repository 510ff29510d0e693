// SPDX-License-Identifier: MIT
#pragma once

#include "interpreter/internal/opcodes.hpp"

#include <algorithm>
#include <bit>
#include <map>

#include "interpreter/internal/control.hpp"
#include "interpreter/internal/integers.hpp"

// Invocations that run together. Each runs by itself to where it waits for others; what they do there is done
// for all of them at once.
namespace gloam::interpreter::internal {

template <class N>
void enter(State<N>& s, std::uint32_t lane) {
    Lane<N>& entered = s.lanes[lane];
    std::swap(s.slots, entered.slots);
    std::swap(s.pointers, entered.pointers);
    std::swap(s.way, entered.way);
    s.next = entered.next;
    s.fenced = entered.fenced;
    s.lane = lane;
    s.running = true;
}

template <class N>
void leave(State<N>& s) {
    Lane<N>& left = s.lanes[s.lane];
    std::swap(s.slots, left.slots);
    std::swap(s.pointers, left.pointers);
    std::swap(s.way, left.way);
    left.next = s.next;
    left.fenced = s.fenced;
    left.progress = std::exchange(s.waits, false) ? Lane<N>::Progress::waits : Lane<N>::Progress::ended;
}

// The sum or product of numbers in any order.
template <class F, class N>
[[nodiscard]] N total(const std::vector<N>& all) {
    if constexpr (std::is_same_v<N, numeric::Interval>) {
        std::vector<numeric::Rearranged> free(all.begin(), all.end());
        return total<F>(free).interval();
    } else if constexpr (std::is_same_v<N, Explained>) {
        N result = all.front();
        std::vector<numeric::Interval> permitted{result.permitted};
        for (std::size_t k = 1; k < all.size(); ++k) {
            result = apply(F{}, result, all[k]);
            permitted.push_back(all[k].permitted);
        }
        result.permitted = total<F>(permitted);
        return result;
    } else {
        N result = all.front();
        for (std::size_t k = 1; k < all.size(); ++k) result = F{}(result, all[k]);
        return result;
    }
}

// How words become one: by an atomic operation; of no invocation at all the identity is left. Floats have
// none.
struct Reduction {
    std::uint32_t atomic = 0;
    Word identity = 0;
    bool of_floats = false;
};
[[nodiscard]] inline const Reduction& reduction_of(std::uint32_t opcode) {
    constexpr Word sign = Word{1} << (word_bits - 1);
    static const std::map<std::uint32_t, Reduction> rows{
        {SpvOpGroupNonUniformIAdd, {SpvOpAtomicIAdd, 0}},
        {SpvOpGroupNonUniformIMul, {0, 1}},  // no atomic operation multiplies
        {SpvOpGroupNonUniformSMin, {SpvOpAtomicSMin, ~sign}},
        {SpvOpGroupNonUniformUMin, {SpvOpAtomicUMin, ~Word{0}}},
        {SpvOpGroupNonUniformSMax, {SpvOpAtomicSMax, sign}},
        {SpvOpGroupNonUniformUMax, {SpvOpAtomicUMax, 0}},
        {SpvOpGroupNonUniformBitwiseAnd, {SpvOpAtomicAnd, ~Word{0}}},
        {SpvOpGroupNonUniformBitwiseOr, {SpvOpAtomicOr, 0}},
        {SpvOpGroupNonUniformBitwiseXor, {SpvOpAtomicXor, 0}},
        {SpvOpGroupNonUniformLogicalAnd, {SpvOpAtomicAnd, 1}},
        {SpvOpGroupNonUniformLogicalOr, {SpvOpAtomicOr, 0}},
        {SpvOpGroupNonUniformLogicalXor, {SpvOpAtomicXor, 0}},
        {SpvOpGroupNonUniformFAdd, {0, 0, true}},
        {SpvOpGroupNonUniformFMul, {0, std::bit_cast<Word>(1.0F), true}},
        {SpvOpGroupNonUniformFMin, {0, exponent_mask, true}},
        {SpvOpGroupNonUniformFMax, {0, sign | exponent_mask, true}}};
    return rows.at(opcode);
}

template <class N>
[[nodiscard]] Value<N> reduced(std::uint32_t opcode, const std::vector<Value<N>>& all) {
    const auto& [atomic, identity, of_floats] = reduction_of(opcode);
    if (all.empty()) return of_floats ? Value<N>::of_float(identity) : Value<N>::of_bits(identity);
    if (!of_floats) {
        Word result = all.front().bits();
        for (std::size_t k = 1; k < all.size(); ++k)
            result = atomic == 0 ? result * all[k].bits() : exchanged(atomic, result, all[k].bits(), 0);
        return Value<N>::of_bits(result);
    }
    std::vector<N> numbers;
    for (const Value<N>& one : all) numbers.push_back(one.number());
    if (opcode == SpvOpGroupNonUniformFAdd) return Value<N>::of(total<Add>(numbers));
    if (opcode == SpvOpGroupNonUniformFMul) return Value<N>::of(total<Multiply>(numbers));
    N result = numbers.front();
    for (std::size_t k = 1; k < numbers.size(); ++k)
        result = opcode == SpvOpGroupNonUniformFMin ? apply(Min{}, result, numbers[k])
                                                    : apply(Max{}, result, numbers[k]);
    return Value<N>::of(result);
}

// Some invocations at an instruction where they wait for each other.
template <class N>
class Meeting {
  public:
    Meeting(State<N>& state, std::vector<std::uint32_t> lanes)
        : s_(state), lanes_(std::move(lanes)), i_(s_.code.instructions[s_.lanes[lanes_.front()].next - 1]) {}

    void hold() {
        std::vector<std::vector<Value<N>>> results;
        for (const std::uint32_t lane : lanes_)
            results.push_back(i_.op == neighbour ? neighbours(lane) : collected(lane));
        for (std::size_t k = 0; k < lanes_.size(); ++k) {
            std::ranges::copy(results[k], slots(lanes_[k]).begin() + i_.result);
            s_.lanes[lanes_[k]].progress = Lane<N>::Progress::runs;
        }
    }

  private:
    using Values = std::vector<Value<N>>;

    [[nodiscard]] Values& slots(std::uint32_t lane) const { return s_.lanes[lane].slots; }
    [[nodiscard]] Values values(std::uint32_t lane, Slot from, std::uint32_t count) const {
        const auto first = slots(lane).begin() + from;
        return Values(first, first + count);
    }
    [[nodiscard]] bool is_present(std::uint32_t lane) const {
        return std::ranges::find(lanes_, lane) != lanes_.end();
    }

    // Undefined where the quad is not complete: some have taken another way, or ended.
    [[nodiscard]] Values neighbours(std::uint32_t lane) const {
        const std::uint32_t quad = lane & ~3U;
        for (std::uint32_t k = 0; k < 4; ++k)
            if (!is_present(quad + k)) return Values(i_.count);
        const std::uint32_t end = (i_.extra & second) != 0 ? 1 : 0;
        const std::uint32_t other = (i_.extra & other_line) != 0 ? 1 : 0;
        const bool in_column = (i_.extra & column) != 0;
        const std::uint32_t line = (in_column ? lane & 1U : lane >> 1U & 1U) ^ other;
        return values(quad + (in_column ? line + 2 * end : end + 2 * line), i_.a, i_.count);
    }

    // The value of an invocation of the subgroup; undefined if it is not here.
    [[nodiscard]] Values of(std::int64_t in_subgroup) const {
        const std::uint32_t first = lanes_.front() / s_.subgroup_size * s_.subgroup_size;
        const std::int64_t lane = first + in_subgroup;
        const bool outside = in_subgroup < 0 || in_subgroup >= s_.subgroup_size;
        if (outside || !is_present(static_cast<std::uint32_t>(lane))) return Values(i_.count);
        return values(static_cast<std::uint32_t>(lane), i_.a, i_.count);
    }

    [[nodiscard]] Values ballot() const {
        constexpr std::size_t words = 4;
        std::array<Word, words> mask{};
        for (const std::uint32_t lane : lanes_)
            if (slots(lane)[i_.a].bits() != 0)
                mask.at(lane % s_.subgroup_size / word_bits) |= Word{1}
                                                                << (lane % s_.subgroup_size % word_bits);
        Values result;
        for (const Word word : mask) result.push_back(Value<N>::of_bits(word));
        return result;
    }

    [[nodiscard]] bool all_equal() const {
        return std::ranges::all_of(lanes_, [&](std::uint32_t lane) {
            for (std::uint32_t k = 0; k < i_.stride; ++k) {
                const Value<N>& one = slots(lane)[i_.a + k];
                const Value<N>& first = slots(lanes_.front())[i_.a + k];
                const bool equal = one.is_number() || first.is_number()
                                       ? apply(Equal{}, one.number(), first.number())
                                       : one.bits() == first.bits();
                if (!equal) return false;
            }
            return true;
        });
    }

    // Of the ballot in a lane's operand.
    [[nodiscard]] Word of_ballot(std::uint32_t lane) const {
        const std::uint32_t own = lane % s_.subgroup_size;
        const auto has = [&](std::uint32_t bit) {
            return (slots(lane)[i_.a + bit / word_bits].bits() >> (bit % word_bits) & 1U) != 0;
        };
        Word count = 0;
        Word lowest = ~Word{0};
        Word highest = ~Word{0};
        for (std::uint32_t bit = 0; bit < s_.subgroup_size; ++bit) {
            if (!has(bit)) continue;
            const bool counts = i_.extra == SpvGroupOperationReduce || bit < own ||
                                (i_.extra == SpvGroupOperationInclusiveScan && bit == own);
            if (counts) ++count;
            lowest = std::min(lowest, bit);
            highest = bit;
        }
        switch (i_.c) {
            case SpvOpGroupNonUniformInverseBallot:
                return has(own) ? 1 : 0;
            case SpvOpGroupNonUniformBallotBitExtract:
                return has(slots(lane)[i_.b].bits() % s_.subgroup_size) ? 1 : 0;
            case SpvOpGroupNonUniformBallotBitCount:
                return count;
            default:
                return i_.c == SpvOpGroupNonUniformBallotFindLSB ? lowest : highest;
        }
    }

    [[nodiscard]] Values reduction(std::uint32_t lane) const {
        const bool clustered = i_.extra == SpvGroupOperationClusteredReduce;
        const std::uint32_t cluster =
            clustered ? std::max(slots(lane)[i_.b].bits(), Word{1}) : s_.subgroup_size;
        const auto takes = [&](std::uint32_t other) {
            if (i_.extra == SpvGroupOperationInclusiveScan) return other <= lane;
            if (i_.extra == SpvGroupOperationExclusiveScan) return other < lane;
            return other / cluster == lane / cluster;
        };
        Values result;
        for (std::uint32_t k = 0; k < i_.count; ++k) {
            Values all;
            for (const std::uint32_t other : lanes_)
                if (takes(other)) all.push_back(slots(other)[i_.a + k]);
            result.push_back(reduced(i_.c, all));
        }
        return result;
    }

    [[nodiscard]] Values collected(std::uint32_t lane) const {
        const std::int64_t own = lane % s_.subgroup_size;
        const auto operand = [&] { return std::int64_t{slots(lane)[i_.b].bits()}; };
        const auto any = [&](bool wanted) {
            return std::ranges::any_of(
                lanes_, [&](std::uint32_t other) { return (slots(other)[i_.a].bits() != 0) == wanted; });
        };
        const auto one = [](Word word) { return Values{Value<N>::of_bits(word)}; };
        switch (i_.c) {
            case SpvOpGroupNonUniformElect:
                return one(lane == lanes_.front() ? 1 : 0);
            case SpvOpGroupNonUniformAll:
                return one(any(false) ? 0 : 1);
            case SpvOpGroupNonUniformAny:
                return one(any(true) ? 1 : 0);
            case SpvOpGroupNonUniformAllEqual:
                return one(all_equal() ? 1 : 0);
            case SpvOpGroupNonUniformBroadcastFirst:
                return of(lanes_.front() % s_.subgroup_size);
            case SpvOpGroupNonUniformBroadcast:
            case SpvOpGroupNonUniformShuffle:
                return of(operand());
            case SpvOpGroupNonUniformShuffleXor:
                return of(own ^ operand());
            case SpvOpGroupNonUniformShuffleUp:
                return of(own - operand());
            case SpvOpGroupNonUniformShuffleDown:
                return of(own + operand());
            case SpvOpGroupNonUniformQuadBroadcast:
                return of(own / 4 * 4 + operand() % 4);
            case SpvOpGroupNonUniformQuadSwap:
                return of(own ^ (operand() % 3 + 1));
            case SpvOpGroupNonUniformBallot:
                return ballot();
            default:
                return i_.c <= SpvOpGroupNonUniformBallotFindMSB ? one(of_ballot(lane)) : reduction(lane);
        }
    }

    State<N>& s_;
    std::vector<std::uint32_t> lanes_;  // in ascending order
    const Instruction& i_;
};

// Whether a lane waits at an earlier place than another: in an earlier iteration, or before it in the code.
// At a group's barrier it waits for all that others wait for.
template <class N>
[[nodiscard]] bool waits_before(const State<N>& s, const Lane<N>& one, const Lane<N>& other) {
    const auto waits_for_group = [&](const Lane<N>& lane) {
        const Instruction& i = s.code.instructions[lane.next - 1];
        return i.op == barrier && i.extra != SpvScopeSubgroup;
    };
    if (waits_for_group(one) != waits_for_group(other)) return waits_for_group(other);
    return one.way.is_before(other.way).value_or(one.next < other.next);
}

// Those of the lanes that wait for each other at one dynamic instance of an instruction: the earliest, so
// that lanes on different ways come together again. Empty: none waits.
template <class N>
[[nodiscard]] std::vector<std::uint32_t> next_meeting(const State<N>& s) {
    const Lane<N>* first = nullptr;
    for (const Lane<N>& lane : s.lanes)
        if (lane.progress == Lane<N>::Progress::waits && (first == nullptr || waits_before(s, lane, *first)))
            first = &lane;
    std::vector<std::uint32_t> together;
    if (first == nullptr) return together;
    const Instruction& i = s.code.instructions[first->next - 1];
    const bool of_group = i.op == barrier && i.extra != SpvScopeSubgroup;
    const auto subgroup_of = [&](const Lane<N>& lane) {
        return static_cast<std::uint32_t>(&lane - s.lanes.data()) / s.subgroup_size;
    };
    for (const Lane<N>& lane : s.lanes) {
        const bool here = lane.progress == Lane<N>::Progress::waits && lane.next == first->next &&
                          lane.way.path() == first->way.path();
        if (here && (of_group || subgroup_of(lane) == subgroup_of(*first)))
            together.push_back(static_cast<std::uint32_t>(&lane - s.lanes.data()));
    }
    return together;
}

// A barrier is reached by all or by none.
template <class N>
void pass_barrier(State<N>& s, const std::vector<std::uint32_t>& lanes, const Instruction& i) {
    const bool of_group = i.extra != SpvScopeSubgroup;
    std::uint32_t semantics = ~std::uint32_t{0};
    for (std::uint32_t l = 0; of_group && l < s.lanes.size(); ++l) {
        const Lane<N>& lane = s.lanes[l];
        semantics &= lane.fenced;
        if (std::ranges::find(lanes, l) != lanes.end()) continue;
        const bool ended = lane.progress == Lane<N>::Progress::ended;
        throw Fault{
            Error::Kind::divergent_barrier,
            fmt::format(
                "a barrier at which invocation {} waits and which invocation {} does not reach: it {}",
                lanes.front(), l,
                ended ? std::string("ended")
                : lane.next == s.lanes[lanes.front()].next
                    ? std::string("waits there in another iteration")
                    : "waits at " + to_text(s.code.places[s.code.instructions[lane.next - 1].place]))};
    }
    if (s.races && of_group) s.races->group_barrier(semantics | i.c);
    if (s.races && !of_group) s.races->subgroup_barrier(lanes.front() / s.subgroup_size);
    for (const std::uint32_t lane : lanes) {
        s.lanes[lane].progress = Lane<N>::Progress::runs;
        if (of_group) s.lanes[lane].fenced = 0;
    }
}

// Lets lanes that wait go on: they execute the instruction before their next one. False where all have ended.
template <class N>
bool meet(State<N>& s) {
    const std::vector<std::uint32_t> lanes = next_meeting(s);
    if (lanes.empty()) return false;
    s.at = s.lanes[lanes.front()].next - 1;
    const Instruction& i = s.code.instructions[s.at];
    if (i.op == barrier) {
        pass_barrier(s, lanes, i);
    } else {
        Meeting<N>(s, lanes).hold();
    }
    return true;
}

}  // namespace gloam::interpreter::internal
