// SPDX-License-Identifier: MIT
#pragma once

#include "interpreter/internal/opcodes.hpp"

#include "interpreter/internal/conversions.hpp"
#include "interpreter/internal/integers.hpp"
#include "interpreter/internal/samplers.hpp"

// Copies, branches, memory and images.
namespace gloam::interpreter::internal {

// Relaxed copies are numeric operations: a load may reduce precision.
template <class N>
void copy_slots(State<N>& s, const Instruction& i, Slot from) {
    if ((i.flags & flags::relaxed) == 0) {
        std::copy_n(s.slots.begin() + from, i.count, s.slots.begin() + i.result);
        return;
    }
    for (std::uint32_t k = 0; k < i.count; ++k) {
        if (s.slots[from + k].is_undefined())
            s.slots[i.result + k] = s.slots[from + k];
        else
            s.set(i, i.result + k, s.number(i, from + k));
    }
}

template <class N>
void do_to_float(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const Value<N>& from = s.slots[i.a + k];
        s.slots[i.result + k] = from.is_bits() ? Value<N>::of_float(from.bits()) : from;
    }
}

template <class N>
void do_gather(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) s.slots[i.result + k] = s.slots[s.code.lists[i.extra + k]];
}

template <class N>
void do_undefine(State<N>& s, const Instruction& i) {
    std::fill_n(s.slots.begin() + i.result, i.count, Value<N>::undefined(s.next));
}

template <class N>
void do_select(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const Slot condition = i.a + k * i.stride;
        if (s.touch(condition))
            s.set(i, i.result + k, Word{0});
        else
            s.slots[i.result + k] = s.slots[(s.bits(condition) != 0 ? i.b : i.c) + k];
    }
}

[[nodiscard]] inline std::uint32_t checked(Word index, std::uint32_t count) {
    if (index >= count)
        throw Fault{Error::Kind::out_of_bounds, fmt::format("element {} of {}", as_int(index), count)};
    return index;
}

template <class N>
void do_extract(State<N>& s, const Instruction& i) {
    s.slots[i.result] = s.slots[i.a + checked(s.known_bits(i.b), i.count)];
}

template <class N>
void do_insert(State<N>& s, const Instruction& i) {
    const std::uint32_t index = checked(s.known_bits(i.c), i.count);
    std::copy_n(s.slots.begin() + i.a, i.count, s.slots.begin() + i.result);
    s.slots[i.result + index] = s.slots[i.b];
}

template <class N>
void do_construct(State<N>& s, const Instruction& i) {
    if (s.lanes.empty()) return;
    s.way.enter(s.code.edges[i.extra].target, i.b == 0 ? 0 : s.code.edges[i.b - 1].target);
}

template <class N>
void follow(State<N>& s, std::uint32_t number) {
    const Edge& edge = s.code.edges[number];
    if (!s.lanes.empty()) s.way.take(number, edge.target);
    s.next = edge.target;
    if (edge.through_memory) {
        auto to = s.moving.begin();
        for (const Edge::Copy& part : edge.copies)
            to = std::copy_n(s.slots.begin() + part.from, part.count, to);
        auto from = s.moving.begin();
        for (const Edge::Copy& part : edge.copies) {
            std::copy_n(from, part.count, s.slots.begin() + part.to);
            from += part.count;
        }
        return;
    }
    for (const Edge::Copy& part : edge.copies)
        std::copy_n(s.slots.begin() + part.from, part.count, s.slots.begin() + part.to);
}

template <class N>
void do_switch(State<N>& s, const Instruction& i) {
    const Switch& all = s.code.switches[i.extra];
    const Word value = s.known_bits(i.a);
    for (const auto& [literal, edge] : all.cases)
        if (literal == value) return follow(s, edge);
    follow(s, all.otherwise);
}

