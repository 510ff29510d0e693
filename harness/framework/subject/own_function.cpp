// SPDX-License-Identifier: MIT
#include "subject/own_function.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "base/pattern.hpp"
#include "interpreter/machine.hpp"
#include "module/module.hpp"
#include "module/reflection.hpp"
#include "source/tokens.hpp"

namespace gloam::subject {
namespace {

using module::Scalar;

constexpr double usual_low = 1e-6;
constexpr double usual_high = 1e6;
constexpr long usual_integer = 1000;
constexpr long usual_index = 7;  // most integer parameters are indices, counts or modes
constexpr long largest_unsigned = 1L << 31;
constexpr const char* judged_samplers =
    "sampler2D, sampler2DArray, sampler3D, samplerCube, samplerCubeArray, those of integers, and "
    "sampler2DShadow";

Values scalar_values(Scalar scalar, const std::optional<Range>& range) {
    if (module::is_float(scalar)) {
        if (range) return uniform(range->low, range->high, scalar);
        const numeric::FloatFormat& format = format_of(scalar);
        const double low = std::max(usual_low, format.smallest_normal());
        const double high = std::min(usual_high, format.largest());
        // Most parameters of shader functions are shares, colours or coordinates.
        return either(uniform(0, 1, scalar), signed_log_uniform(low, high, scalar).and_special(scalar));
    }
    if (scalar == Scalar::bool_) return booleans();
    if (range)
        return integers(nearest_integer(std::trunc(range->low)), nearest_integer(std::trunc(range->high)));
    return either(integers(0, usual_index),
                  scalar == Scalar::int_
                      ? either(log_integers(usual_integer), integers(-usual_integer, usual_integer))
                      : log_integers(largest_unsigned));
}

void add_values(const module::Type& type, const std::string& name, const Ranges& ranges,
                std::vector<Values>& all) {
    if (type.sizes.empty())
        for (const module::Member& member : type.members)
            add_values(member.type, name + "." + member.name, ranges, all);
    if (type.sizes.empty() && type.scalar == Scalar::structure) return;
    for (const Scalar scalar : scalars_of(type)) all.push_back(scalar_values(scalar, range_of(ranges, name)));
}

Values values_of(const module::Type& type, const std::string& name, const Ranges& ranges) {
    std::vector<Values> scalars;
    add_values(type, name, ranges, scalars);
    return scalars.size() == 1 ? scalars.front() : vector(scalars);
}

// "float[5000] has more than 4096 scalars", "sampler2DMS is not judged: ..."; empty if a kernel can pass it.
std::string obstacle(const module::Type& type) {
    if (type.scalar == Scalar::oversized)
        return fmt::format("{} has more than {} scalars", type.name, module::most_scalars);
    if (type.scalar == Scalar::unsupported)
        return fmt::format("{} is not judged: gloam judges {}", module::name_of(type), judged_samplers);
    for (const module::Member& member : type.members)
        if (const std::string inside = obstacle(member.type); !inside.empty())
            return fmt::format("in {}, {}", module::name_of(type), inside);
    return {};
}

// Why no kernel can call a function; empty if one can.
std::string why_not(const module::Function& function, const source::Excerpt& excerpt,
                    const backend::Team& team) {
    for (const char* ours : {"gloam_kernel_", "GloamGenerated"})
        if (excerpt.text.find(ours) != std::string::npos)
            return fmt::format("it uses a name with {}, as only the generated kernel may", ours);
    if (!function.other_number.empty()) return module::spirv::not_judged(function.other_number);
    std::size_t scalars = module::scalar_count(function.result);
    for (const module::Parameter& p : function.parameters) {
        if (const std::string what = obstacle(p.type); !what.empty() && p.global)
            return fmt::format("values of \"{}\" cannot be drawn: {}", p.name, what);
        else if (!what.empty())
            return fmt::format("values of the parameter type {} cannot be drawn: {}", module::name_of(p.type),
                               what);
        scalars += module::scalar_count(p.type);
        if (!p.image.empty() && team.kind != backend::Team::Kind::alone)
            return fmt::format("the image \"{}\" is shared by the invocations that run it together", p.name);
        if (!p.global || !p.image.empty()) continue;
        const source::Access access = excerpt.globals.at(p.name);
        const bool reads = access == source::Access::reads || access == source::Access::uniform;
        if (p.direction != source::Direction::in && reads)
            return fmt::format("it assigns to \"{}\", which a shader can only read", p.name);
        if (access == source::Access::buffer && excerpt.needs == source::Needs::group)
            return fmt::format("the buffer \"{}\", which it may write, is shared by its group", p.name);
    }
    if (const std::string what = obstacle(function.result); !what.empty())
        return fmt::format("a result of type {} cannot be read: {}", module::name_of(function.result), what);
    constexpr std::uint32_t most = interpreter::Machine<float>::most_invocations;
    if (team.count() > most)
        return fmt::format("its work group has {} invocations, expected at most {}", team.count(), most);
    if (scalars * team.count() > module::most_scalars)
        return fmt::format("its parameters and its result have more than {} scalars", module::most_scalars);
    if (Signature{.result = function.result, .parameters = function.parameters}.output_words() == 0)
        return "it has no result and no out parameter, and it writes no buffer or stage output";
    return {};
}

std::string without_blanks(std::string text) {
    std::erase_if(text, [](unsigned char c) { return std::isspace(c) != 0; });
    return text;
}

bool is_named(const std::string& definition, const std::string& name) {
    const std::string plain = without_blanks(name);
    const std::string whole = without_blanks(definition);
    return whole == plain || whole.starts_with(plain + "(");
}

// "f(vec2, float)"
std::string definition_of(const module::Function& function) {
    std::string types;
    for (const module::Parameter& p : function.parameters)
        if (!p.global) types += (types.empty() ? "" : ", ") + module::name_of(p.type);
    return fmt::format("{}({})", function.name, types);
}

// A variable of GLSL 1.20 that later versions have not.
bool is_legacy(std::string_view name) {
    constexpr std::array<std::string_view, 20> beginnings{
        "gl_ModelView", "gl_Projection", "gl_Normal",    "gl_TextureMatrix", "gl_MultiTexCoord",
        "gl_TexCoord",  "gl_Color",      "gl_Secondary", "gl_Front",         "gl_Back",
        "gl_FogCoord",  "gl_FogFrag",    "gl_Fog",       "gl_Light",         "gl_FragData",
        "gl_ClipPlane", "gl_ClipVertex", "gl_Point",     "gl_TextureEnv",    "gl_MaxLights"};
    if (name == "gl_Vertex" || name == "ftransform") return true;
    return std::ranges::any_of(beginnings, [&](auto beginning) { return name.starts_with(beginning); });
}

// A word of HLSL; empty if the text has none.
std::string word_of_hlsl(const std::string& text) {
    static const base::Pattern words(
        R"(\b(float[234](x[234])?|half[234]|int[234]|uint[234]|cbuffer|SV_\w+)\b)");
    const std::vector<std::string> found = words.first(text);
    return found.empty() ? "" : found.front();
}

// A reference to a buffer as a type of the excerpt, which lacks it.
std::string pointer_of(const source::Excerpt& excerpt) {
    if (excerpt.text.find("GL_EXT_buffer_reference") == std::string::npos) return {};
    const std::vector<source::Token> tokens = source::tokens_of(excerpt.text);
    const auto found = std::ranges::adjacent_find(tokens, [&](const auto& type, const auto& name) {
        return excerpt.interface.contains(type.text) && name.is_word();
    });
    return found == tokens.end() ? "" : found->text;
}

// Why an excerpt does not compile as a part of a compute shader. `errors`: what the compiler says.
Skipped refused(const source::Excerpt& excerpt, const std::string& definition, const std::string& errors) {
    const std::string first = errors.substr(0, errors.find('\n'));
    std::istringstream parts(first);  // "own.frag:10: 'image' : undeclared identifier"
    std::string place;
    std::string name;
    std::getline(parts, place, '\'');
    std::getline(parts, name, '\'');
    place.erase(place.find_last_not_of(": ") + 1);
    const auto is = [&first](const char* text) { return first.find(text) != std::string::npos; };
    const bool lacks = excerpt.interface.contains(name);
    if (const std::string type = pointer_of(excerpt); !type.empty() && (lacks || is("syntax error")))
        return {definition,
                fmt::format("gloam cannot run it: {}, at {}, is a reference to memory (buffer_reference)",
                            type, place)};
    if (lacks)
        return {
            definition,
            fmt::format("it uses \"{}\", an image or sampler, at {}; expected no array, but one of {}, an "
                        "image2D with a format of 32 bits like r32f, or values from parameters and "
                        "prototypes T name(ivec2)",
                        name, place, judged_samplers)};
    if (is_legacy(name))
        return {definition,
                fmt::format("\"{}\" at {} is of GLSL 1.20; pass its value as a parameter or a uniform", name,
                            place)};
    if (const std::string word = word_of_hlsl(excerpt.text); !word.empty())
        return {definition, fmt::format("it is HLSL (\"{}\"), and gloam reads GLSL: {}", word, first), true};
    if (is("not supported in this stage") || (name.starts_with("gl_") && is("undeclared identifier")))
        return {definition,
                fmt::format("{} at {} needs another stage than compute and fragment", name, place)};
    if (is("Atomic memory function") || is("atomic memory functions"))
        return {definition,
                fmt::format("{} at {} needs memory that invocations share: each input is run by itself", name,
                            place)};
    return {definition, "it does not compile: " + first, true};
}

// The invocations that run a function of the excerpt together.
backend::Team team_for(const source::Excerpt& excerpt, const std::string& file,
                       const module::SpirvCache& cache) {
    if (excerpt.needs == source::Needs::nobody) return {};
    if (excerpt.needs == source::Needs::quad) return backend::quad_team;
    constexpr std::uint32_t usual = 64;
    if (!excerpt.has_group_size) return {.kind = backend::Team::Kind::group, .size = {usual, 1, 1}};
    source::Source whole = probe_of(file, excerpt.text);
    whole.text += "\nvoid main() {}\n";
    return {.kind = backend::Team::Kind::group,
            .size = module::reflect(cache.compile(whole, {.variant = {}})).local_size};
}

// Adds the functions of an excerpt whose definition is wanted.
template <class Wants>
void add_functions(const OwnFile& file, const source::Excerpt& excerpt, const module::SpirvCache& cache,
                   const Wants& wants, OwnFunctions& all) {
    const backend::Team team = team_for(excerpt, file.name, cache);
    const std::vector<module::Function> compiled =
        cache.functions(probe_of(file.name, excerpt.text), {.stage = stage_of(team), .variant = {}});
    std::vector<std::pair<module::Function, std::string>> own;  // and its comment
    std::size_t k = 0;
    for (const module::Function& function : compiled) {
        if (function.name != excerpt.function || !function.defined) continue;
        const bool known = k < excerpt.definitions.size();  // not made by a macro
        if (!known || !excerpt.definitions[k].empty())
            own.emplace_back(with_globals(function, excerpt), known ? excerpt.comments[k] : "");
        ++k;
    }
    const auto unserved = std::ranges::find_if(compiled, [](const module::Function& function) {
        return !function.defined && !image_prototype(function);
    });
    for (const auto& [function, comment] : own) {
        const std::string definition = definition_of(function);
        if (!wants(definition)) continue;
        std::string why = why_not(function, excerpt, team);
        if (why.empty() && unserved != compiled.end())
            why = fmt::format("it calls {}, which has no body; expected T name(ivec2)",
                              definition_of(*unserved));
        if (!why.empty()) {
            all.left_out.push_back({definition, why});
            continue;
        }
        std::vector<ImagePrototype> images = images_of(excerpt, function);
        std::ranges::copy(image_prototypes(compiled, file.name), std::back_inserter(images));
        all.found.push_back({{file.name, together(function, team), images, false, excerpt.text, team},
                             own.size() > 1 ? definition : function.name,
                             comment});
    }
}

}  // namespace

OwnFunctions own_functions(const LabOptions& options, const std::vector<std::string>& names) {
    const OwnFile& file = *options.file;
    const module::SpirvCache cache = shader_cache(options);
    OwnFunctions all;
    std::vector<std::string> unmet = names;
    const auto wants = [&](const std::string& definition) {
        const auto named = [&](const std::string& name) { return is_named(definition, name); };
        std::erase_if(unmet, named);
        return names.empty() || std::ranges::any_of(names, named);
    };
    for (const source::Excerpt& excerpt : file.excerpts.functions) {
        const bool asked = names.empty() || std::ranges::any_of(names, [&](const std::string& name) {
                               return without_blanks(name.substr(0, name.find('('))) == excerpt.function;
                           });
        if (!asked) continue;
        try {
            add_functions(file, excerpt, cache, wants, all);
        } catch (const source::CompileError& error) {
            for (const std::string& definition : excerpt.definitions)
                if (!definition.empty() && wants(definition))
                    all.left_out.push_back(refused(excerpt, definition, error.what()));
        }
    }
    if (!unmet.empty()) {
        std::vector<std::string> known;
        for (const source::Excerpt& excerpt : file.excerpts.functions) known.push_back(excerpt.function);
        throw std::invalid_argument(
            fmt::format("{}: no function {}; it defines: {}", file.name, unmet.front(),
                        known.empty() ? "none" : fmt::format("{}", fmt::join(known, ", "))));
    }
    std::erase_if(all.found, [&](const OwnFunction& own) {
        const std::string why = why_not_run(own, cache);
        if (!why.empty()) all.left_out.push_back({own.name, "gloam cannot run it: " + why});
        return !why.empty();
    });
    return all;
}

std::vector<std::string> value_names(const module::Type& type, const std::string& name) {
    if (!type.sizes.empty() || type.members.empty()) return {name};
    std::vector<std::string> names;
    for (const module::Member& member : type.members)
        std::ranges::move(value_names(member.type, name + "." + member.name), std::back_inserter(names));
    return names;
}

Domain domain_of(const OwnFunction& own, const Ranges& ranges) {
    std::vector<Values> parameters;
    for (const module::Parameter& parameter : own.function.parameters) {
        if (parameter.direction == source::Direction::out) continue;
        const bool in_quad = own.team.kind == backend::Team::Kind::quad && is_of_each(parameter);
        const module::Type type = in_quad ? module::element_of(parameter.type) : parameter.type;
        const Values values = values_of(type, parameter.name, ranges);
        parameters.push_back(in_quad ? neighbours(type, values, parameter.name == fragment_coordinate)
                                     : values);
    }
    return Domain(std::move(parameters));
}

bool OwnFunction::is_property() const {
    static const base::Pattern line(R"((^|\n)[ \t/*]*must hold[ \t\r.*/]*(\n|$))", true);
    const std::vector<Scalar> outputs = signature().output_scalars();
    return (function.name.starts_with("test_") || !line.first(comment).empty()) &&
           std::ranges::count(outputs, Scalar::bool_) == std::ssize(outputs);
}

}  // namespace gloam::subject
