// SPDX-License-Identifier: MIT
#include "shader/pack.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>
#include <tuple>

#include "shader/internal/compiler_process.hpp"
#include "shader/internal/cross.hpp"
#include "shader/internal/front_end.hpp"
#include "shader/internal/lines.hpp"
#include "shader/internal/outline.hpp"
#include "shader/internal/translation.hpp"

namespace gloam::shader::internal {
namespace {

std::string replaced(const std::string& text, const std::regex& pattern,
                     const std::function<std::string(const std::smatch&)>& replacement) {
    std::string result;
    auto rest = text.cbegin();
    for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i) {
        result.append(rest, (*i)[0].first);
        result += replacement(*i);
        rest = (*i)[0].second;
    }
    return result.append(rest, text.cend());
}

// The shortest text of the float that a decimal number stands for; the number itself if it is no float, or if
// a compiler that reads a double first would find another float.
std::string shortest(const std::string& number) {
    float value = 0.0F;
    const char* const end = number.data() + number.size();
    if (const auto read = std::from_chars(number.data(), end, value);
        read.ptr != end || read.ec != std::errc{})
        return number;
    std::array<char, 32> buffer{};
    const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    std::string text(buffer.data(), written.ptr);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    double wide = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), wide);
    return static_cast<float>(wide) == value ? text : number;
}

// Whether an expression may be calculated where it is not needed.
bool costs_nothing(const std::string& expression) {
    static const std::regex call(R"((\w+)\()");
    static const std::set<std::string> known{"abs",   "all",   "any",   "min",    "max",    "dot",
                                             "bool2", "bool3", "bool4", "float2", "float3", "float4",
                                             "int2",  "int3",  "uint2", "float",  "int",    "uint"};
    for (std::sregex_iterator i(expression.begin(), expression.end(), call), end; i != end; ++i)
        if (!known.contains((*i)[1])) return false;
    return expression.find('[') == std::string::npos;
}

std::string with_short_numbers(const std::string& text) {
    static const std::regex number(R"(\b\d+\.\d+(e[+-]?\d+)?)");
    return replaced(text, number, [](const std::smatch& found) { return shortest(found.str()); });
}

std::string with_logical_operators(const std::string& text, Target target) {
    static const std::regex chosen(
        R"(if \((!?)(_\d+)\)\n *\{\n *(_\d+) = ([^\n]*);\n *\}\n *else\n *\{\n *\3 = \2;\n *\})");
    static const std::regex declared(R"(bool (_\d+);\n *\1 = )");
    const std::string operators = replaced(text, chosen, [target](const std::smatch& found) {
        if (target == Target::hlsl && !costs_nothing(found[4])) return found.str();
        const char* sign = found[1].length() == 0 ? " && (" : " || (";
        return found[3].str() + " = " + found[2].str() + sign + found[4].str() + ");";
    });
    return replaced(operators, declared,
                    [](const std::smatch& found) { return "bool " + found[1].str() + " = "; });
}

std::string with_named_macros(std::string text) {
    static const std::regex constant(R"(static const \w+ (\w+) = (SPIRV_CROSS_CONSTANT_ID_\d+);)");
    std::smatch found;
    while (std::regex_search(text, found, constant)) {
        std::string macro = "GLOAM_" + found[1].str();
        std::ranges::transform(macro, macro.begin(),
                               [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
        const std::regex old(found[2].str() + "\\b");
        text = std::regex_replace(text, old, macro);
    }
    return text;
}

// Without the samplers of images that are only fetched from: GLSL has them, other languages need none.
std::string without_idle_samplers(std::string text, Target target) {
    static const std::regex hlsl(R"(SamplerState (\w+) : register\([^)]*\);\n)");
    static const std::regex msl(R"(, sampler (\w+) \[\[sampler\(\d+\)\]\])");
    const std::string all = text;
    const std::regex& declared = target == Target::hlsl ? hlsl : msl;
    for (std::sregex_iterator i(all.begin(), all.end(), declared), end; i != end; ++i) {
        const std::string name = (*i)[1];
        const std::regex used(target == Target::hlsl ? "[(,] ?" + name + "\\b" : "\\.\\w+\\(" + name + "\\b");
        if (std::regex_search(all, used)) continue;
        text.erase(text.find((*i)[0]), static_cast<std::size_t>((*i)[0].length()));
        text = std::regex_replace(text, std::regex(", (sampler )?" + name + "\\b"), "");
    }
    return text;
}

}  // namespace

std::string tidy(const std::string& text, Target target) {
    const std::string numbers = without_idle_samplers(with_short_numbers(text), target);
    if (target == Target::hlsl) {
        static const std::regex component(R"((\d[\w.+-]*f)\.x+\.[xyzw]\b)");  // of a vector of one number
        return with_logical_operators(std::regex_replace(with_named_macros(numbers), component, "$1"),
                                      target);
    }
    static const std::regex linkage(R"(static inline __attribute__\(\(always_inline\)\)\n)");
    return with_logical_operators(std::regex_replace(numbers, linkage, ""), target);
}

}  // namespace gloam::shader::internal