template <class N>
void do_chain(State<N>& s, const Instruction& i) {
    const Chain& all = s.code.chains[i.extra];
    Pointer at = all.base;
    if (!all.from_static) {
        at = s.pointers[all.from];
        at.offset += all.base.offset;
    }
    for (const Chain::Step& step : all.steps) {
        const Word index = s.known_bits(step.index);
        const bool outside = step.length != 0 ? index >= step.length : step.is_signed && as_int(index) < 0;
        const std::uint64_t offset = at.offset + std::uint64_t{index} * step.stride;
        if (outside || offset > 0xffffffffU)
            throw Fault{Error::Kind::out_of_bounds,
                        step.is_signed ? fmt::format("element {} of {}", as_int(index), step.length)
                                       : fmt::format("element {} of {}", index, step.length)};
        at.offset = static_cast<std::uint32_t>(offset);
    }
    s.pointers[i.result] = at;
}

// A scalar behind a pointer. An odd offset means a 16-bit float.
template <class N>
[[nodiscard]] Value<N> load_scalar(const State<N>& s, const Pointer& pointer, std::uint32_t offset) {
    const Value<N> word = s.read(pointer, offset);
    if ((offset & 1U) == 0 || word.is_undefined()) return word;
    const Word half = word.bits() >> (((pointer.offset + offset) & 2U) * 8U) & 0xffffU;
    return Value<N>::of_float(float_of_half(half));
}

template <class N>
void store_scalar(State<N>& s, const Pointer& pointer, std::uint32_t offset, const Value<N>& value) {
    if ((offset & 1U) == 0 || value.is_undefined()) return s.write(pointer, offset, value);
    const Word shift = ((pointer.offset + offset) & 2U) * 8U;
    const Word others = s.read(pointer, offset).bits() & ~(0xffffU << shift);
    s.write(pointer, offset, Value<N>::of_bits(others | apply(HalfBits{}, value.number()) << shift));
}

template <class N>
void do_load_memory(State<N>& s, const Instruction& i) {
    const Pointer& pointer = s.pointers[i.a];
    for (std::uint32_t k = 0; k < i.count; ++k)
        s.slots[i.result + k] = load_scalar(s, pointer, s.code.lists[i.extra + k]);
    if ((i.flags & flags::relaxed) != 0) copy_slots(s, i, i.result);
}

template <class N>
void do_store_memory(State<N>& s, const Instruction& i) {
    const Pointer& pointer = s.pointers[i.a];
    for (std::uint32_t k = 0; k < i.count; ++k)
        store_scalar(s, pointer, s.code.lists[i.extra + k], s.slots[i.b + k]);
}

template <class N>
void do_array_length(State<N>& s, const Instruction& i) {
    const Pointer& pointer = s.pointers[i.a];
    const std::size_t bytes = s.backings[pointer.resource].words.size() * sizeof(Word);
    const std::size_t behind = bytes > pointer.offset ? bytes - pointer.offset : 0;
    s.set(i, i.result, static_cast<Word>(i.extra == 0 ? 0 : behind / i.extra));
}

// On a resource if count is 1, otherwise on a variable.
template <class N>
void do_atomic(State<N>& s, const Instruction& i) {
    const Pointer& pointer = s.pointers[i.a];
    const bool shared = i.count == 1 && s.races;
    const Value<N> before = i.count == 1 ? s.read(pointer, 0, Races::Use::atomic) : s.slots[pointer.offset];
    if (i.c != SpvOpAtomicLoad) {
        const bool compares = i.c == SpvOpAtomicCompareExchange;
        const bool moves = i.c == SpvOpAtomicStore || i.c == SpvOpAtomicExchange;
        // The last of several decides, and their order is free.
        const bool free = shared && (moves || compares) && s.races->is_contended(s.where(pointer), s.lane);
        const Value<N> after =
            free && has_bounds<N> ? Value<N>()
            : moves               ? s.slots[i.b]
                                  : Value<N>::of_bits(exchanged(
                          i.c, before.bits(),
                          i.c == SpvOpAtomicIIncrement || i.c == SpvOpAtomicIDecrement ? 0U : s.bits(i.b),
                          compares ? s.bits(i.extra) : 0U));
        if (i.count == 1)
            s.write(pointer, 0, after, Races::Use::atomic);
        else
            s.slots[pointer.offset] = after;
    }
    // Which invocation comes first is free.
    const bool free = shared && has_bounds<N> && (i.flags & flags::result_is_used) != 0;
    s.slots[i.result] = free ? Value<N>() : before;
}

