// SPDX-License-Identifier: MIT
#include "module/compile.hpp"

#include <fmt/ranges.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv-tools/libspirv.h>
#include <spirv_cross_c.h>
#include <algorithm>
#include <array>

#include "module/internal/front_end.hpp"
#include "module/spirv.hpp"
#include "module/steps.hpp"
#include "source/lines.hpp"

namespace gloam::module {
namespace {

// Of a number; others have none.
std::string scalar_name(Scalar scalar) {
    static constexpr std::array names{"void", "bool", "int", "uint", "float", "float16_t"};
    const auto at = static_cast<std::size_t>(scalar);
    return at < names.size() ? names.at(at) : "";
}

std::string vector_prefix(Scalar scalar) {
    if (scalar == Scalar::float_) return {};
    return scalar == Scalar::float16_ ? "f16" : scalar_name(scalar).substr(0, 1);
}

std::string sizes_of(const Type& type) {
    std::string text;
    for (const std::uint32_t size : type.sizes) text += "[" + (size > 0 ? std::to_string(size) : "") + "]";
    return text;
}

bool has_text(const Type& type) {
    return type.scalar == Scalar::sampler || type.scalar == Scalar::unsupported ||
           type.scalar == Scalar::oversized;
}

// One element of an array.
std::string element_text(const Type& type) {
    if (has_text(type)) return type.name;
    if (type.scalar == Scalar::structure) {
        std::string text = type.name + " {";
        for (const Member& member : type.members)
            text.append(" ").append(name_of(member.type)).append(" ").append(member.name).append(";");
        return text + " }";
    }
    const std::string rows = std::to_string(type.rows);
    if (type.columns > 1) {
        std::string text = vector_prefix(type.scalar) + "mat" + std::to_string(type.columns);
        return type.columns == type.rows ? text : text.append("x").append(rows);
    }
    return type.rows > 1 ? vector_prefix(type.scalar) + "vec" + rows : scalar_name(type.scalar);
}

std::string text_of(const Parameter& parameter) {
    std::string text;
    if (parameter.direction == source::Direction::out) text = "out ";
    if (parameter.direction == source::Direction::inout) text = "inout ";
    text += name_of(parameter.type);
    if (!parameter.name.empty()) text += " " + parameter.name;
    return text;
}

// Applies the variant to the front end's module; each step produces a valid module.
Spirv varied(Spirv module, const Variant& variant) {
    validate(module);
    const auto decorated = [&variant](Spirv words) {
        if (variant.strict) words = with_no_contraction(words);
        if (variant.relaxed) words = with_relaxed_precision(words);
        return words;
    };
    // Decorates before the optimizer, so that it cannot contract, and after it, for instructions that it has
    // created.
    module = decorated(std::move(module));
    if (variant.optimization != Optimization::none)
        module = decorated(optimize(module, variant.optimization));
    if (variant.strict || variant.relaxed || variant.optimization != Optimization::none) validate(module);
    return module;
}

}  // namespace

bool operator==(const Type& a, const Type& b) {
    if (a.scalar != b.scalar || a.columns != b.columns || a.rows != b.rows || a.sizes != b.sizes)
        return false;
    if (has_text(a)) return a.name == b.name;
    return std::equal(a.members.begin(), a.members.end(), b.members.begin(), b.members.end(),
                      [](const Member& x, const Member& y) { return x.type == y.type; });
}

Type element_of(const Type& array) {
    Type element = array;
    element.sizes.erase(element.sizes.begin());
    return element;
}

std::size_t scalar_count(const Type& type) {
    std::size_t count = static_cast<std::size_t>(type.columns) * static_cast<std::size_t>(type.rows);
    if (type.scalar == Scalar::void_ || type.scalar == Scalar::sampler) count = 0;
    if (type.scalar == Scalar::structure) {
        count = 0;
        for (const Member& member : type.members)
            count = std::min(count + scalar_count(member.type), most_scalars + 1);
    }
    for (const std::uint32_t size : type.sizes) count = std::min(count * size, most_scalars + 1);
    return count;
}

std::string to_glsl(const Type& type) {
    return element_text(type) + sizes_of(type);
}

std::string name_of(const Type& type) {
    return (type.scalar == Scalar::structure ? type.name : element_text(type)) + sizes_of(type);
}

std::string to_glsl(const Function& function) {
    std::string text = name_of(function.result) + " " + function.name + "(";
    for (std::size_t i = 0; i < function.parameters.size() && !function.parameters[i].global; ++i)
        text += (i == 0 ? "" : ", ") + text_of(function.parameters[i]);
    return text + ")";
}

std::vector<Variant> variants() {
    using Constants = Variant::Constants;
    return {
        {.name = "shipped", .description = "the SPIR-V that glslang makes"},
        {.name = "strict",
         .description = "every float operation NoContraction: no contraction, no reordering",
         .strict = true},
        {.name = "optimized",
         .description = "optimised for speed by SPIRV-Tools (-O)",
         .optimization = Optimization::performance},
        {.name = "small",
         .description = "optimised for size by SPIRV-Tools (-Os)",
         .optimization = Optimization::size},
        {.name = "relaxed",
         .description = "every float result RelaxedPrecision (mediump), and NoContraction",
         .strict = true,
         .relaxed = true},
        {.name = "literals",
         .description = "a few inputs as literals, folded by the compiler (-O)",
         .optimization = Optimization::performance,
         .constants = Constants::literals},
        {.name = "specialization",
         .description = "a few inputs as specialization constants, folded by the driver",
         .constants = Constants::specialization},
    };
}

Variant variant(const std::string& name) {
    const std::size_t bar = name.rfind(step_separator);
    if (bar != std::string::npos) {
        Variant made = variant(name.substr(0, bar));
        made.name = name;
        const std::vector<std::string> steps = steps_from(name.substr(bar + step_separator.size()));
        if (steps.size() != 1) throw std::invalid_argument(name + ": expected one step behind each bar");
        made.steps.push_back(steps.front());
        return made;
    }
    std::string names;
    for (Variant& known : variants()) {
        if (known.name == name) return std::move(known);
        names += (names.empty() ? "" : ", ") + known.name;
    }
    throw std::invalid_argument("unknown variant \"" + name + "\": expected " + names);
}

Spirv compile(const source::Source& source, const CompileOptions& options) {
    source::require_vulkan_version(source);
    Spirv module = internal::to_spirv(source, options.stage, options.include_roots,
                                      internal::Unreached::dropped, options.lines);
    try {
        return varied(std::move(module), options.variant);
    } catch (const source::CompileError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw source::CompileError(source.name + ": " + error.what());
    }
}

std::string compiler_version() {
    const glslang::Version front_end = glslang::GetVersion();
    std::array<unsigned, 3> cross{};
    spvc_get_version(&cross[0], &cross[1], &cross[2]);
    const char* commit = spvc_get_commit_revision_and_timestamp();  // or null
    return fmt::format("glslang {}.{}.{}{} (generator {}), {}, SPIRV-Cross {}{}{}", front_end.major,
                       front_end.minor, front_end.patch, front_end.flavor,
                       glslang::GetSpirvGeneratorVersion(), spvSoftwareVersionDetailsString(),
                       fmt::join(cross, "."), commit && *commit ? " " : "", commit ? commit : "");
}

}  // namespace gloam::module
