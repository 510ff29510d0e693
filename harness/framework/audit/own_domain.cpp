// SPDX-License-Identifier: MIT
#include "audit/own_domain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>

#include "audit/internal/parameter_meaning.hpp"
#include "base/number.hpp"
#include "source/tokens.hpp"

namespace gloam::check {
namespace {

using shader::Scalar;
using shader::Type;

using internal::Kind;
using internal::Meaning;
using internal::usual_high;
using internal::usual_low;

constexpr long usual_index = 7;  // most integer parameters are indices, counts or modes

struct Described {
    std::string text;
    Values values;
};

// No one means subnormal numbers, or the smallest normal ones, though they lie in the range.
Values without_tiny(Values values, Scalar scalar) {
    const auto is_tiny = [scalar](std::span<const Word> words) {
        const double magnitude = std::abs(from_word<double>(words.front()));
        return magnitude > 0.0 && magnitude <= format_of(scalar).smallest_normal();
    };
    std::erase_if(values.fixed, [&](const Values::Fixed& fixed) { return is_tiny(fixed.words); });
    values.contains = [contains = values.contains, is_tiny](std::span<const Word> words) {
        return contains(words) && !is_tiny(words);
    };
    return values;
}

// The same values in each component.
Values in_each(const Type& type, const Values& values) {
    const int components = type.columns * type.rows;
    return components == 1 ? values : vector(components, values);
}

// The largest usual number of a type.
double usual_high_of(Scalar scalar) {
    return std::min(usual_high, format_of(scalar).largest());
}

Described without_meaning(const Type& type) {
    const Scalar scalar = type.scalar;
    if (scalar == Scalar::bool_) return {"false, true", in_each(type, booleans())};
    if (!shader::is_float(scalar))
        return {fmt::format("0 to {}", usual_index), in_each(type, integers(0, usual_index))};
    const double high = usual_high_of(scalar);
    return {fmt::format("-{0:.7g} to {0:.7g}, half of them 0 to 1", high),
            in_each(type, either(without_tiny(uniform(0, 1, scalar), scalar),
                                 signed_log_uniform(usual_low, high, scalar)))};
}

Described with(const Meaning& meaning, const Type& type) {
    const Scalar scalar = type.scalar;
    if (scalar == Scalar::bool_) return without_meaning(type);
    if (!shader::is_float(scalar)) {
        const bool any_size = meaning.kind != Kind::range;
        const long low = any_size ? 1 : std::lround(std::clamp(meaning.low, -0x1p31, 0x1p32 - 1.0));
        const long high = any_size ? static_cast<long>(usual_high)
                                   : std::lround(std::clamp(meaning.high, -0x1p31, 0x1p32 - 1.0));
        return {fmt::format("{} to {}", low, high), in_each(type, integers(low, high))};
    }
    if (meaning.kind == Kind::unit)
        return {type.rows == 4 ? "unit quaternions" : "unit vectors", unit_vector(type.rows)};
    if (meaning.kind == Kind::positive) {
        const double high = usual_high_of(scalar);
        return {fmt::format("{:.7g} to {:.7g}", usual_low, high),
                in_each(type, either(log_uniform(usual_low, high, scalar), uniform(1, 1, scalar)))};
    }
    return {fmt::format("{:.7g} to {:.7g}", meaning.low, meaning.high),
            in_each(type, without_tiny(uniform(meaning.low, meaning.high, scalar), scalar))};
}

// The length of the shortest array that a text indexes with this name alone: "weights[i]" where there is
// "float weights[4]". nullopt if there is none.
std::optional<long> indexed_length(shader::Tokens tokens, const std::string& name) {
    std::optional<long> shortest;
    for (std::size_t i = 2; i + 1 < tokens.size(); ++i) {
        if (tokens[i] != name || tokens[i - 1] != "[" || tokens[i + 1] != "]") continue;
        for (std::size_t d = 1; d + 3 < tokens.size(); ++d) {
            if (tokens[d] != tokens[i - 2].text || !tokens[d - 1].is_word() || tokens[d + 1] != "[") continue;
            const long length = base::number_from<long>(tokens[d + 2].text).value_or(0);
            if (tokens[d + 3] == "]" && length > 0) shortest = std::min(shortest.value_or(length), length);
        }
    }
    return shortest;
}

// The bodies of the functions with this name, each with the names of its parameters.
struct Body {
    std::vector<std::string> parameters;
    shader::Tokens tokens;
};
std::vector<Body> bodies_of(shader::Tokens tokens, const std::string& function) {
    std::vector<Body> all;
    for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
        if (tokens[i] != function || tokens[i + 1] != "(" || !tokens[i - 1].is_word()) continue;
        const std::size_t behind = shader::behind(tokens, i + 1);
        if (behind >= tokens.size() || tokens[behind] != "{") continue;
        Body body{.parameters = {},
                  .tokens = tokens.subspan(behind, shader::behind(tokens, behind) - behind)};
        for (std::size_t k = i + 2; k < behind; ++k)
            if (tokens[k] == "," || k + 1 == behind) body.parameters.push_back(tokens[k - 1].text);
        all.push_back(std::move(body));
    }
    return all;
}

// The name of the function that is called with the token at `at` as its whole argument, and which argument
// that is; empty: it is none.
std::pair<std::string, std::size_t> call_with(shader::Tokens tokens, std::size_t at) {
    std::size_t argument = 0;
    const auto ends = [&](std::size_t i) { return tokens[i] == "," || tokens[i] == ")" || tokens[i] == "("; };
    if (!ends(at - 1) || !ends(at + 1)) return {};
    for (int depth = 0; --at > 0;) {
        if (tokens[at] == ")" || tokens[at] == "]") ++depth;
        if (depth == 0 && tokens[at] == "(") return {tokens[at - 1].text, argument};
        if (depth == 0 && tokens[at] == ",") ++argument;
        if (tokens[at] == "(" || tokens[at] == "[") --depth;
    }
    return {};
}

// Whether a function reads single bits of an integer parameter, itself or where it passes it on: by shifts,
// masks, and functions of bits and packed numbers. A limit of a loop is a count.
// `asked`: functions and parameters that were asked before.
bool takes_apart(shader::Tokens tokens, const std::string& function, const std::string& name,
                 std::set<std::pair<std::string, std::string>>& asked) {
    if (!asked.emplace(function, name).second) return false;
    static const std::set<std::string, std::less<>> of_bits{
        "uintBitsToFloat", "bitfieldExtract", "bitfieldReverse", "unpackHalf2x16",
        "unpackUnorm2x16", "unpackSnorm2x16", "unpackUnorm4x8",  "unpackSnorm4x8"};
    bool found = false;
    for (const auto& [parameters, body] : bodies_of(tokens, function)) {
        for (std::size_t i = 1; i + 1 < body.size(); ++i) {
            if (body[i] != name) continue;
            const std::string& before = body[i - 1].text;
            const std::string& after = body[body[i + 1] == "." && i + 3 < body.size() ? i + 3 : i + 1].text;
            if (before == "<" || before == "<=") return false;
            found =
                found || after == ">>" || after == "&" || after == ">>=" || after == "&=" || before == "&";
            const auto [called, argument] = call_with(body, i);
            found = found || of_bits.contains(called);
            for (const Body& other : bodies_of(tokens, called))
                found = found || (argument < other.parameters.size() &&
                                  takes_apart(tokens, called, other.parameters[argument], asked));
        }
    }
    return found;
}

// What is said of the parts of a value.
std::string text_of(const std::vector<OrdinaryValues>& parts) {
    std::vector<std::string> texts;
    for (const OrdinaryValues& part : parts) texts.push_back(part.text);
    return fmt::format("{}", fmt::join(texts, "; "));
}
std::string reason_of(const std::vector<OrdinaryValues>& parts) {
    return parts.empty() ? "type" : parts.front().reason;
}

// The values of a parameter, or of a member of one.
class Ordinary {
  public:
    Ordinary(const OwnFunction& own, const Ranges& ranges)
        : tokens_(shader::tokens_of(own.text)),
          function_(own.function.name),
          comment_(own.comment),
          ranges_(ranges) {
        for (const shader::Parameter& parameter : own.function.parameters) names_.insert(parameter.name);
    }

