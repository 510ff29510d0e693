// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "interpreter/internal/group.hpp"
#include "interpreter/internal/operations.hpp"

// The implementation of the machine; each number type is instantiated in a source of its own.
namespace gloam::interpreter {
namespace internal {

template <class N>
inline constexpr bool has_intervals = !std::is_floating_point_v<N>;

// The format of an instruction's floats.
[[nodiscard]] inline const numeric::FloatFormat& format_of(std::uint8_t how) {
    return (how & (flags::relaxed | flags::half)) != 0 ? numeric::float16 : numeric::float32;
}

// A word of a built-in variable.
[[nodiscard]] inline Word built_in_word(const Invocation& at, std::uint32_t built_in, std::uint32_t k) {
    const Word index = (at.local[2] * at.group_size[1] + at.local[1]) * at.group_size[0] + at.local[0];
    const Word in_subgroup = index % at.subgroup_size;
    const Word count = at.group_size[0] * at.group_size[1] * at.group_size[2];
    // Of the invocations of a subgroup, those for which this holds.
    const auto mask = [&](auto holds) {
        Word word = 0;
        for (Word bit = 0; bit < word_bits; ++bit)
            if (k * word_bits + bit < at.subgroup_size && holds(k * word_bits + bit)) word |= Word{1} << bit;
        return word;
    };
    switch (built_in) {
        case SpvBuiltInGlobalInvocationId:
            return at.group.at(k) * at.group_size.at(k) + at.local.at(k);
        case SpvBuiltInWorkgroupId:
            return at.group.at(k);
        case SpvBuiltInLocalInvocationId:
            return at.local.at(k);
        case SpvBuiltInLocalInvocationIndex:
            return index;
        case SpvBuiltInNumWorkgroups:
            return at.groups.at(k);
        case SpvBuiltInWorkgroupSize:
            return at.group_size.at(k);
        case SpvBuiltInFragCoord:
            return std::bit_cast<Word>(
                k < 2 ? static_cast<float>(at.group.at(k) * at.group_size.at(k) + at.local.at(k)) + 0.5F
                      : static_cast<float>(k - 2));
        case SpvBuiltInSubgroupSize:
            return at.subgroup_size;
        case SpvBuiltInNumSubgroups:
            return (count + at.subgroup_size - 1) / at.subgroup_size;
        case SpvBuiltInSubgroupId:
            return index / at.subgroup_size;
        case SpvBuiltInSubgroupLocalInvocationId:
            return in_subgroup;
        case SpvBuiltInSubgroupEqMask:
            return mask([&](Word bit) { return bit == in_subgroup; });
        case SpvBuiltInSubgroupGeMask:
            return mask([&](Word bit) { return bit >= in_subgroup; });
        case SpvBuiltInSubgroupGtMask:
            return mask([&](Word bit) { return bit > in_subgroup; });
        case SpvBuiltInSubgroupLeMask:
            return mask([&](Word bit) { return bit <= in_subgroup; });
        case SpvBuiltInSubgroupLtMask:
            return mask([&](Word bit) { return bit < in_subgroup; });
        default:
            return 0;
    }
}

}  // namespace internal

template <class N>
Machine<N>::Machine(const Program& program)
    : program_(program),
      state_(new internal::State<N>{.code = program_.code()},
             [](internal::State<N>* state) { delete state; }) {
    const internal::Code& code = program_.code();
    state_->slots.resize(code.slots);
    state_->pointers = code.pointers;
    state_->backings.resize(code.resources.size());
    state_->moving.resize(code.most_copies);
    for (const internal::Resource& resource : code.resources)
        state_->shared.resize(std::max<std::size_t>(state_->shared.size(), resource.shared_words));
    for (std::size_t r = 0; r < code.resources.size(); ++r) {
        const std::uint32_t words = code.resources[r].shared_words;
        state_->backings[r].values.resize(words);
        state_->backings[r].words = std::span(state_->shared).first(words);
    }
    for (const internal::ConstantSlot& constant : code.constants)
        state_->slots[constant.slot] =
            constant.is_float ? Value<N>::of_float(constant.bits) : Value<N>::of_bits(constant.bits);
    for (const internal::Instruction& i : code.instructions) {
        state_->handlers.push_back(internal::handler_of<N>(i));
        if (state_->handlers.back() == nullptr)
            throw Error(Error::Kind::unknown_instruction, internal::name_of(i.op), code.places[i.place]);
    }
}

namespace internal {

template <class N>
void set_built_ins(const Code& code, const Invocation& at, std::span<Value<N>> slots) {
    for (const BuiltIn& built_in : code.built_ins)
        for (std::uint32_t k = 0; k < built_in.count; ++k) {
            const Word word = built_in_word(at, built_in.built_in, k);
            slots[built_in.slot + k] =
                built_in.built_in == SpvBuiltInFragCoord ? Value<N>::of_float(word) : Value<N>::of_bits(word);
        }
}

// Calls act(resource, its contents) for each resource at a binding.
template <class N, class Act>
void for_each_at(State<N>& s, std::uint32_t set, std::uint32_t binding, const Act& act) {
    for (std::size_t r = 0; r < s.backings.size(); ++r)
        if (s.code.resources[r].is_at(set, binding)) act(s.code.resources[r], s.backings[r]);
}

}  // namespace internal

template <class N>
void Machine<N>::bind(std::uint32_t set, std::uint32_t binding, std::span<const Word> words) {
    internal::for_each_at(*state_, set, binding, [&](const auto& resource, auto& backing) {
        backing.words = words;
        backing.values.clear();
        backing.dirty.clear();
        for (std::size_t w = 0; resource.written && w < words.size(); ++w)
            backing.values.push_back(Value<N>::of_bits(words[w]));
    });
}

template <class N>
void Machine<N>::bind(std::uint32_t set, std::uint32_t binding, const ImageView& image) {
    const std::size_t texels = std::size_t{image.size[0]} * image.size[1] * image.size[2];
    if (texels * 4 != image.texels.size())
        throw Error(Error::Kind::malformed, "an image whose size and texels disagree");
    bind(set, binding, image.texels);
    internal::for_each_at(*state_, set, binding, [&](const auto&, auto& backing) { backing.image = image; });
}

template <class N>
void Machine<N>::bind(std::uint32_t set, std::uint32_t binding, const SampledView& image) {
    internal::for_each_at(*state_, set, binding, [&](const auto& resource, auto& backing) {
        if (resource.kind == internal::Resource::Kind::image) backing.sampled = image;
    });
}

template <class N>
void Machine<N>::bind_push_constants(std::span<const Word> words) {
    for (std::size_t r = 0; r < state_->backings.size(); ++r)
        if (state_->code.resources[r].is_push_constant) state_->backings[r].words = words;
}

template <class N>
void Machine<N>::set_invocation(const Invocation& invocation) {
    state_->lanes.clear();
    state_->races.reset();
    internal::set_built_ins<N>(state_->code, invocation, state_->slots);
}

template <class N>
void Machine<N>::set_group(const Invocation& first, Order order) {
    const auto& size = first.group_size;
    const std::uint64_t count = std::uint64_t{size[0]} * size[1] * size[2];
    if (count == 0 || count > most_invocations || first.subgroup_size == 0)
        throw Error(Error::Kind::malformed,
                    fmt::format("a group of {} invocations, expected 1 to {}", count, most_invocations));
    if (state_->lanes.size() != count) {
        // Constants are in the slots of each.
        state_->lanes.assign(count, {.slots = state_->slots, .pointers = state_->pointers});
        state_->races.emplace(state_->code, static_cast<std::uint32_t>(count), first.subgroup_size);
    }
    state_->subgroup_size = first.subgroup_size;
    state_->order = order;
    Invocation at = first;
    for (std::uint32_t lane = 0; lane < count; ++lane) {
        at.local = {lane % size[0], lane / size[0] % size[1], lane / size[0] / size[1]};
        internal::set_built_ins<N>(state_->code, at, state_->lanes[lane].slots);
    }
}

namespace internal {

template <class N>
void prepare(State<N>& s) {
    for (std::size_t r = 0; r < s.backings.size(); ++r) {
        Backing<N>& backing = s.backings[r];
        const bool shared = s.code.resources[r].shared_words > 0;
        for (const std::uint32_t word : backing.dirty)
            backing.values[word] = shared ? Value<N>() : Value<N>::of_bits(backing.words[word]);
        backing.dirty.clear();
    }
    s.next = 0;
    s.cost = 0;
    s.at = 0;
    s.end = s.steps + s.limit;
    s.running = true;
    s.waits = false;
    s.undefinedness = {};
    for (Lane<N>& lane : s.lanes) {
        lane.next = 0;
        lane.way = {};
        lane.fenced = 0;
        lane.progress = Lane<N>::Progress::runs;
    }
    if (s.races) s.races->begin();
    s.format = 0;
    if constexpr (has_intervals<N>) numeric::Paths::set_format(numeric::float32);
    if (s.sampling) numeric::Paths::draw_wholes(*s.sampling);
}

// Runs an invocation until it ends or waits. tell(instruction) hears of each, after it.
template <class N, class Tell>
void step(State<N>& s, const Tell& tell) {
    const Instruction* const code = s.code.instructions.data();
    const std::uint64_t end = s.end;
    for (; s.running; ++s.steps) {
        s.steps += std::exchange(s.cost, 0);
        if (s.steps >= end)
            throw Fault{Error::Kind::too_many_steps, fmt::format("more than {} instructions", s.limit)};
        s.at = s.next++;
        const Instruction& i = code[s.at];
        if constexpr (has_intervals<N>) {
            constexpr std::uint8_t all = flags::relaxed | flags::half;
            const auto wanted = static_cast<std::uint8_t>(i.flags & all);
            if (wanted != s.format) numeric::Paths::set_format(format_of(wanted));
            s.format = wanted;
        }
        s.handlers[s.at](s, i);
        if (s.undefinedness.touched) s.forget_touched();
        tell(i);
    }
}

template <class N, class Tell>
void execute_group(State<N>& s, const Tell& tell) {
    const auto count = static_cast<std::uint32_t>(s.lanes.size());
    do {
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t lane = s.order == Order::forward ? k : count - 1 - k;
            if (s.lanes[lane].progress != Lane<N>::Progress::runs) continue;
            enter(s, lane);
            try {
                step(s, tell);
            } catch (...) {
                leave(s);  // a fault must not leave an invocation's values in the place of the group's
                throw;
            }
            leave(s);
        }
    } while (meet(s));
}

template <class N, class Tell>
void execute(State<N>& s, const Tell& tell) {
    prepare(s);
    try {
        if (!s.lanes.empty()) return execute_group(s, tell);
        do {
            s.running = true;
            step(s, tell);
            if (s.waits && s.code.instructions[s.at].op != barrier)
                throw Fault{Error::Kind::unknown_instruction,
                            "an operation of several invocations, and there is one"};
        } while (std::exchange(s.waits, false));
    } catch (const Fault& fault) {
        throw Error(fault.kind, fault.message, s.code.places[s.code.instructions[s.at].place]);
    }
}

}  // namespace internal

