// SPDX-License-Identifier: MIT
#include "shader/pack.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>
#include <utility>

#include "shader/include.hpp"
#include "shader/internal/active_text.hpp"
#include "shader/internal/calling.hpp"
#include "shader/internal/compiler_process.hpp"
#include "shader/internal/lines.hpp"
#include "shader/internal/outline.hpp"

namespace gloam::shader {
namespace {

using internal::Outline;
using internal::Piece;
using Kind = Piece::Kind;

// What is kept of an outline, and in which order.
class Selection {
  public:
    Selection(const Outline& outline, std::size_t given)
        : pieces_(outline.pieces),
          given_(given),
          kept_(pieces_.size(), false),
          placed_(pieces_.size(), false) {
        std::map<std::string, std::set<std::string>> macros;  // and what they stand for
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            for (const std::string& name : pieces_[i].names) {
                named_[name].push_back(i);
                if (pieces_[i].kind == Kind::macro) {
                    macros[name] = pieces_[i].mentions;
                } else if (macros.contains(name)) {  // "#define f g" renames what is declared as f
                    for (const std::string& meant : macros[name]) named_[meant].push_back(i);
                    renamed_[i].insert(name);
                }
            }
        }
    }

    // Throws for a function that is not there.
    void want(const std::vector<std::string>& functions) {
        for (const std::string& name : functions) {
            const bool there = std::ranges::any_of(pieces_, [&](const Piece& piece) {
                return piece.kind == Kind::function && piece.names.front() == name;
            });
            if (!there) throw std::invalid_argument("there is no function \"" + name + "\"");
            want_name(name);
        }
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            if (pieces_[i].names.empty() && pieces_[i].kind != Kind::comment) keep(i);
    }

    // The names of what is wanted where nobody says so.
    [[nodiscard]] std::vector<std::string> usual() const {
        std::vector<std::string> own;
        for (const Piece& piece : pieces_) {
            if (piece.kind != Kind::function) continue;
            if (piece.names.front() == "main") return {"main"};
            if (piece.file < given_) own.push_back(piece.names.front());
        }
        return own;
    }

    // All that the texts declare themselves, of texts without a function.
    void want_all_given() {
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            if (pieces_[i].file < given_) keep(i);
    }

    [[nodiscard]] std::vector<const Piece*> ordered() {
        keep_comments();
        const bool movable = !redefines_macros();
        for (const bool prototypes : {true, false})
            for (std::size_t i = 0; movable && i < pieces_.size(); ++i)
                if (kept_[i] && is_given_by_user(i) && (pieces_[i].kind == Kind::prototype) == prototypes)
                    place(i);
        for (std::size_t i = 0; i < pieces_.size(); ++i)
            if (kept_[i]) place(i);
        return std::move(order_);
    }

  private:
    void want_name(const std::string& name) {
        const auto found = named_.find(name);
        if (found == named_.end()) return;
        for (const std::size_t i : found->second) {
            if (pieces_[i].kind == Kind::function)
                wanted_types_.insert(pieces_[i].parameter_types.begin(), pieces_[i].parameter_types.end());
            keep(i);
        }
    }

    // A macro that gives a declaration another name belongs to it.
    [[nodiscard]] std::set<std::string> uses_of(std::size_t i) const {
        std::set<std::string> uses = pieces_[i].mentions;
        const auto renamed = renamed_.find(i);
        if (renamed != renamed_.end()) uses.insert(renamed->second.begin(), renamed->second.end());
        return uses;
    }

    // And all that it mentions, and so on.
    void keep(std::size_t first) {
        std::vector<std::size_t> open{first};
        while (!open.empty()) {
            const std::size_t i = open.back();
            open.pop_back();
            if (kept_[i]) continue;
            kept_[i] = true;
            for (const std::string& name : uses_of(i)) {
                const auto found = named_.find(name);
                if (found != named_.end())
                    open.insert(open.end(), found->second.begin(), found->second.end());
            }
            add_constants_in_comments(pieces_[i], open);
        }
    }

    // A comment may name values that no function reads: "GLOAM_FALLOFF_*" says what a member may hold.
    void add_constants_in_comments(const Piece& piece, std::vector<std::size_t>& open) const {
        for (std::string name : internal::constants_in_comments(piece)) {
            const bool family = name.ends_with('*');
            if (family) name.pop_back();
            for (auto found = named_.lower_bound(name); found != named_.end(); ++found) {
                if (family ? !found->first.starts_with(name) : found->first != name) break;
                std::ranges::copy_if(found->second, std::back_inserter(open), [this](std::size_t i) {
                    return pieces_[i].kind == Kind::variable || pieces_[i].kind == Kind::macro;
                });
            }
        }
    }