    // `range`: the parameter that may have a range.
    void add(const Type& type, const std::string& name, const std::string& parameter,
             std::vector<OrdinaryValues>& all) const {
        if (!type.sizes.empty()) return add_array(type, name, parameter, all);
        if (type.scalar == Scalar::sampler) {
            all.push_back({name, "random images", "type", vector(std::vector<Values>{})});
            return;
        }
        if (type.scalar == Scalar::structure) {
            for (const shader::Member& member : type.members)
                add(member.type, name + "." + member.name, parameter, all);
            return;
        }
        const auto [described, reason] = values_of(type, name, parameter);
        all.push_back({name, described.text, reason, described.values});
    }

  private:
    // Every element has the values of one.
    void add_array(const Type& type, const std::string& name, const std::string& parameter,
                   std::vector<OrdinaryValues>& all) const {
        Type element = type;
        element.sizes.clear();
        std::vector<OrdinaryValues> parts;
        add(element, name, parameter, parts);
        int count = 1;
        for (const std::uint32_t size : type.sizes) count *= static_cast<int>(size);
        std::vector<Values> elements;
        for (int i = 0; i < count; ++i)
            for (const OrdinaryValues& part : parts) elements.push_back(part.values);
        all.push_back({name, fmt::format("{} of {}", count, text_of(parts)), reason_of(parts),
                       parts.size() == 1 ? vector(count, parts[0].values) : vector(elements)});
    }

