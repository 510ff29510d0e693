// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "source/outline.hpp"

namespace gloam::shader::internal {

// What is kept of an outline, and in which order: what is wanted, and all that it mentions.
class Selection {
  public:
    // The outline must outlive this object. The first `given` of its files were given, the others included.
    Selection(const Outline& outline, std::size_t given);

    // Keeps these functions, and every piece without a name. Throws std::invalid_argument for a function that
    // the outline lacks.
    void want(const std::vector<std::string>& functions);

    // The names of what is wanted where nobody says so: main, otherwise all functions of the given files.
    [[nodiscard]] std::vector<std::string> usual() const;

    // Keeps all that the given files declare, of texts without a function.
    void want_all_given();

    [[nodiscard]] bool keeps(std::size_t piece) const { return kept_[piece]; }

    // The kept pieces with their comments. What the user supplies stands first.
    [[nodiscard]] std::vector<const Piece*> ordered();

  private:
    [[nodiscard]] std::vector<std::string> given_functions() const;
    void want_name(const std::string& name);
    // A macro that gives a declaration another name belongs to it.
    [[nodiscard]] std::set<std::string> uses_of(std::size_t i) const;
    // And all that it mentions, and so on.
    void keep(std::size_t first);
    // A comment may name values that no function reads: "GLOAM_FALLOFF_*" says what a member may hold.
    void add_constants_in_comments(const Piece& piece, std::vector<std::size_t>& open) const;
    // A comment that stands by itself belongs to what follows in its file, up to the next one.
    void keep_comments();
    // Then the order in which they stand means something.
    [[nodiscard]] bool redefines_macros() const;
    [[nodiscard]] bool has_body(const std::string& function) const;
    [[nodiscard]] bool is_given_by_user(std::size_t i) const;
    // Behind what it uses of what stands before it: a text declares before it uses.
    void place(std::size_t i);

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

// The constants that the comments of a piece name: "FX_STEP" as it is, "FX_FALLOFF_*" for every name that
// begins so. Names have no lower-case letters.
[[nodiscard]] std::vector<std::string> constants_in_comments(const Piece& piece);

// A comment that says how to call a text without a main: the functions to call (those of `wanted` that no
// other piece uses), the prototypes without a body that the caller has to define, with their meaning, and the
// structures of the parameters. Lines have at most 120 columns. Empty if there is nothing to define.
[[nodiscard]] std::string calling_comment(const std::vector<const Piece*>& pieces,
                                          const std::vector<std::string>& wanted);

}  // namespace gloam::shader::internal