// One of two numbers, whichever a driver takes.
template <class N>
void do_either(State<N>& s, const Instruction& i) {
    const auto hull = [](const numeric::Interval& a, const numeric::Interval& b) {
        return numeric::Interval::within(numeric::hull(a.bounds(), b.bounds()));
    };
    for (std::uint32_t k = 0; k < i.count; ++k)
        s.set(i, i.result + k, with_permitted(hull, s.number(i, i.a + k), s.number(i, i.b + k)));
}

// Index of the first word of the texel at the coordinates.
template <class N>
[[nodiscard]] Pointer texel(State<N>& s, Word resource, Slot coordinates, std::uint32_t dimensions) {
    const Backing<N>& backing = s.backings.at(resource);
    if (!backing.image)
        throw Fault{Error::Kind::missing,
                    fmt::format("no image is bound to \"{}\"", s.code.resources[resource].name)};
    std::array<Word, 3> at{};
    std::size_t index = 0;
    for (std::uint32_t k = 3; k-- > 0;) {
        at.at(k) = k < dimensions ? s.known_bits(coordinates + k) : 0U;
        if (at.at(k) >= backing.image->size.at(k))
            throw Fault{Error::Kind::out_of_bounds,
                        fmt::format("texel {} of the {} of \"{}\" (dimension {})", as_int(at.at(k)),
                                    backing.image->size.at(k), s.code.resources[resource].name, k)};
        index = index * backing.image->size.at(k) + at.at(k);
    }
    return {resource, static_cast<std::uint32_t>(index * 4 * sizeof(Word))};
}

template <class N>
void require_first_level(State<N>& s, const Instruction& i) {
    if (i.extra != 0 && s.known_bits(i.extra - 1) != 0)
        throw Fault{Error::Kind::out_of_bounds, "a level of an image that has one"};
}

template <class N>
void do_image_load(State<N>& s, const Instruction& i) {
    if (const auto& sampled = s.backings.at(s.bits(i.a)).sampled) return fetch_sampled(s, i, *sampled);
    require_first_level(s, i);
    const Pointer at = texel(s, s.bits(i.a), i.b, i.c);
    for (std::uint32_t k = 0; k < i.count; ++k)
        s.slots[i.result + k] = s.read(at, k * static_cast<std::uint32_t>(sizeof(Word)));
    if ((i.flags & flags::relaxed) != 0) copy_slots(s, i, i.result);
}

template <class N>
void do_image_store(State<N>& s, const Instruction& i) {
    const Pointer at = texel(s, s.bits(i.a), i.b, i.extra);
    for (std::uint32_t k = 0; k < i.count; ++k)
        s.write(at, k * static_cast<std::uint32_t>(sizeof(Word)), s.slots[i.c + k]);
}

template <class N>
void do_image_texel(State<N>& s, const Instruction& i) {
    s.pointers[i.result] = texel(s, s.pointers[i.a].resource, i.b, i.c);
}

template <class N>
void do_image_size(State<N>& s, const Instruction& i) {
    if (const auto& sampled = s.backings.at(s.bits(i.a)).sampled) return size_of_sampled(s, i, *sampled);
    require_first_level(s, i);
    const Backing<N>& backing = s.backings.at(s.bits(i.a));
    if (!backing.image) throw Fault{Error::Kind::missing, "no image is bound"};
    for (std::uint32_t k = 0; k < i.count; ++k) s.set(i, i.result + k, Word{backing.image->size.at(k)});
}

}  // namespace gloam::interpreter::internal
