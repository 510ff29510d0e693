// SPDX-License-Identifier: MIT
#include "audit/own_domain.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <span>

#include "audit/internal/parameter_meaning.hpp"
#include "base/number.hpp"
#include "source/declarations.hpp"
#include "source/tokens.hpp"

namespace gloam::audit {
namespace {

using namespace subject;

using module::Scalar;
using module::Type;
using source::Declaration;

using internal::Kind;
using internal::Meaning;
using internal::usual_high;
using internal::usual_low;

constexpr long usual_index = 7;  // most integer parameters are indices, counts or modes

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

// Of an integer of a property, which must hold for all of them.
std::pair<std::string, Values> any_whole(const Type& type) {
    const bool has_sign = type.scalar == Scalar::int_;
    const long high =
        has_sign ? long{std::numeric_limits<std::int32_t>::max()} : long{std::numeric_limits<Word>::max()};
    const long low = has_sign ? -high - 1 : 0;
    return {fmt::format("{} to {}, half of them 0 to {}", low, high, usual_index),
            in_each(type, either(integers(0, usual_index), either(log_integers(high), integers(low, high))))};
}

// What is said of a value, and its values.
std::pair<std::string, Values> described(const Type& type, const std::optional<Meaning>& meaning) {
    const Scalar scalar = type.scalar;
    if (scalar == Scalar::bool_) return {"false, true", in_each(type, booleans())};
    if (!module::is_float(scalar)) {
        const bool is_range = meaning && meaning->kind == Kind::range;
        const long low = nearest_integer(is_range ? meaning->low : meaning ? 1.0 : 0.0);
        const long high = nearest_integer(is_range ? meaning->high : meaning ? usual_high : usual_index);
        return {fmt::format("{} to {}", low, high), in_each(type, integers(low, high))};
    }
    const double high = std::min(usual_high, format_of(scalar).largest());
    if (!meaning)
        return {fmt::format("-{0:.7g} to {0:.7g}, half of them 0 to 1", high),
                in_each(type, either(without_tiny(uniform(0, 1, scalar), scalar),
                                     signed_log_uniform(usual_low, high, scalar)))};
    if (meaning->kind == Kind::unit)
        return {type.rows == 4 ? "unit quaternions" : "unit vectors", unit_vector(type.rows)};
    if (meaning->kind == Kind::positive)
        return {fmt::format("{:.7g} to {:.7g}", usual_low, high),
                in_each(type, either(log_uniform(usual_low, high, scalar), uniform(1, 1, scalar)))};
    return {fmt::format("{:.7g} to {:.7g}", meaning->low, meaning->high),
            in_each(type, without_tiny(uniform(meaning->low, meaning->high, scalar), scalar))};
}

// The length of the shortest array that a text indexes with this name alone: "weights[i]" where there is
// "float weights[4]". nullopt if there is none.
std::optional<long> indexed_length(source::Tokens tokens, const std::string& name) {
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

// The name of the function that is called with the token at `at` as its whole argument, and which argument
// that is; empty: it is none.
std::pair<std::string, std::size_t> call_with(source::Tokens tokens, std::size_t at) {
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

// The variable that the statement around the token sets; empty: none.
std::string set_around(source::Tokens tokens, std::size_t at) {
    static const std::set<std::string, std::less<>> assignments{
        "=", "+=", "-=", "*=", "/=", "%=", "^=", "|=", "&=", "<<=", ">>="};
    std::string target;
    for (; at > 1 && tokens[at] != ";" && tokens[at] != "{" && tokens[at] != "}"; --at)
        if (assignments.contains(tokens[at].text))
            target = tokens[tokens[at - 2] == "." && at > 2 ? at - 3 : at - 1].text;
    return target;
}

// What a function does with an integer.
enum class Use {
    unknown,
    count,  // of rounds or bits
    bits    // reads single ones, by shifts, masks, and functions of bits and packed numbers; mixes them
};

// Whether the token is the limit of a loop: "; i < n".
bool is_limit(source::Tokens tokens, std::size_t at) {
    if (at < 4 || (tokens[at - 1] != "<" && tokens[at - 1] != "<=")) return false;
    return tokens[at - 3] == ";" || tokens[at - 4] == "while";
}

// That of a parameter or variable itself; else in what it sets and where it is passed on, bits before counts.
// `asked`: functions and variables that were asked before.
Use use_of(const std::vector<source::Declaration>& text, const std::string& function, const std::string& name,
           std::set<std::pair<std::string, std::string>>& asked) {
    if (!asked.emplace(function, name).second) return Use::unknown;
    static const std::set<std::string, std::less<>> of_bits{
        "uintBitsToFloat", "bitfieldExtract", "bitfieldReverse", "unpackHalf2x16",
        "unpackUnorm2x16", "unpackSnorm2x16", "unpackUnorm4x8",  "unpackSnorm4x8"};
    static const std::set<std::string, std::less<>> takes{">>", "&", ">>=", "&=", "^", "^="};
    Use use = Use::unknown;
    for (const source::Declaration& declared : text) {
        if (!declared.defines(function)) continue;
        const source::Tokens body = source::Tokens(declared.tokens).subspan(declared.function->body);
        for (std::size_t i = 1; i + 1 < body.size(); ++i) {
            if (body[i] != name || body[i - 1] == ".") continue;
            const std::string& before = body[i - 1].text;
            const std::string& after = body[body[i + 1] == "." && i + 3 < body.size() ? i + 3 : i + 1].text;
            if (before == "<<" || before == ">>" || is_limit(body, i)) return Use::count;
            const auto [called, argument] = call_with(body, i);
            if (takes.contains(after) || before == "&" || before == "^" || of_bits.contains(called))
                use = std::max(use, Use::bits);
            if (const std::string target = set_around(body, i); !target.empty())
                use = std::max(use, use_of(text, function, target, asked));
            for (const source::Declaration& other : text)
                if (other.defines(called) && argument < other.function->parameters.size())
                    use =
                        std::max(use, use_of(text, called, other.function->parameters[argument].name, asked));
        }
    }
    return use;
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

// Those of all parts, as of one parameter.
Values joined(std::span<const OrdinaryValues> parts) {
    std::vector<Values> values;
    for (const OrdinaryValues& part : parts) values.push_back(part.values);
    return values.size() == 1 ? values.front() : vector(values);
}

// The values of a parameter, or of a member of one.
class Ordinary {
  public:
    Ordinary(const OwnFunction& own, const Ranges& ranges)
        : own_(own),
          ranges_(ranges),
          text_(outline(source::whole_text(own.text)).declarations),
          tokens_(source::tokens_of(own.text)) {
        for (const module::Parameter& parameter : own.function.parameters) names_.insert(parameter.name);
    }

    void add(const Type& type, const std::string& name, std::vector<OrdinaryValues>& all) const {
        if (!type.sizes.empty()) return add_array(type, name, all);
        if (type.scalar == Scalar::structure) {
            for (const module::Member& member : type.members) add(member.type, name + "." + member.name, all);
        } else if (type.scalar == Scalar::sampler) {
            all.push_back({name, "random images", "type", vector(std::vector<Values>{})});
        } else {
            const auto [meaning, reason] = meaning_of(type, name);
            const auto [text, values] = reason == "property" ? any_whole(type) : described(type, meaning);
            all.push_back({name, text, reason, values});
        }
    }

  private:
    // Every element has the values of one.
    void add_array(const Type& type, const std::string& name, std::vector<OrdinaryValues>& all) const {
        Type element = type;
        element.sizes.clear();
        std::vector<OrdinaryValues> parts;
        add(element, name, parts);
        int count = 1;
        for (const std::uint32_t size : type.sizes) count *= static_cast<int>(size);
        std::vector<OrdinaryValues> elements;
        for (int i = 0; i < count; ++i) elements.insert(elements.end(), parts.begin(), parts.end());
        all.push_back({name, fmt::format("{} of {}", count, text_of(parts)), reason_of(parts),
                       parts.size() == 1 ? vector(count, parts[0].values) : joined(elements)});
    }

    // What is known of a value, and why.
    [[nodiscard]] std::pair<std::optional<Meaning>, std::string> meaning_of(const Type& type,
                                                                            const std::string& name) const {
        const int components = type.columns * type.rows;
        const bool is_float = module::is_float(type.scalar);
        const bool is_whole = !is_float && type.scalar != Scalar::bool_;
        const bool is_vector = type.scalar == Scalar::float_ && type.columns == 1 && components > 1;
        const std::string last = name.substr(name.rfind('.') + 1);
        if (const auto range = range_of(ranges_, name))
            return {Meaning{Kind::range, range->low, range->high}, "--range"};
        if (is_float || is_whole)
            if (const auto meaning = internal::meaning_of_comment(own_.comment, last, names_, is_vector))
                return {meaning, "comment"};
        if (is_whole)
            if (const auto length = indexed_length(tokens_, last))
                return {Meaning{Kind::range, 0.0, static_cast<double>(*length - 1)}, "array"};
        std::set<std::pair<std::string, std::string>> asked;
        const Use use = is_whole ? use_of(text_, own_.function.name, name, asked) : Use::unknown;
        if (type.scalar == Scalar::uint_ && use == Use::bits)
            return {Meaning{Kind::range, 0.0, 0x1p32 - 1.0}, "bits"};
        if (is_whole && use != Use::count && own_.is_property()) return {std::nullopt, "property"};
        if (is_float && type.columns > 1) return {Meaning{Kind::range, -2.0, 2.0}, "type"};
        if (is_float)
            if (const auto meaning = internal::meaning_of_name(last, components);
                meaning && (meaning->kind != Kind::unit || is_vector))
                return {meaning, "name"};
        return {std::nullopt, "type"};
    }

    const OwnFunction& own_;
    const Ranges& ranges_;
    std::vector<source::Declaration> text_;
    std::vector<source::Token> tokens_;
    std::set<std::string> names_;
};

// The same values in each invocation of a quad, as one entry.
OrdinaryValues in_quad(const module::Parameter& parameter, const Type& type,
                       const std::vector<OrdinaryValues>& parts) {
    const bool pixels = parameter.name == fragment_coordinate;
    return {parameter.name, pixels ? "the pixels of a quad" : "neighbours, each " + text_of(parts),
            pixels ? "type" : reason_of(parts), neighbours(type, joined(parts), pixels)};
}

}  // namespace

std::vector<OrdinaryValues> ordinary_values(const OwnFunction& own, const Ranges& ranges) {
    const Ordinary ordinary(own, ranges);
    std::vector<OrdinaryValues> all;
    for (const module::Parameter& parameter : own.function.parameters) {
        if (parameter.direction == source::Direction::out) continue;
        if (own.team.kind != backend::Team::Kind::quad || !is_of_each(parameter)) {
            ordinary.add(parameter.type, parameter.name, all);
            continue;
        }
        const Type type = module::element_of(parameter.type);
        std::vector<OrdinaryValues> parts;
        ordinary.add(type, parameter.name, parts);
        all.push_back(in_quad(parameter, type, parts));
    }
    return all;
}

Domain ordinary_domain(const module::Function& function, const std::vector<OrdinaryValues>& ordinary) {
    std::vector<Values> parameters;
    std::size_t next = 0;
    for (const module::Parameter& parameter : function.parameters) {
        if (parameter.direction == source::Direction::out) continue;
        const std::size_t count = value_names(parameter.type, parameter.name).size();
        parameters.push_back(joined(std::span(ordinary).subspan(next, count)));
        next += count;
    }
    return Domain(std::move(parameters))
        .and_degenerate({.result = function.result, .parameters = function.parameters}, true);
}

}  // namespace gloam::audit
