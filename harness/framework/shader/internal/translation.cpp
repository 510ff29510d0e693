// SPDX-License-Identifier: MIT
#include "shader/internal/translation.hpp"

#include <algorithm>
#include <cctype>
#include <regex>
#include <stdexcept>
#include <utility>

#include "shader/internal/declarations.hpp"
#include "shader/internal/front_end.hpp"
#include "shader/internal/lines.hpp"

namespace gloam::shader::internal {
namespace {

using Kind = Piece::Kind;

bool is_opaque(const std::string& type) {
    static const std::regex opaque(R"([iu]?(image|texture|sampler|subpass)\w*(\[.*)?)");
    return std::regex_match(type, opaque);
}

bool is_function(const Piece& piece) {
    return piece.kind == Kind::function || piece.kind == Kind::prototype;
}

// Divides at the commas outside of brackets.
std::vector<std::string> at_commas(const std::string& list) {
    std::vector<std::string> parts(1);
    int depth = 0;
    for (const char c : list) {
        if (c == '(' || c == '[') ++depth;
        if (c == ')' || c == ']') --depth;
        if (c == ',' && depth == 0) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

// A function as its name and parameters, and its body.
struct Divided {
    std::string before;  // "float f("
    std::vector<std::string> parameters;
    std::string behind;  // " { ... }"
};

Divided divided(const std::string& text) {
    const std::size_t open = text.find('(');
    std::size_t close = open;
    for (int depth = 0; close < text.size(); ++close) {
        if (text[close] == '(') ++depth;
        if (text[close] == ')' && --depth == 0) break;
    }
    return {text.substr(0, open + 1), at_commas(text.substr(open + 1, close - open - 1)),
            text.substr(std::min(close + 1, text.size()))};
}

// The name of "in vec2 v[3]"; empty where it has none.
std::string name_of(const std::string& parameter) {
    static const std::regex name(R"(\w+\s+(\w+)\s*(\[.*)?$)");
    std::smatch found;
    return std::regex_search(parameter, found, name) ? found[1].str() : "";
}

// The function with const before each parameter that is no output. One that the function changes gets another
// name, and a copy has its own.
std::string with_const(const std::string& text, const std::set<std::string>& changed) {
    static const std::regex leave(R"(\b(out|inout|const)\b|^\s*(void)?\s*$)");
    Divided function = divided(text);
    std::string copies;
    std::string list;
    for (std::string& parameter : function.parameters) {
        if (!std::regex_search(parameter, leave)) {
            const std::string name = name_of(parameter);
            if (!name.empty() && changed.contains(name)) {
                copies += " " + std::regex_replace(parameter, std::regex(R"(\bin\b)"), "") + " = " + name +
                          "_given;";
                parameter = std::regex_replace(parameter, std::regex("\\b" + name + "\\b"), name + "_given");
            }
            parameter = "const " + parameter;
        }
        list += (list.empty() ? "" : ", ") + parameter;
    }
    const std::size_t body = function.behind.find('{');
    if (body != std::string::npos) function.behind.insert(body + 1, copies);
    return function.before + list + ")" + function.behind;
}

// "vec2[2] name() { return a; }" for "const vec2 a[2] = vec2[2](...);". Empty for what is not such a
// constant.
std::string returned(const std::string& text, const std::string& name) {
    const std::vector<std::string> tokens = tokens_of(text);
    const auto equals = std::ranges::find(tokens, "=");
    if (tokens.empty() || tokens.front() != "const" || equals == tokens.end()) return "";
    const std::vector<std::string> head(tokens.begin() + 1, equals);
    std::size_t own = 0;  // the last word outside of brackets
    for (std::size_t i = 0; i < head.size();) {
        const unsigned char c = static_cast<unsigned char>(head[i].front());
        if (std::isalpha(c) != 0 || c == '_') own = i;
        i = head[i] == "[" ? behind_bracket(head, i) : i + 1;
    }
    std::string type;
    for (std::size_t i = 0; i < head.size(); ++i) type += i == own ? "" : head[i] + " ";
    if (type.find("[ ]") != std::string::npos) return "";  // no type of a function
    return type + name + "() { return " + head[own] + "; }";
}

// Writes the whole shader. A second try knows the parameters that their functions change.
class Writer {
  public:
    Writer(const Source& packed, Stage stage, bool with_images)
        : name_(packed.name), stage_(stage), text_(preprocessed(packed, stage, {})) {
        outline_ = outline(text_);
        declared_ = declarations(text_);
        for (const Declaration& declaration : declared_)
            if (declaration.defined) result_.functions.insert(declaration.name);
        result_.whole = result_.functions.contains("main");
        for (const Declaration& declaration : declared_)
            if (!result_.functions.contains(declaration.name)) result_.supplied.insert(declaration.name);
        with_images_ = with_images && !result_.whole && !result_.supplied.empty();
        if (!result_.whole) require_values();
    }

    Callable run() {
        while (true) {
            const std::string text = written();
            try {
                result_.module = to_spirv({name_, text}, stage_, {});
                return std::move(result_);
            } catch (const CompileError& error) {
                if (!learn(error.what())) throw;
            }
        }
    }

  private:
    void require_values() const {
        for (const Declaration& declaration : declared_)
            for (const DeclaredParameter& parameter : declaration.parameters)
                if (is_opaque(parameter.type))
                    throw std::invalid_argument(name_ + ": " + declaration.name +
                                                " has a parameter of type " + parameter.type +
                                                ": functions with images as parameters are not translated");
    }

    std::string written() {
        function_of_line_.clear();
        std::string text = "#version 450\n";
        for (const std::string& extension : outline_.extensions) text += extension + "\n";
        if (with_images_)
            text += std::string("layout(set = 7, binding = 0) uniform ") + images_type +
                    " { float first; } " + images_name + ";\n";
        for (const Piece& piece : outline_.pieces) {
            if (piece.text.starts_with("#version")) continue;
            const auto first = static_cast<std::size_t>(std::ranges::count(text, '\n'));
            text += is_function(piece) ? function_text(piece) : piece.text;
            text += "\n";
            const auto end = static_cast<std::size_t>(std::ranges::count(text, '\n'));
            for (std::size_t line = first; is_function(piece) && line < end; ++line)
                function_of_line_[line + 1] = piece.names.front();
        }
        return result_.whole ? text : text + main_text();
    }

    std::string function_text(const Piece& piece) {
        const std::string& name = piece.names.front();
        const std::string text = with_const(piece.text, changed_[name]);
        if (result_.whole || !result_.supplied.contains(name)) return text;
        const auto declaration = std::ranges::find(declared_, name, &Declaration::name);
        std::string body;
        if (with_images_) body += std::string(" float used = ") + images_name + ".first;";
        if (declaration->result != "void") body += " " + declaration->result + " result; return result;";
        return text.substr(0, text.rfind(';')) + " {" + body + " }";
    }

    std::string main_text() {
        std::string named;
        std::string text = "layout(local_size_x = 1) in;\nvoid main() {\n";
        result_.constants.clear();
        for (const Piece& piece : outline_.pieces) {
            if (piece.kind != Kind::variable || piece.names.size() != 1) continue;
            const std::string name = constant_prefix + std::to_string(result_.constants.size());
            const std::string function = returned(piece.text, name);
            if (function.empty()) continue;
            named += function + "\n";
            text += name + "();\n";
            result_.constants[name] = piece.names.front();
        }
        std::size_t number = 0;
        for (const Declaration& function : declared_) {
            if (!function.defined && result_.functions.contains(function.name)) continue;
            std::string arguments;
            for (const DeclaredParameter& parameter : function.parameters) {
                const std::string name = "gloam_argument_" + std::to_string(number++);
                text += parameter.type + " " + name + "; ";
                arguments += (arguments.empty() ? "" : ", ") + name;
            }
            text += function.name + "(" + arguments + ");\n";
        }
        return named + text + "}\n";
    }

    // Learns from the compiler which parameters their functions change. Returns whether it learned anything.
    bool learn(const std::string& errors) {
        static const std::regex place(R"(:(\d+): [^\n]*?(l-value required "(\w+)|$))");
        bool learned = false;
        for (std::sregex_iterator i(errors.begin(), errors.end(), place), end; i != end; ++i) {
            const auto found = function_of_line_.find(std::stoul((*i)[1]));
            if (found == function_of_line_.end()) continue;
            std::set<std::string>& changed = changed_[found->second];
            if ((*i)[3].matched && changed.insert((*i)[3]).second) {
                learned = true;
            } else if (changed.insert("").second) {  // the message names none: maybe all of them
                learned = true;
                for (const Declaration& declaration : declared_)
                    if (declaration.name == found->second)
                        for (const std::string& parameter : divided(declaration.head).parameters)
                            changed.insert(name_of(parameter));
            }
        }
        return learned;
    }

    std::string name_;
    Stage stage_;
    bool with_images_ = false;
    std::string text_;
    Outline outline_;
    std::vector<Declaration> declared_;
    Callable result_;
    std::map<std::string, std::set<std::string>> changed_;  // functions, and the parameters that they change
    std::map<std::size_t, std::string> function_of_line_;
};

}  // namespace

Callable callable(const Source& packed, Stage stage, bool with_images) {
    return Writer(packed, stage, with_images).run();
}

namespace {

using Kind = Piece::Kind;

// The lines of comments before the first line of code.
std::string leading_comment(const std::string& text) {
    std::string comment;
    for (const Line& line : split_lines(text)) {
        if (!is_blank(line)) break;
        comment += std::string(line.text);
        if (!comment.ends_with('\n')) comment += '\n';
    }
    return comment;
}

// The name that a line of code declares: the last word before a '[', a '=' or the ';'.
std::string declared_by(const std::string& line) {
    static const std::regex layout(R"(layout\s*\([^)]*\))");
    const std::string code = std::regex_replace(line, layout, "");
    static const std::regex declared(R"((\w+)\s*(\[[^\]]*\]\s*)*(=[^;]*)?;)");
    std::smatch found;
    return std::regex_search(code, found, declared) ? found[1].str() : "";
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first);
}

// The name of a type of HLSL and MSL: "vec2" is "float2", "mat4" is "float4x4".
std::string translated_type(const std::string& type) {
    static const std::regex vector("([biu]?)vec([234])");
    static const std::regex matrix("mat([234])(x[234])?");
    std::smatch found;
    if (std::regex_match(type, found, vector)) {
        const std::string kind = found[1];
        const char* scalar = kind == "b" ? "bool" : kind == "i" ? "int" : kind == "u" ? "uint" : "float";
        return scalar + found[2].str();
    }
    if (std::regex_match(type, found, matrix))
        return "float" + found[1].str() + (found[2].matched ? found[2].str() : "x" + found[1].str());
    return type;
}

// The comment behind each declared name. A line that has nothing but a comment, further to the right than the
// declarations, continues the comment before it.
void add_members(const std::string& text, std::map<std::string, std::string>& behind) {
    std::string last;
    std::size_t column = 0;
    for (const Line& line : split_lines(text)) {
        const std::string comment = trimmed(comments_of(line));
        const std::string declared = declared_by(line.code);
        const std::size_t first = line.text.find_first_not_of(" \t");
        if (!declared.empty() && declared != "}") {
            last = comment.empty() ? "" : declared;
            column = first;
            behind[declared] = comment;
        } else if (!last.empty() && !comment.empty() && is_blank(line) && first > column) {
            behind[last] += "\n" + comment;
        } else {
            last.clear();
        }
    }
}

}  // namespace

Comments::Comments(const Outline& glsl) {
    for (const Piece& piece : glsl.pieces) {
        if (piece.names.empty()) continue;
        const std::string comment = leading_comment(piece.text);
        const std::string& name = piece.names.front();
        if (piece.kind == Kind::function || piece.kind == Kind::prototype) {
            OfFunction own{.parameters = {}, .comment = comment};
            for (const std::string& word : piece.parameter_types)
                own.parameters.push_back(translated_type(word));
            if (!comment.empty()) functions_.emplace(name, std::move(own));
            continue;
        }
        for (const std::string& each : piece.names) above_[each] = comment;
        instances_[name].assign(piece.names.begin() + 1, piece.names.end());
        const bool one_line = piece.text.find('{') == std::string::npos;
        add_members(piece.text, behind_[one_line ? "" : name]);
    }
}

std::string Comments::above_function(const Piece& translated) const {
    const auto [first, end] = functions_.equal_range(translated.names.front());
    std::string best;
    std::ptrdiff_t most = -1;
    for (auto each = first; each != end; ++each) {
        const auto same = std::ranges::count_if(each->second.parameters, [&](const std::string& word) {
            return std::ranges::find(translated.parameter_types, word) != translated.parameter_types.end();
        });
        if (same > most) best = each->second.comment;
        most = std::max<std::ptrdiff_t>(most, same);
    }
    return best;
}

std::string Comments::above(const std::string& name) const {
    const auto found = above_.find(name);
    return found == above_.end() ? "" : found->second;
}

std::string Comments::behind(const std::string& block, const std::string& member) const {
    const auto found = behind_.find(block);
    if (found == behind_.end()) return "";
    const auto comment = found->second.find(member);
    return comment == found->second.end() ? "" : comment->second;
}

std::vector<std::string> Comments::instances(const std::string& block) const {
    const auto found = instances_.find(block);
    return found == instances_.end() ? std::vector<std::string>{} : found->second;
}

}  // namespace gloam::shader::internal