    [[nodiscard]] std::pair<Described, std::string> values_of(const Type& type, const std::string& name,
                                                              const std::string& parameter) const {
        const int components = type.columns * type.rows;
        const bool is_float = shader::is_float(type.scalar);
        const bool is_whole = !is_float && type.scalar != Scalar::bool_;
        if (const auto range = ranges_.find(parameter); range != ranges_.end())
            return {with({Kind::range, range->second.low, range->second.high}, type), "--range"};
        const bool is_vector = type.scalar == Scalar::float_ && type.columns == 1 && components > 1;
        const std::string last = name.substr(name.rfind('.') + 1);
        if (is_float || is_whole)
            if (const auto meaning = internal::meaning_of_comment(comment_, last, names_, is_vector))
                return {with(*meaning, type), "comment"};
        if (is_whole)
            if (const auto length = indexed_length(tokens_, last))
                return {with({Kind::range, 0.0, static_cast<double>(*length - 1)}, type), "array"};
        std::set<std::pair<std::string, std::string>> asked;
        if (type.scalar == Scalar::uint_ && takes_apart(tokens_, function_, name, asked))
            return {with({Kind::range, 0.0, 0x1p32 - 1.0}, type), "bits"};
        if (is_float && type.columns > 1) return {with({Kind::range, -2.0, 2.0}, type), "type"};
        if (is_float)
            if (const auto meaning = internal::meaning_of_name(last, components);
                meaning && (meaning->kind != Kind::unit || is_vector))
                return {with(*meaning, type), "name"};
        return {without_meaning(type), "type"};
    }

    std::vector<shader::Token> tokens_;
    std::string function_;
    const std::string& comment_;
    const Ranges& ranges_;
    std::set<std::string> names_;
};

// The same values in each invocation of a quad, as one entry.
OrdinaryValues in_quad(const shader::Parameter& parameter, const Type& type,
                       const std::vector<OrdinaryValues>& parts) {
    std::vector<Values> values;
    for (const OrdinaryValues& part : parts) values.push_back(part.values);
    const bool pixels = parameter.name == fragment_coordinate;
    return {parameter.name, pixels ? "the pixels of a quad" : "neighbours, each " + text_of(parts),
            pixels ? "type" : reason_of(parts),
            neighbours(type, values.size() == 1 ? values.front() : vector(values), pixels)};
}

}  // namespace

std::vector<OrdinaryValues> ordinary_values(const OwnFunction& own, const Ranges& ranges) {
    const Ordinary ordinary(own, ranges);
    std::vector<OrdinaryValues> all;
    for (const shader::Parameter& parameter : own.function.parameters) {
        if (parameter.direction == shader::Direction::out) continue;
        if (own.team.kind != backend::Team::Kind::quad || !is_of_each(parameter)) {
            ordinary.add(parameter.type, parameter.name, parameter.name, all);
            continue;
        }
        const Type type = shader::element_of(parameter.type);
        std::vector<OrdinaryValues> parts;
        ordinary.add(type, parameter.name, parameter.name, parts);
        all.push_back(in_quad(parameter, type, parts));
    }
    return all;
}

Domain ordinary_domain(const shader::Function& function, const std::vector<OrdinaryValues>& ordinary) {
    std::vector<Values> parameters;
    std::size_t next = 0;
    const std::function<std::size_t(const Type&)> entries_of = [&](const Type& type) -> std::size_t {
        if (type.scalar != Scalar::structure || !type.sizes.empty()) return 1;
        std::size_t count = 0;
        for (const shader::Member& member : type.members) count += entries_of(member.type);
        return count;
    };
    for (const shader::Parameter& parameter : function.parameters) {
        if (parameter.direction == shader::Direction::out) continue;
        const std::size_t count = entries_of(parameter.type);
        std::vector<Values> members;
        for (std::size_t i = 0; i < count; ++i) members.push_back(ordinary.at(next++).values);
        parameters.push_back(count == 1 ? members.front() : vector(members));
    }
    return Domain(std::move(parameters))
        .and_degenerate({.result = function.result, .parameters = function.parameters}, true);
}

}  // namespace gloam::check
