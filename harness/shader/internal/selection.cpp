// SPDX-License-Identifier: MIT
#include "shader/internal/selection.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "shader/internal/calling.hpp"

namespace gloam::shader::internal {

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
        if (!there) throw std::invalid_argument("there is no function \"" + name + "\"");
        want_name(name);
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i)
        if (pieces_[i].names.empty() && pieces_[i].kind != Kind::comment) keep(i);
}

std::vector<std::string> Selection::usual() const {
    std::vector<std::string> own;
    for (const Piece& piece : pieces_) {
        if (piece.kind != Kind::function) continue;
        if (piece.names.front() == "main") return {"main"};
        if (piece.file < given_) own.push_back(piece.names.front());
    }
    return own;
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
            if (found != named_.end()) open.insert(open.end(), found->second.begin(), found->second.end());
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