template <class N>
void Machine<N>::set_limit(std::uint64_t steps) {
    state_->limit = steps;
}

template <class N>
std::uint64_t Machine<N>::steps() const {
    return state_->steps;
}

template <class N>
void Machine<N>::set_sampling(std::uint64_t seed) {
    state_->sampling = numeric::Random(seed);
}

template <class N>
void Machine<N>::run() {
    internal::execute(*state_, [](const internal::Instruction&) {});
}

template <class N>
void Machine<N>::run(const std::function<void(const Step<N>&)>& tell) {
    internal::execute(*state_, [&](const internal::Instruction& i) {
        // Others move existing values, or wait.
        if (i.op >= internal::copy && i.op != internal::image_sample) return;
        tell({.place = state_->code.places[i.place],
              .opcode = i.op,
              .results = std::span<const Value<N>>(state_->slots).subspan(i.result, internal::results_of(i)),
              .format = internal::format_of(i.flags & ~internal::flags::relaxed)});
    });
}

template <class N>
void Machine<N>::run(Coverage& coverage) {
    internal::execute(*state_, [&](const internal::Instruction& i) {
        const auto at = static_cast<std::size_t>(&i - state_->code.instructions.data());
        if (i.op != internal::select) return coverage.add(at, state_->next);
        for (std::uint32_t k = 0; k < (i.stride == 0 ? 1 : i.count); ++k)
            coverage.add(at, state_->bits(i.a + k) != 0 ? 1 : 0);
    });
}

