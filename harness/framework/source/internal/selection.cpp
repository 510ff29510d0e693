// SPDX-License-Identifier: MIT
#include "source/internal/selection.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "base/pattern.hpp"
#include "source/lines.hpp"

namespace gloam::source {
namespace {

using Kind = Declaration::Kind;

std::string all_comments(const Declaration& one) {
    std::string comments;
    for (const Line& line : split_lines(one.text)) comments += comments_of(line) + "\n";
    return comments;
}

// The comment of a prototype as a clause: "eye-linear depth of a pixel, world units".
std::string meaning_of(const Declaration& prototype) {
    static const base::Pattern marks(R"((//+|/\*+|\*{1,120}/|\s)+)");
    static const base::Pattern ends(R"(^ ?(Defined by the user: )?|\.? ?$)");
    return ends.replaced(marks.replaced(all_comments(prototype), " "), "");
}

bool uses(const Declaration& one, const std::string& name) {
    return !one.names.empty() && one.names.front() != name && one.mentions.contains(name);
}

void add_parameter_types(const Declaration& function, std::set<std::string>& types) {
    for (const Token& token : function.parameter_list())
        if (token.is_word()) types.insert(token.text);
}

// A paragraph of a comment; lines after the first are indented.
std::string paragraph(const std::string& text) {
    constexpr std::size_t widest = 120;  // columns
    std::string lines = "//";
    std::size_t column = lines.size();
    std::istringstream words(text);
    for (std::string word; words >> word; column += 1 + word.size()) {
        if (column + 1 + word.size() > widest) {
            lines += "\n//  ";
            column = 4;
        }
        lines += " " + word;
    }
    return lines;
}

// The constants that comments name: "FX_STEP" as it is, "FX_FALLOFF_*" for every name that begins so. Names
// have no lower-case letters.
std::vector<std::string> constants_in(const std::string& comments) {
    static const base::Pattern constant(R"(\b[A-Z][A-Z0-9]*_[A-Z0-9_]*(\*|\b))");
    return constant.all(comments);
}

class Selection {
  public:
    explicit Selection(const Outline& outline)
        : all_(outline.declarations), kept_(all_.size(), false), placed_(all_.size(), false) {
        std::map<std::string, std::set<std::string>> macros;  // and what they stand for
        for (std::size_t i = 0; i < all_.size(); ++i) {
            uses_.push_back(all_[i].mentions);
            for (const std::string& name : all_[i].names) {
                named_[name].push_back(i);
                if (all_[i].kind == Kind::macro) {
                    macros[name] = all_[i].mentions;
                } else if (macros.contains(name)) {  // "#define f g" renames what is declared as f
                    for (const std::string& meant : macros[name]) named_[meant].push_back(i);
                    uses_[i].insert(name);  // the macro belongs to the declaration
                }
            }
        }
    }

    // Keeps these functions, and every declaration without a name. `known`: for the message.
    void want(const std::vector<std::string>& functions, const std::vector<std::string>& known) {
        for (const std::string& name : functions) {
            if (std::ranges::none_of(all_, [&](const Declaration& one) { return one.defines(name); }))
                throw std::invalid_argument(
                    fmt::format("no function {}; it defines: {}", name, fmt::join(known, ", ")));
            for (const std::size_t i : named_[name]) {
                if (all_[i].kind == Kind::function) add_parameter_types(all_[i], wanted_types_);
                keep(i);
            }
        }
        for (std::size_t i = 0; i < all_.size(); ++i)
            if (all_[i].names.empty() && all_[i].kind != Kind::comment) keep(i);
    }

    // And all that it mentions, and so on.
    void keep(std::size_t first) {
        std::vector<std::size_t> open{first};
        while (!open.empty()) {
            const std::size_t i = open.back();
            open.pop_back();
            if (kept_[i]) continue;
            kept_[i] = true;
            for (const std::string& name : uses_[i])
                std::ranges::copy_if(named_[name], std::back_inserter(open), [&](std::size_t other) {
                    const Kind kind = all_[other].kind;
                    const bool callable = kind == Kind::function || kind == Kind::prototype;
                    return !callable || !all_[i].variables.contains(name);
                });
            add_constants_in_comments(all_[i], open);
        }
    }

    [[nodiscard]] bool keeps(std::size_t declaration) const { return kept_[declaration]; }

    [[nodiscard]] std::vector<const Declaration*> ordered() {
        keep_comments();
        const bool movable = !redefines_macros();
        for (const bool prototypes : {true, false})
            for (std::size_t i = 0; movable && i < all_.size(); ++i)
                if (kept_[i] && is_given_by_user(i) && (all_[i].kind == Kind::prototype) == prototypes)
                    place(i);
        for (std::size_t i = 0; i < all_.size(); ++i)
            if (kept_[i]) place(i);
        return std::move(order_);
    }

  private:
    // A comment may name values that no function reads: "GLOAM_FALLOFF_*" says what a member may hold.
    void add_constants_in_comments(const Declaration& one, std::vector<std::size_t>& open) const {
        for (std::string name : constants_in(all_comments(one))) {
            const bool family = name.ends_with('*');
            if (family) name.pop_back();
            for (auto found = named_.lower_bound(name); found != named_.end(); ++found) {
                if (family ? !found->first.starts_with(name) : found->first != name) break;
                std::ranges::copy_if(found->second, std::back_inserter(open), [this](std::size_t i) {
                    return all_[i].kind == Kind::variable || all_[i].kind == Kind::macro;
                });
            }
        }
    }

