// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "interpreter/internal/code.hpp"
#include "interpreter/internal/control.hpp"
#include "interpreter/internal/conversions.hpp"
#include "interpreter/internal/vectors.hpp"

// The implementation of the machine; each number type is instantiated in a source of its own.
namespace gloam::interpreter {
namespace internal {

template <class N>
Handler<N> handler_of(const Instruction& i) {
    if (i.op >= copy) return control_handler<N>(i);
    for (const auto find :
         {arithmetic_handler<N>, comparison_handler<N>, integer_arithmetic_handler<N>,
          integer_comparison_handler<N>, vector_handler<N>, conversion_handler<N>, matrix_handler<N>})
        if (const Handler<N> found = find(i.op)) return found;
    if (i.op < extended) return nullptr;
    const auto function = static_cast<std::uint16_t>(i.op - extended);
    const Handler<N> found = elementary_handler<N>(function);
    return found != nullptr ? found : integer_function_handler<N>(function);
}

template <class N>
inline constexpr bool has_intervals = !std::is_floating_point_v<N>;

}  // namespace internal

template <class N>
Machine<N>::Machine(const Program& program)
    : program_(program), state_(new internal::State<N>{.code = program_.code()}) {
    const internal::Code& code = program_.code();
    state_->slots.resize(code.slots);
    state_->pointers = code.pointers;
    state_->backings.resize(code.resources.size());
    state_->moving.resize(code.most_copies);
    for (const internal::ConstantSlot& constant : code.constants)
        state_->slots[constant.slot] =
            constant.is_float ? Value<N>::of_float(constant.bits) : Value<N>::of_bits(constant.bits);
    for (const internal::Instruction& i : code.instructions) {
        state_->handlers.push_back(internal::handler_of<N>(i));
        if (state_->handlers.back() == nullptr)
            throw Error(Error::Kind::unknown_instruction, internal::name_of(i.op), code.places[i.place]);
    }
}

template <class N>
Machine<N>::~Machine() = default;
template <class N>
Machine<N>::Machine(Machine&&) noexcept = default;
template <class N>
Machine<N>& Machine<N>::operator=(Machine&&) noexcept = default;

template <class N>
void Machine<N>::bind(std::uint32_t set, std::uint32_t binding, std::span<const Word> words) {
    for (std::size_t r = 0; r < state_->backings.size(); ++r) {
        const internal::Resource& resource = state_->code.resources[r];
        if (resource.is_push_constant || resource.set != set || resource.binding != binding) continue;
        internal::Backing<N>& backing = state_->backings[r];
        backing.words = words;
        backing.values.clear();
        backing.dirty.clear();
        for (std::size_t w = 0; resource.written && w < words.size(); ++w)
            backing.values.push_back(Value<N>::of_bits(words[w]));
    }
}

template <class N>
void Machine<N>::bind(std::uint32_t set, std::uint32_t binding, const ImageView& image) {
    const std::size_t texels = std::size_t{image.size[0]} * image.size[1] * image.size[2];
    if (texels * 4 != image.texels.size())
        throw Error(Error::Kind::malformed, "an image whose size and texels disagree");
    bind(set, binding, image.texels);
    for (std::size_t r = 0; r < state_->backings.size(); ++r) {
        const internal::Resource& resource = state_->code.resources[r];
        if (!resource.is_push_constant && resource.set == set && resource.binding == binding)
            state_->backings[r].image = image;
    }
}

template <class N>
void Machine<N>::bind(std::uint32_t set, std::uint32_t binding, const SampledView& image) {
    for (std::size_t r = 0; r < state_->backings.size(); ++r) {
        const internal::Resource& resource = state_->code.resources[r];
        if (resource.kind == internal::Resource::Kind::image && resource.set == set &&
            resource.binding == binding)
            state_->backings[r].sampled = image;
    }
}

template <class N>
void Machine<N>::bind_push_constants(std::span<const Word> words) {
    for (std::size_t r = 0; r < state_->backings.size(); ++r)
        if (state_->code.resources[r].is_push_constant) state_->backings[r].words = words;
}

template <class N>
void Machine<N>::set_invocation(const Invocation& at) {
    const auto value = [&at](std::uint32_t built_in, std::uint32_t k) -> Word {
        switch (built_in) {
            case SpvBuiltInGlobalInvocationId:
                return at.group.at(k) * at.group_size.at(k) + at.local.at(k);
            case SpvBuiltInWorkgroupId:
                return at.group.at(k);
            case SpvBuiltInLocalInvocationId:
                return at.local.at(k);
            case SpvBuiltInLocalInvocationIndex:
                return (at.local[2] * at.group_size[1] + at.local[1]) * at.group_size[0] + at.local[0];
            case SpvBuiltInNumWorkgroups:
                return at.groups.at(k);
            case SpvBuiltInWorkgroupSize:
                return at.group_size.at(k);
            default:
                return 0;
        }
    };
    for (const internal::BuiltIn& built_in : state_->code.built_ins)
        for (std::uint32_t k = 0; k < built_in.count; ++k)
            state_->slots[built_in.slot + k] = Value<N>::of_bits(value(built_in.built_in, k));
}

template <class N>
void Machine<N>::prepare() {
    for (internal::Backing<N>& backing : state_->backings) {
        for (const std::uint32_t word : backing.dirty)
            backing.values[word] = Value<N>::of_bits(backing.words[word]);
        backing.dirty.clear();
    }
    state_->next = 0;
    state_->cost = 0;
    state_->running = true;
}

template <class N>
template <class Tell>
void Machine<N>::execute(Tell&& tell) {
    prepare();
    internal::State<N>& s = *state_;
    const internal::Instruction* const code = s.code.instructions.data();
    std::uint32_t at = 0;
    const std::uint64_t end = steps_ + limit_;
    [[maybe_unused]] bool half = false;
    if constexpr (internal::has_intervals<N>) numeric::Paths::set_format(numeric::float32);
    try {
        for (; s.running; ++steps_) {
            steps_ += std::exchange(s.cost, 0);
            if (steps_ >= end)
                throw internal::Fault{Error::Kind::too_many_steps,
                                      fmt::format("more than {} instructions", limit_)};
            at = s.next++;
            const internal::Instruction& i = code[at];
            if constexpr (internal::has_intervals<N>) {
                const bool wants_half = (i.flags & (internal::flags::relaxed | internal::flags::half)) != 0;
                if (wants_half != half)
                    numeric::Paths::set_format(wants_half ? numeric::float16 : numeric::float32);
                half = wants_half;
            }
            s.handlers[at](s, i);
            tell(i);
        }
    } catch (const internal::Fault& fault) {
        throw Error(fault.kind, fault.message, s.code.places[code[at].place]);
    }
}

template <class N>
void Machine<N>::set_half(bool half) {
    state_->half = half;
}

template <class N>
void Machine<N>::set_sampling(std::uint64_t seed) {
    state_->sampling = numeric::Random(seed);
}

template <class N>
void Machine<N>::run() {
    execute([](const internal::Instruction&) {});
}

template <class N>
void Machine<N>::run(const std::function<void(const Step<N>&)>& tell) {
    execute([&](const internal::Instruction& i) {
        if (i.op >= internal::copy) return;  // moves existing values
        const std::uint32_t count = i.op == SpvOpDot ? 1 : i.count;
        tell({.place = state_->code.places[i.place],
              .opcode = i.op,
              .results = std::span<const Value<N>>(state_->slots).subspan(i.result, count)});
    });
}

template <class N>
void Machine<N>::run(Coverage& coverage) {
    execute([&](const internal::Instruction& i) {
        const auto at = static_cast<std::size_t>(&i - state_->code.instructions.data());
        if (i.op != internal::select) return coverage.add(at, state_->next);
        for (std::uint32_t k = 0; k < (i.stride == 0 ? 1 : i.count); ++k)
            coverage.add(at, state_->bits(i.a + k) != 0 ? 1 : 0);
    });
}

template <class N>
bool Machine<N>::wrote(std::uint32_t set, std::uint32_t binding) const {
    for (std::size_t r = 0; r < state_->backings.size(); ++r) {
        const internal::Resource& resource = state_->code.resources[r];
        if (!resource.is_push_constant && resource.set == set && resource.binding == binding)
            return !state_->backings[r].dirty.empty();
    }
    return false;
}

template <class N>
void Machine<N>::keep_writes(std::uint32_t set, std::uint32_t binding,
                             const std::function<Word(std::size_t, Word)>& keep) {
    for (std::size_t r = 0; r < state_->backings.size(); ++r) {
        const internal::Resource& resource = state_->code.resources[r];
        if (resource.is_push_constant || resource.set != set || resource.binding != binding) continue;
        internal::Backing<N>& backing = state_->backings[r];
        for (const std::uint32_t word : backing.dirty)
            backing.values[word] = Value<N>::of_bits(keep(word, backing.values[word].bits()));
        backing.dirty.clear();
    }
}

template <class N>
Value<N> Machine<N>::read(std::uint32_t set, std::uint32_t binding, std::size_t word) const {
    for (std::size_t r = 0; r < state_->backings.size(); ++r) {
        const internal::Resource& resource = state_->code.resources[r];
        if (resource.is_push_constant || resource.set != set || resource.binding != binding) continue;
        const internal::Backing<N>& backing = state_->backings[r];
        if (word >= backing.words.size())
            throw Error(Error::Kind::out_of_bounds, fmt::format("word {} of {}", word, backing.words.size()));
        return backing.values.empty() ? Value<N>::of_bits(backing.words[word]) : backing.values[word];
    }
    throw Error(Error::Kind::missing,
                fmt::format("the program has no buffer at set {}, binding {}", set, binding));
}

}  // namespace gloam::interpreter
