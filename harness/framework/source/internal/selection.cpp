// SPDX-License-Identifier: MIT
#include "source/internal/selection.hpp"

#include <algorithm>
#include <iterator>
#include <regex>
#include <stdexcept>
#include <utility>

#include "source/lines.hpp"

namespace gloam::shader::internal {
namespace {

using Kind = Piece::Kind;
using Pieces = std::vector<const Piece*>;

constexpr std::size_t widest = 120;  // columns

std::string all_comments(const Piece& piece) {
    std::string comments;
    for (const Line& line : split_lines(piece.text)) comments += comments_of(line) + "\n";
    return comments;
}

// The comment of a prototype as a clause: "eye-linear depth of a pixel, world units".
std::string meaning_of(const Piece& prototype) {
    static const std::regex marks(R"((//+|/\*+|\*+/|\s)+)");
    static const std::regex ends(R"(^ ?(Defined by the user: )?|\.? ?$)");
    return std::regex_replace(std::regex_replace(all_comments(prototype), marks, " "), ends, "");
}

bool is_function(const Piece& piece, const std::string& name) {
    return piece.kind == Kind::function && piece.names.front() == name;
}

bool uses(const Piece& piece, const std::string& name) {
    return !piece.names.empty() && piece.names.front() != name && piece.mentions.contains(name);
}

// The functions to call, and the types of their parameters.
struct Entries {
    std::vector<std::string> functions;
    std::vector<std::string> types;
};

Entries entries_of(const Pieces& pieces, const std::vector<std::string>& wanted) {
    Entries entries;
    for (const std::string& name : wanted) {
        if (std::ranges::any_of(pieces, [&](const Piece* piece) { return uses(*piece, name); })) continue;
        if (std::ranges::count(entries.functions, name) == 0) entries.functions.push_back(name);
        for (const Piece* piece : pieces)
            if (is_function(*piece, name))
                entries.types.insert(entries.types.end(), piece->parameter_types.begin(),
                                     piece->parameter_types.end());
    }
    return entries;
}

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list;
}

// A paragraph of a comment; lines after the first are indented.
std::string paragraph(const std::string& text) {
    static const std::regex word(R"(\S+)");
    std::string lines = "//";
    std::size_t column = lines.size();
    for (auto each = std::sregex_iterator(text.begin(), text.end(), word); each != std::sregex_iterator();
         ++each) {
        if (column + 1 + each->length() > widest) {
            lines += "\n//  ";
            column = 4;
        }
        lines += " " + each->str();
        column += 1 + each->length();
    }
    return lines;
}

}  // namespace

std::vector<std::string> constants_in_comments(const Piece& piece) {
    static const std::regex constant(R"(\b[A-Z][A-Z0-9]*_[A-Z0-9_]*(\*|\b))");
    const std::string comments = all_comments(piece);
    std::vector<std::string> found;
    for (auto each = std::sregex_iterator(comments.begin(), comments.end(), constant);
         each != std::sregex_iterator(); ++each)
        found.push_back(each->str());
    return found;
}

std::string calling_comment(const Pieces& pieces, const std::vector<std::string>& wanted) {
    const Entries entries = entries_of(pieces, wanted);
    std::vector<std::string> structures;
    std::string to_define;
    for (const Piece* piece : pieces) {
        if (piece->names.empty()) continue;
        const std::string& name = piece->names.front();
        if (piece->kind == Kind::structure && std::ranges::count(entries.types, name) != 0)
            structures.push_back(name);
        const bool has_body =
            std::ranges::any_of(pieces, [&](const Piece* p) { return is_function(*p, name); });
        if (piece->kind != Kind::prototype || has_body) continue;
        const std::string meaning = meaning_of(*piece);
        to_define += "\n" + paragraph("Define: " + name + (meaning.empty() ? "" : ": " + meaning));
    }
    if (to_define.empty()) return "";
    std::string text = paragraph("Call: " + listed(entries.functions)) + to_define;
    if (!structures.empty()) text += "\n" + paragraph("Structures to fill in: " + listed(structures));
    return text;
}