    // A comment that stands by itself belongs to what follows in its file, up to the next one.
    void keep_comments() {
        std::map<std::size_t, std::size_t> last;  // comment of each file
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            if (pieces_[i].kind == Kind::comment) {
                last[pieces_[i].file] = i;
            } else if (kept_[i] && last.contains(pieces_[i].file)) {
                const std::size_t comment = last.extract(pieces_[i].file).mapped();
                kept_[comment] = true;
                comments_[i] = comment;
            }
        }
    }

    // Then the order in which they stand means something.
    [[nodiscard]] bool redefines_macros() const {
        return std::ranges::any_of(named_, [this](const auto& name) {
            const auto macro = [this](std::size_t i) { return kept_[i] && pieces_[i].kind == Kind::macro; };
            return name.second.size() > 1 && std::ranges::any_of(name.second, macro);
        });
    }

    [[nodiscard]] bool has_body(const std::string& function) const {
        return std::ranges::any_of(named_.at(function),
                                   [this](std::size_t i) { return pieces_[i].kind == Kind::function; });
    }

    [[nodiscard]] bool is_given_by_user(std::size_t i) const {
        const Piece& piece = pieces_[i];
        if (piece.kind == Kind::interface) return true;
        if (piece.kind == Kind::prototype) return !has_body(piece.names.front());
        return piece.kind == Kind::structure && wanted_types_.contains(piece.names.front());
    }

    // Behind what it uses of what stands before it: a text declares before it uses.
    void place(std::size_t i) {
        if (placed_[i]) return;
        placed_[i] = true;
        std::set<std::size_t> used;
        for (const std::string& name : uses_of(i)) {
            const auto found = named_.find(name);
            if (found == named_.end()) continue;
            for (const std::size_t other : found->second)
                if (other < i && kept_[other]) used.insert(other);
        }
        for (const std::size_t other : used) place(other);
        const auto comment = comments_.find(i);
        if (comment != comments_.end()) place(comment->second);
        order_.push_back(&pieces_[i]);
    }

    const std::vector<Piece>& pieces_;
    std::size_t given_;
    std::map<std::string, std::vector<std::size_t>> named_;
    std::map<std::size_t, std::set<std::string>> renamed_;  // pieces, and the macros that rename them
    std::set<std::string> wanted_types_;
    std::vector<bool> kept_;
    std::vector<bool> placed_;
    std::map<std::size_t, std::size_t> comments_;  // that stand before a piece
    std::vector<const Piece*> order_;
};

void add_block(std::string& text, const std::string& block, bool apart = true) {
    if (!text.empty()) text += apart ? "\n\n" : "\n";
    text += block;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) add_block(text, line, false);
    return text;
}

// Extensions stand before everything but the version.
// A value as GLSL writes it.
std::string literal(const std::string& type, std::uint32_t bits) {
    if (type == "bool") return bits != 0 ? "true" : "false";
    if (type == "uint") return std::to_string(bits) + "u";
    if (type == "int") return std::to_string(std::bit_cast<std::int32_t>(bits));
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), std::bit_cast<float>(bits)).ptr;
    const std::string digits(text.data(), end);
    return digits.find_first_of(".en") == std::string::npos ? digits + ".0" : digits;
}

// The declaration of a specialization constant with the value asked for.
std::string with_value(const std::string& text, const std::map<std::uint32_t, std::uint32_t>& constants) {
    static const std::regex declaration(
        R"((constant_id\s*=\s*)(\d+)(\s*\)\s*const\s+)(bool|int|uint|float)(\s+\w+\s*=\s*)([^;]+);)");
    std::smatch found;
    if (constants.empty() || !std::regex_search(text, found, declaration)) return text;
    const auto value = constants.find(static_cast<std::uint32_t>(std::stoul(found[2])));
    if (value == constants.end()) return text;
    return found.prefix().str() + found[1].str() + found[2].str() + found[3].str() + found[4].str() +
           found[5].str() + literal(found[4], value->second) + ";" + found.suffix().str();
}