    // A comment that stands by itself belongs to what follows in its file, up to the next one.
    void keep_comments() {
        std::map<std::size_t, std::size_t> last;  // comment of each file
        for (std::size_t i = 0; i < all_.size(); ++i) {
            if (all_[i].kind == Kind::comment) {
                last[all_[i].file] = i;
            } else if (kept_[i] && last.contains(all_[i].file)) {
                comments_[i] = last.extract(all_[i].file).mapped();
                kept_[comments_[i]] = true;
            }
        }
    }

    // Then the order in which they stand means something.
    [[nodiscard]] bool redefines_macros() const {
        return std::ranges::any_of(named_, [this](const auto& name) {
            const auto macro = [this](std::size_t i) { return kept_[i] && all_[i].kind == Kind::macro; };
            return name.second.size() > 1 && std::ranges::any_of(name.second, macro);
        });
    }

    [[nodiscard]] bool is_given_by_user(std::size_t i) {
        const Declaration& one = all_[i];
        if (one.kind == Kind::prototype)
            return std::ranges::none_of(named_[one.names.front()],
                                        [this](std::size_t k) { return all_[k].kind == Kind::function; });
        return one.kind == Kind::interface ||
               (one.kind == Kind::structure && wanted_types_.contains(one.names.front()));
    }

    // Behind what it uses of what stands before it: a text declares before it uses.
    void place(std::size_t i) {
        if (placed_[i]) return;
        placed_[i] = true;
        std::set<std::size_t> used;
        for (const std::string& name : uses_[i])
            std::ranges::copy_if(named_[name], std::inserter(used, used.end()),
                                 [&](std::size_t other) { return other < i && kept_[other]; });
        for (const std::size_t other : used) place(other);
        if (const auto comment = comments_.find(i); comment != comments_.end()) place(comment->second);
        order_.push_back(&all_[i]);
    }

    const std::vector<Declaration>& all_;
    std::map<std::string, std::vector<std::size_t>> named_;  // declarations by their names
    std::vector<std::set<std::string>> uses_;                // names, of each declaration
    std::set<std::string> wanted_types_;
    std::vector<bool> kept_;
    std::vector<bool> placed_;
    std::map<std::size_t, std::size_t> comments_;  // that stand before a declaration
    std::vector<const Declaration*> order_;
};

}  // namespace

std::vector<const Declaration*> kept_for(const Outline& outline, const std::string& function) {
    Selection selection(outline);
    selection.want({function}, {});
    std::vector<const Declaration*> kept;
    for (std::size_t i = 0; i < outline.declarations.size(); ++i)
        if (selection.keeps(i) && outline.declarations[i].kind != Kind::comment)
            kept.push_back(&outline.declarations[i]);
    return kept;
}

Kept kept_in_order(const Outline& outline, std::size_t given, const std::vector<std::string>& functions) {
    const std::vector<Declaration>& all = outline.declarations;
    std::vector<std::string> own;
    for (const Declaration& one : all)
        if (one.kind == Kind::function && one.file < given) own.push_back(one.names.front());
    std::vector<std::string> wanted = functions;
    if (wanted.empty())
        wanted = std::ranges::any_of(all, [](const Declaration& one) { return one.defines("main"); })
                     ? std::vector<std::string>{"main"}
                     : own;
    Selection selection(outline);
    selection.want(wanted, own);
    for (std::size_t i = 0; wanted.empty() && i < all.size(); ++i)
        if (all[i].file < given) selection.keep(i);
    return {selection.ordered(), std::move(wanted)};
}

std::string calling_comment(const Kept& kept) {
    const auto any = [&](auto holds) {
        return std::ranges::any_of(kept.declarations, [&](const Declaration* one) { return holds(*one); });
    };
    std::vector<std::string> called;
    std::set<std::string> types;
    for (const std::string& name : kept.wanted) {
        if (any([&](const Declaration& one) { return uses(one, name); })) continue;
        if (std::ranges::count(called, name) == 0) called.push_back(name);
        for (const Declaration* one : kept.declarations)
            if (one->defines(name)) add_parameter_types(*one, types);
    }
    std::vector<std::string> structures;
    std::string to_define;
    for (const Declaration* one : kept.declarations) {
        if (one->names.empty()) continue;
        const std::string& name = one->names.front();
        if (one->kind == Kind::structure && types.contains(name)) structures.push_back(name);
        if (one->kind != Kind::prototype ||
            any([&](const Declaration& other) { return other.defines(name); }))
            continue;
        const std::string meaning = meaning_of(*one);
        to_define += "\n" + paragraph("Define: " + name + (meaning.empty() ? "" : ": " + meaning));
    }
    if (to_define.empty()) return "";
    std::string text = paragraph(fmt::format("Call: {}", fmt::join(called, ", "))) + to_define;
    if (!structures.empty())
        text += "\n" + paragraph(fmt::format("Structures to fill in: {}", fmt::join(structures, ", ")));
    return text;
}

}  // namespace gloam::source