namespace gloam::shader {
namespace {

using internal::Callable;
using internal::Comments;
using internal::Outline;
using internal::Piece;
using Kind = Piece::Kind;

constexpr const char* only_functions = "only_functions";  // the entry point that is taken out again

// The name of the entry point, from that of the text.
std::string entry_of(const std::string& name) {
    std::string stem = std::filesystem::path(name).stem().string();
    std::ranges::replace_if(stem, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    const bool word = !stem.empty() && std::isdigit(static_cast<unsigned char>(stem.front())) == 0;
    return (word ? stem : "_" + stem) + "_main";
}

bool is_scaffold(const Piece& piece) {
    static const std::vector<std::string> names{"main", "comp_main", only_functions, "gl_WorkGroupSize"};
    return std::ranges::any_of(piece.names, [](const std::string& name) {
        return std::ranges::find(names, name) != names.end() || name.starts_with(internal::constant_prefix);
    });
}

// Members of a structure or block, with the comments that they had.
std::string with_member_comments(const std::string& text, const std::string& block,
                                 const Comments& comments) {
    static const std::regex member(R"((\w+)(\[[^\]]*\])*( : packoffset\([^)]*\))?;\s*$)");
    std::string result;
    for (const internal::Line& line : internal::split_lines(text)) {
        std::string written(line.text);
        std::smatch found;
        const bool ends = written.ends_with('\n');
        if (ends) written.pop_back();
        if (std::regex_search(written, found, member)) {
            // A block's members carry the name of its instance; a word of the language has a digit appended.
            std::string name = found[1];
            for (const std::string& prefix : comments.instances(block))
                if (name.starts_with(prefix + "_")) name = name.substr(prefix.size() + 1);
            std::string comment = comments.behind(block, name);
            if (comment.empty() && name.ends_with('0'))
                comment = comments.behind(block, name.substr(0, name.size() - 1));
            if (comment.find('\n') == std::string::npos) {
                if (!comment.empty()) written += "  " + comment;
            } else {
                const std::string indent = written.substr(0, written.find_first_not_of(' '));
                written =
                    indent + std::regex_replace(comment, std::regex("\n"), "\n" + indent) + "\n" + written;
            }
        }
        result += written + (ends ? "\n" : "");
    }
    return result;
}

class Writer {
  public:
    Writer(const Source& packed, Target target, Stage stage)
        : packed_(packed),
          target_(target),
          stage_(stage),
          glsl_(internal::outline(packed.text)),
          comments_(glsl_) {}

    std::string run() {
        const std::string body = body_of(with_names_of_constants(internal::tidy(raw(), target_)));
        std::string text = head() + registers_line(body);
        for (const std::string& comment : glsl_.heads) text += "\n" + comment + "\n";
        text += "\n" + body;
        check(text);
        return text;
    }

  private:
    std::string raw() {
        if (target_ == Target::msl) require_no_double();
        callable_ = internal::callable(packed_, stage_, target_ == Target::msl);
        if (target_ == Target::hlsl) return internal::to_direct3d_hlsl(callable_.module);
        return internal::to_msl(callable_.module, callable_.whole ? entry_of(packed_.name) : only_functions);
    }

    void require_no_double() const {
        static const std::regex doubles(R"(double|dvec[234]|dmat[234]\w*)");
        for (const Piece& piece : glsl_.pieces)
            for (const std::string& name : piece.mentions)
                if (std::regex_match(name, doubles))
                    throw std::invalid_argument(packed_.name + ": MSL has no " + name);
    }

    // The functions for constants tell which number is which: "{ return _12; }", of an array "{ x = _12; }".
    [[nodiscard]] std::string with_names_of_constants(std::string text) const {
        static const std::regex named(std::string(internal::constant_prefix) +
                                      R"((\d+)\([^)]*\)\s*\{\s*(?:return|\w+ =) (_\d+);)");
        std::map<std::string, std::string> names;
        for (std::sregex_iterator i(text.begin(), text.end(), named), end; i != end; ++i)
            if (const auto found = callable_.constants.find(internal::constant_prefix + (*i)[1].str());
                found != callable_.constants.end())
                names.emplace((*i)[2], found->second);
        for (const auto& [number, name] : names)
            text = std::regex_replace(text, std::regex("\\b" + number + "\\b"), name);
        return text;
    }

    [[nodiscard]] std::string body_of(const std::string& text) const {
        std::string result;
        std::size_t paragraph = 0;
        bool within_directives = false;
        const Outline outline = internal::outline(text);
        for (const Piece& piece : outline.pieces) {
            const std::string written = piece_text(piece);
            if (written.empty()) continue;
            const bool apart = written.front() == '#' ? !within_directives : paragraph != piece.paragraph;
            const bool follows = within_directives && callable_.whole && target_ == Target::hlsl;
            if (!result.empty() && apart && !follows) result += "\n";
            within_directives = written.front() == '#';
            paragraph = piece.paragraph;
            result += written + "\n";
        }
        return result;
    }

    // With its comment; empty for what the user does not need.
    [[nodiscard]] std::string piece_text(const Piece& piece) const {
        static const std::regex resource(R"((\w+)(\[\d*\])? : register\()");
        static const std::regex block(R"(^cbuffer (\w+))");
        std::smatch found;
        if (std::regex_search(piece.text, found, block))
            return comments_.above(found[1]) + with_member_comments(piece.text, found[1], comments_);
        if (std::regex_search(piece.text, found, resource) && piece.text.find('{') == std::string::npos) {
            const std::string behind = comments_.behind("", found[1]);
            return comments_.above(found[1]) + piece.text + (behind.empty() ? "" : "  " + behind);
        }
        if (!callable_.whole && is_scaffold(piece)) return "";
        if (piece.names.empty()) return piece.text == ";" ? "" : piece.text;
        const std::string& name = piece.names.front();
        if (name == internal::images_type)
            return "struct " + name + ";  // the user's: what the functions without a body read";
        if (piece.kind == Kind::function) return function_text(piece, name);
        return comments_.above(name) + with_member_comments(piece.text, name, comments_);
    }

    [[nodiscard]] std::string function_text(const Piece& piece, const std::string& name) const {
        static const std::regex images(std::string("constant ") + internal::images_type + "&");
        std::string text = piece.text;
        const bool supplied = callable_.supplied.contains(name) && !callable_.whole;
        if (supplied) {
            text = text.substr(0, text.find('{'));
            text = text.substr(0, text.find_last_not_of(" \n") + 1) + ";";
        }
        if (target_ == Target::msl) {
            text =
                std::regex_replace(text, images, std::string("thread const ") + internal::images_type + "&");
            if (!supplied && callable_.functions.contains(name)) text = "static inline " + text;
        }
        return comments_.above_function(piece) + text;
    }

    [[nodiscard]] std::string head() const {
        std::string text;
        for (const std::string& licence : glsl_.licences) text += licence + "\n";
        return text + (target_ == Target::hlsl ? "// HLSL of shader model 6.0, translated from GLSL by "
                                                 "SPIRV-Cross. Compile it by IEEE's "
                                                 "rules (dxc -Gis).\n"
                                               : "// Metal Shading Language 2.1, translated from GLSL by "
                                                 "SPIRV-Cross. Compile it without "
                                                 "fast math.\n");
    }

    // "// Registers: t0 depth_image, u3 history."
    [[nodiscard]] std::string registers_line(const std::string& body) const {
        static const std::regex hlsl(R"((\w+)(?:\[\d*\])? : register\((\w+))");
        static const std::regex msl(R"((\w+) \[\[((?:texture|buffer|sampler)\(\d+\))\]\])");
        const std::regex& pattern = target_ == Target::hlsl ? hlsl : msl;
        std::vector<std::pair<std::string, std::string>> places;
        for (std::sregex_iterator i(body.begin(), body.end(), pattern), end; i != end; ++i)
            places.emplace_back((*i)[2], (*i)[1]);
        const auto key = [](const auto& place) {  // t2 stands before t10
            const std::string kind = place.first.substr(0, place.first.find_first_of("0123456789"));
            return std::tuple(kind, place.first.size(), place.first);
        };
        std::ranges::sort(places, {}, key);
        std::string list;
        for (const auto& [place, name] : places) list += (list.empty() ? "" : ", ") + place + " " + name;
        if (list.empty()) return "";
        return std::string(target_ == Target::hlsl ? "// Registers: " : "// Indices: ") + list + ".\n";
    }

    // That the result is whole, as far as it can be seen here.
    void check(const std::string& text) const {
        const Outline outline = internal::outline(text);
        for (const std::string& name : callable_.functions) {
            const bool there = std::ranges::any_of(outline.pieces, [&name](const Piece& piece) {
                return piece.kind == Kind::function && piece.names.front() == name;
            });
            if (!there && name != "main")
                throw std::invalid_argument(packed_.name + ": the translation lost " + name + "()");
        }
        if (target_ != Target::hlsl) return;
        const char* entry = "\n[numthreads(1, 1, 1)]\nvoid main()\n{\n}\n";
        static_cast<void>(internal::hlsl_to_spirv(
            {packed_.name + " as HLSL", callable_.whole ? text : text + entry}, stage_));
    }

    const Source& packed_;
    Target target_;
    Stage stage_;
    Outline glsl_;
    Comments comments_;
    Callable callable_;
};

}  // namespace

std::optional<Target> target_from(std::string_view name) {
    if (name == "hlsl") return Target::hlsl;
    if (name == "msl") return Target::msl;
    return std::nullopt;
}

std::string suffix(Target target) {
    return target == Target::hlsl ? ".hlsl" : ".metal";
}

std::string internal::translated_here(const Source& packed, Target target, Stage stage) {
    try {
        return Writer(packed, target, stage).run();
    } catch (const CompileError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw std::invalid_argument(packed.name + ": " + error.what());
    }
}

}  // namespace gloam::shader
