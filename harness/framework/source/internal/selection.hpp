// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "source/declarations.hpp"

namespace gloam::shader::internal {

// What is kept of an outline, and in which order: what is wanted, and all that it mentions.
class Selection {
  public:
    // The outline must outlive this object. The first `given` of its files were given, the others included.
    Selection(const Outline& outline, std::size_t given);

    // Keeps these functions, and every declaration without a name. Throws std::invalid_argument for a
    // function that the outline lacks.
    void want(const std::vector<std::string>& functions);

    // The names of what is wanted where nobody says so: main, otherwise all functions of the given files.
    [[nodiscard]] std::vector<std::string> usual() const;

    // Keeps all that the given files declare, of texts without a function.
    void want_all_given();

    [[nodiscard]] bool keeps(std::size_t declaration) const { return kept_[declaration]; }

    // What is kept, with its comments. What the user supplies stands first.
    [[nodiscard]] std::vector<const Declaration*> ordered();

  private:
    [[nodiscard]] std::vector<std::string> given_functions() const;
    // The declarations with this name.
    [[nodiscard]] const std::vector<std::size_t>& named(const std::string& name) const;
    // A macro that gives a declaration another name belongs to it.
    [[nodiscard]] std::set<std::string> uses_of(std::size_t i) const;
    // And all that it mentions, and so on.
    void keep(std::size_t first);
    // A comment may name values that no function reads: "GLOAM_FALLOFF_*" says what a member may hold.
    void add_constants_in_comments(const Declaration& one, std::vector<std::size_t>& open) const;
    // A comment that stands by itself belongs to what follows in its file, up to the next one.
    void keep_comments();
    // Then the order in which they stand means something.
    [[nodiscard]] bool redefines_macros() const;
    [[nodiscard]] bool is_given_by_user(std::size_t i) const;
    // Behind what it uses of what stands before it: a text declares before it uses.
    void place(std::size_t i);

    const std::vector<Declaration>& all_;
    std::size_t given_;
    std::map<std::string, std::vector<std::size_t>> named_;
    std::map<std::size_t, std::set<std::string>> renamed_;  // declarations, and the macros that rename them
    std::set<std::string> wanted_types_;
    std::vector<bool> kept_;
    std::vector<bool> placed_;
    std::map<std::size_t, std::size_t> comments_;  // that stand before a declaration
    std::vector<const Declaration*> order_;
};

// A comment that says how to call a text without a main: the functions to call (those of `wanted` that
// nothing else uses), the prototypes without a body that the caller has to define, with their meaning, and
// the structures of the parameters. Lines have at most 120 columns. Empty if there is nothing to define.
[[nodiscard]] std::string calling_comment(const std::vector<const Declaration*>& kept,
                                          const std::vector<std::string>& wanted);

}  // namespace gloam::shader::internal
