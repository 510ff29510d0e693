// SPDX-License-Identifier: MIT
#include "check/module_comparison.hpp"

#include <fmt/format.h>
#include <bit>
#include <cmath>

#include "check/internal/pass_work.hpp"
#include "numeric/random.hpp"

namespace gloam::check {
namespace {

using internal::PassInterface;
using internal::PassSlot;
using internal::PassWork;

constexpr int side = 8;                 // of every image
constexpr std::uint32_t elements = 64;  // of an array without a size

Word random_word(shader::Scalar scalar, numeric::Random& random) {
    if (scalar == shader::Scalar::float_)
        return to_word(static_cast<float>(static_cast<int>(random.below(257)) - 64) / 64.0F);
    return static_cast<Word>(random.below(scalar == shader::Scalar::bool_ ? 2 : side));
}

std::vector<Word> random_words(const shader::Type& type, std::size_t count, numeric::Random& random) {
    std::vector<Word> words;
    const std::vector<shader::Scalar> scalars = scalars_of(type);
    for (std::size_t i = 0; i < count; ++i)
        for (const shader::Scalar scalar : scalars) words.push_back(random_word(scalar, random));
    return words;
}

PassValue random_value(const PassSlot& slot, numeric::Random& random) {
    if (slot.kind == PassSlot::Kind::image)
        return Image{.element = slot.type,
                     .size = {side, side},
                     .words = random_words(slot.type, static_cast<std::size_t>(side) * side, random)};
    shader::Type type = slot.type;
    for (std::uint32_t& size : type.sizes)
        if (size == 0) size = elements;
    return {type, random_words(type, 1, random)};
}

PassWork random_work(const PassInterface& pass, numeric::Random& random) {
    PassInputs inputs;
    for (const PassSlot& slot : pass.slots)
        if (slot.kind != PassSlot::Kind::constant) inputs.emplace(slot.name, random_value(slot, random));
    return internal::bound(pass, inputs, {.size = {side, side}, .groups = {2, 2, 1}});
}

const std::vector<Word>* words_of(const internal::Bound& bound) {
    if (const auto* image = std::get_if<internal::BoundImage>(&bound)) return &image->texels;
    if (const auto* buffer = std::get_if<internal::BoundBuffer>(&bound)) return &buffer->words;
    return nullptr;
}

bool same(Word a, Word b) {
    return a == b || (std::isnan(std::bit_cast<float>(a)) && std::isnan(std::bit_cast<float>(b)));
}

// The first word that differs, in words. Empty: none does.
std::string difference(const PassInterface& pass, const PassWork& before, const PassWork& after) {
    for (std::size_t b = 0; b < before.bindings.size(); ++b) {
        const std::vector<Word>* one = words_of(before.bindings[b]);
        const std::vector<Word>* other = words_of(after.bindings[b]);
        for (std::size_t w = 0; one != nullptr && w < one->size(); ++w) {
            if (same((*one)[w], (*other)[w])) continue;
            std::string name = std::to_string(b);
            for (const shader::Binding& binding : pass.bindings)
                if (binding.number == b && !binding.name.empty()) name += " (" + binding.name + ")";
            return fmt::format("binding {}, word {}: 0x{:08x} before, 0x{:08x} after", name, w, (*one)[w],
                               (*other)[w]);
        }
    }
    return {};
}

}  // namespace

Answer compare_modules(const std::string& name, const shader::Spirv& before, const shader::Spirv& after,
                       std::size_t inputs, std::uint64_t seed) {
    const auto modules = [&name](const shader::Spirv& compute) {
        return internal::PassModules{.name = name, .compute = compute, .vertex = {}, .fragment = {}};
    };
    const PassInterface pass = internal::interface_of(modules(before));
    Answer answer{.equation = name, .function = "main", .file = name, .verdict = Verdict::rules};
    numeric::Random random(seed);
    for (std::size_t i = 0; i < inputs; ++i) {
        PassWork first = random_work(pass, random);
        PassWork second = first;
        try {
            internal::run_interpreted(modules(before), first);
        } catch (const backend::Fault& fault) {
            answer.add_undefined(InputClass::ordinary, fault.what());
            continue;
        }
        std::string found;
        try {
            internal::run_interpreted(modules(after), second);
            found = difference(pass, first, second);
        } catch (const backend::Fault& fault) {
            found = fmt::format("a fault after, none before: {}", fault.what());
        }
        answer.add({.index = i}, !found.empty());
        if (!found.empty() && answer.story.empty())
            answer.story = fmt::format("{}: the module means another thing: run {} of seed {}, {}\n", name, i,
                                       seed, found);
    }
    return answer;
}

}  // namespace gloam::check