template <class N>
std::optional<Undefined> Machine<N>::why_undefined(const Value<N>& value) const {
    return value.is_undefined() ? std::optional(state_->why_undefined(value.origin())) : std::nullopt;
}

template <class N>
void Machine<N>::keep_writes(std::uint32_t set, std::uint32_t binding,
                             const std::function<Word(std::size_t, Word)>& keep) {
    internal::for_each_at(*state_, set, binding, [&](const auto&, auto& backing) {
        for (const std::uint32_t word : backing.dirty)
            backing.values[word] = Value<N>::of_bits(keep(word, backing.values[word].bits()));
        backing.dirty.clear();
    });
}

template <class N>
Value<N> Machine<N>::read(std::uint32_t set, std::uint32_t binding, std::size_t word) const {
    std::optional<Value<N>> found;
    internal::for_each_at(*state_, set, binding, [&](const auto&, const auto& backing) {
        if (found) return;
        if (word >= backing.words.size())
            throw Error(Error::Kind::out_of_bounds, fmt::format("word {} of {}", word, backing.words.size()));
        found = backing.values.empty() ? Value<N>::of_bits(backing.words[word]) : backing.values[word];
    });
    if (found) return *found;
    throw Error(Error::Kind::missing,
                fmt::format("the program has no buffer at set {}, binding {}", set, binding));
}

}  // namespace gloam::interpreter