using Kind = Piece::Kind;

Selection::Selection(const Outline& outline, std::size_t given)
    : pieces_(outline.pieces), given_(given), kept_(pieces_.size(), false), placed_(pieces_.size(), false) {
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

void Selection::want(const std::vector<std::string>& functions) {
    for (const std::string& name : functions) {
        const bool there = std::ranges::any_of(pieces_, [&](const Piece& piece) {
            return piece.kind == Kind::function && piece.names.front() == name;
        });
        if (!there)
            throw std::invalid_argument("no function " + name + "; it defines: " + listed(given_functions()));
        want_name(name);
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        if (pieces_[i].names.empty() && pieces_[i].kind != Kind::comment) keep(i);
}

std::vector<std::string> Selection::given_functions() const {
    std::vector<std::string> own;
    for (const Piece& piece : pieces_)
        if (piece.kind == Kind::function && piece.file < given_) own.push_back(piece.names.front());
    return own;
}

std::vector<std::string> Selection::usual() const {
    const bool has_main = std::ranges::any_of(pieces_, [](const Piece& p) { return is_function(p, "main"); });
    return has_main ? std::vector<std::string>{"main"} : given_functions();
}

void Selection::want_all_given() {
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        if (pieces_[i].file < given_) keep(i);
}

std::vector<const Piece*> Selection::ordered() {
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

void Selection::want_name(const std::string& name) {
    const auto found = named_.find(name);
    if (found == named_.end()) return;
    for (const std::size_t i : found->second) {
        if (pieces_[i].kind == Kind::function)
            wanted_types_.insert(pieces_[i].parameter_types.begin(), pieces_[i].parameter_types.end());
        keep(i);
    }
}

std::set<std::string> Selection::uses_of(std::size_t i) const {
    std::set<std::string> uses = pieces_[i].mentions;
    const auto renamed = renamed_.find(i);
    if (renamed != renamed_.end()) uses.insert(renamed->second.begin(), renamed->second.end());
    return uses;
}

void Selection::keep(std::size_t first) {
    std::vector<std::size_t> open{first};
    while (!open.empty()) {
        const std::size_t i = open.back();
        open.pop_back();
        if (kept_[i]) continue;
        kept_[i] = true;
        for (const std::string& name : uses_of(i)) {
            const auto found = named_.find(name);
            if (found == named_.end()) continue;
            std::ranges::copy_if(found->second, std::back_inserter(open), [&](std::size_t other) {
                const Kind kind = pieces_[other].kind;
                const bool callable = kind == Kind::function || kind == Kind::prototype;
                return !callable || !pieces_[i].variables.contains(name);
            });
        }
        add_constants_in_comments(pieces_[i], open);
    }
}

void Selection::add_constants_in_comments(const Piece& piece, std::vector<std::size_t>& open) const {
    for (std::string name : constants_in_comments(piece)) {
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

void Selection::keep_comments() {
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

bool Selection::redefines_macros() const {
    return std::ranges::any_of(named_, [this](const auto& name) {
        const auto macro = [this](std::size_t i) { return kept_[i] && pieces_[i].kind == Kind::macro; };
        return name.second.size() > 1 && std::ranges::any_of(name.second, macro);
    });
}

bool Selection::has_body(const std::string& function) const {
    return std::ranges::any_of(named_.at(function),
                               [this](std::size_t i) { return pieces_[i].kind == Kind::function; });
}

bool Selection::is_given_by_user(std::size_t i) const {
    const Piece& piece = pieces_[i];
    if (piece.kind == Kind::interface) return true;
    if (piece.kind == Kind::prototype) return !has_body(piece.names.front());
    return piece.kind == Kind::structure && wanted_types_.contains(piece.names.front());
}

void Selection::place(std::size_t i) {
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

}  // namespace gloam::shader::internal
