// SPDX-License-Identifier: MIT
#include "subject/signature.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace gloam::subject {

using module::Scalar;
using source::Direction;

void for_each_value(const module::Type& type, const std::function<void(const module::Type&)>& visit) {
    if (!type.sizes.empty()) {
        const module::Type element = module::element_of(type);
        for (std::uint32_t i = 0; i < type.sizes.front(); ++i) for_each_value(element, visit);
    } else if (type.scalar == Scalar::structure) {
        for (const module::Member& member : type.members) for_each_value(member.type, visit);
    } else if (type.scalar != Scalar::void_ && type.scalar != Scalar::sampler) {
        visit(type);
    }
}

std::vector<Scalar> scalars_of(const module::Type& type) {
    std::vector<Scalar> scalars;
    for_each_value(type, [&](const module::Type& one) {
        scalars.insert(scalars.end(), static_cast<std::size_t>(one.columns * one.rows), one.scalar);
    });
    return scalars;
}

double whole_number(Scalar scalar, Word word) {
    return scalar == Scalar::int_ ? from_word<int>(word) : static_cast<double>(word);
}

double number_at(Scalar scalar, Word word) {
    return module::is_float(scalar) ? from_word<double>(word) : whole_number(scalar, word);
}

const numeric::FloatFormat& format_of(Scalar scalar) {
    return scalar == Scalar::float16_ ? numeric::float16 : numeric::float32;
}

Word float_word(Scalar scalar, double value) {
    if (scalar == Scalar::float16_ && std::isfinite(value)) {
        const double low = numeric::float16.round_down(value);
        const double high = numeric::float16.round_up(value);
        value = value - low <= high - value ? low : high;
    }
    return to_word(static_cast<float>(value));
}

Word stepped_float(Scalar scalar, Word word, std::int64_t steps) {
    if (scalar == Scalar::float_)
        return to_word(numeric::step(from_word<float>(word), static_cast<int>(steps)));
    const auto value = from_word<double>(word);
    if (!std::isfinite(value)) return word;
    // At a power of two the numbers above stand twice as far apart as those below.
    const double within = std::nextafter(value, steps < 0 ? -numeric::infinity : numeric::infinity);
    return float_word(scalar, value + static_cast<double>(steps) * numeric::float16.ulp(within));
}

bool same_bits(std::span<const Scalar> scalars, std::span<const Word> a, std::span<const Word> b) {
    const auto is_nan = [](Word word) { return std::isnan(from_word<float>(word)); };
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i] && !(module::is_float(scalars[i]) && is_nan(a[i]) && is_nan(b[i]))) return false;
    return true;
}

std::string text_of(Scalar scalar, Word word) {
    if (module::is_float(scalar)) return numeric::to_text(from_word<float>(word));
    if (scalar == Scalar::int_) return fmt::format("{}", from_word<int>(word));
    if (scalar == Scalar::bool_) return word != 0U ? "true" : "false";
    return fmt::format("{0} (0x{0:08x})", word);
}

std::vector<InputSlot> Signature::inputs() const {
    std::vector<InputSlot> slots;
    std::size_t first = 0;
    for (const module::Parameter& p : parameters) {
        if (p.direction == Direction::out) continue;
        slots.push_back({&p, first, scalars_of(p.type).size()});
        first += slots.back().count;
    }
    return slots;
}

std::vector<Scalar> Signature::input_scalars() const {
    std::vector<Scalar> scalars;
    for (const module::Parameter& p : parameters)
        if (p.direction != Direction::out) std::ranges::copy(scalars_of(p.type), std::back_inserter(scalars));
    return scalars;
}

std::vector<Scalar> Signature::output_scalars() const {
    std::vector<Scalar> scalars = scalars_of(result);
    for (const module::Parameter& p : parameters)
        if (p.direction != Direction::in) std::ranges::copy(scalars_of(p.type), std::back_inserter(scalars));
    return scalars;
}

std::size_t Signature::input_words() const {
    return input_scalars().size();
}

std::size_t Signature::output_words() const {
    return output_scalars().size();
}

std::vector<std::size_t> Signature::output_values() const {
    std::vector<std::size_t> values;
    const auto add = [&](const module::Type& one) {
        values.push_back(static_cast<std::size_t>(one.columns * one.rows));
    };
    for_each_value(result, add);
    for (const module::Parameter& p : parameters)
        if (p.direction != Direction::in) for_each_value(p.type, add);
    return values;
}

module::Function with_globals(module::Function function, const source::Excerpt& excerpt) {
    const auto& globals = excerpt.globals;
    for (const module::Parameter& variable : function.globals)
        if (const auto found = globals.find(variable.name); found != globals.end()) {
            function.parameters.push_back(variable);
            function.parameters.back().uniform = found->second == source::Access::uniform;
        }
    for (const source::BoundVariable& one : excerpt.bound)
        if (!one.format.empty())
            function.parameters.push_back({.name = one.name,
                                           .type = pixels_of(one.format),
                                           .direction = one.written ? Direction::inout : Direction::in,
                                           .global = true,
                                           .image = one.format});
    // The kernel sets it, and not the function.
    if (globals.contains(source::discarded))
        function.parameters.push_back({.name = source::discarded,
                                       .type = {.scalar = Scalar::bool_},
                                       .direction = Direction::out,
                                       .global = true});
    return function;
}

module::Type pixels_of(std::string_view format) {
    const std::size_t channels = format.find('3');  // "rg32f"
    return {.scalar = format.ends_with("ui")  ? Scalar::uint_
                      : format.ends_with('i') ? Scalar::int_
                                              : Scalar::float_,
            .rows = static_cast<int>(channels),
            .sizes = {image_sides[1], image_sides[0]}};
}

bool is_of_each(const module::Parameter& parameter) {
    return !parameter.uniform && parameter.type.scalar != Scalar::sampler;
}

module::Function together(module::Function function, const backend::Team& team) {
    if (team.kind == backend::Team::Kind::alone) return function;
    const auto make_array = [&team](module::Type& type) {
        type.sizes.insert(type.sizes.begin(), team.count());
    };
    if (function.result.scalar != Scalar::void_) make_array(function.result);
    for (module::Parameter& p : function.parameters)
        if (is_of_each(p)) make_array(p.type);
    return function;
}

std::string to_glsl(const Signature& signature, const std::string& name) {
    module::Function function{
        .name = name, .result = signature.result, .parameters = signature.parameters, .defined = true};
    const auto spell_out = [](module::Type& type) {
        if (type.scalar != Scalar::structure) return;
        module::Type one = type;
        one.sizes.clear();
        type.name = module::to_glsl(one);
    };
    spell_out(function.result);
    for (module::Parameter& p : function.parameters) spell_out(p.type);
    return module::to_glsl(function);
}

}  // namespace gloam::subject
