// SPDX-License-Identifier: MIT
#include "shader/internal/calling.hpp"

#include <algorithm>
#include <regex>

#include "shader/internal/lines.hpp"

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

}  // namespace gloam::shader::internal