// Interfaces as OpenGL has them: constants of their values, and a uniform block in the place of push
// constants. The members that push constants may have here have the same offsets in std140.
std::string for_opengl(const std::string& text) {
    static const std::regex constant(R"(layout\s*\(\s*constant_id\s*=\s*\d+\s*\)\s*const\b)");
    static const std::regex pushed(R"(layout\s*\(\s*push_constant\s*\)\s*uniform\b)");
    return std::regex_replace(std::regex_replace(text, constant, "const"), pushed,
                              "layout(binding = 0, std140) uniform");
}

std::string written(const Outline& outline, const std::vector<const Piece*>& pieces,
                    const PackRequest& request, const std::string& head) {
    const std::string preamble = shader::preamble(request.language);
    const std::size_t version = preamble.find('\n');
    std::string text = preamble.substr(0, version);
    for (const auto& lines : {outline.licences, outline.extensions})
        if (!lines.empty()) add_block(text, joined(lines), false);
    if (version + 1 < preamble.size())
        add_block(text, preamble.substr(version + 1, preamble.size() - version - 2), false);
    if (!head.empty() && std::ranges::count(outline.heads, head) == 0) add_block(text, head);
    for (const std::string& own : outline.heads) add_block(text, own);
    const Piece* before = nullptr;
    for (const Piece* piece : pieces) {
        const bool same = before && before->paragraph == piece->paragraph && before->file == piece->file;
        const bool adjustable = piece->kind == Kind::interface;
        const std::string set = adjustable ? with_value(piece->text, request.constants) : piece->text;
        const bool vulkan = request.language == Language::vulkan450;
        add_block(text, adjustable && !vulkan ? for_opengl(set) : set, !same);
        before = piece;
    }
    return text + "\n";
}

struct Packed {
    std::string text;
    bool has_main = false;
};

Packed packed(const std::vector<Source>& sources, const PackRequest& request, Stage stage,
              const std::vector<std::filesystem::path>& roots) {
    const internal::ActiveText active = internal::active_text(sources, request.language, stage, roots);
    const Outline outline = internal::outline(active);
    Selection selection(outline, active.given);
    const std::vector<std::string> wanted = request.functions.empty() ? selection.usual() : request.functions;
    selection.want(wanted);
    if (wanted.empty()) selection.want_all_given();
    const std::vector<const Piece*> pieces = selection.ordered();
    const bool has_main = std::ranges::find(wanted, "main") != wanted.end();
    const std::string head = has_main ? "" : internal::calling_comment(pieces, wanted);
    return {written(outline, pieces, request, head), has_main};
}

// The same of each text as it is names its own lines, and those of what it includes.
void check_as_it_is(const Source& source, Language language,
                    const std::vector<std::filesystem::path>& roots) {
    std::string text;
    for (const internal::Line& line : internal::split_lines(source.text)) {
        const auto directive = internal::directive_of(line);
        const bool version = directive && directive->keyword == "version";
        text += version ? std::string("\n") : std::string(line.text);
    }
    check_compiles({source.name, text}, language, roots);
}

}  // namespace

std::string internal::pack_here(const std::vector<Source>& sources, const PackRequest& request,
                                const std::vector<std::filesystem::path>& roots) {
    const Stage stage = request.stage.value_or(usual_stage(request.language));
    const std::string name = sources.empty() ? "nothing" : sources.back().name;
    Packed result;
    try {
        result = packed(sources, request, stage, roots);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(name + ": " + error.what());
    }
    try {
        check_program({name + " as packed", result.text}, !result.has_main, request.language, stage);
    } catch (const CompileError&) {
        if (!result.has_main)
            for (const Source& source : sources) check_as_it_is(source, request.language, roots);
        throw;
    }
    return result.text;
}

std::string pack(const std::vector<std::filesystem::path>& files, const PackRequest& request,
                 const std::vector<std::filesystem::path>& roots) {
    std::vector<Source> sources;
    std::set<std::string> names;
    for (const std::filesystem::path& file : files) {
        const std::string name = std::filesystem::absolute(file).lexically_normal().string();
        if (names.insert(name).second) sources.push_back({name, read_text(file)});
    }
    return pack(sources, request, roots);
}

std::size_t code_lines(std::string_view text) {
    const std::vector<internal::Line> lines = internal::split_lines(text);
    return static_cast<std::size_t>(
        std::ranges::count_if(lines, [](const internal::Line& line) { return !internal::is_blank(line); }));
}

}  // namespace gloam::shader
