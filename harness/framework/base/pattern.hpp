// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace gloam::base {

// A regular expression in ECMAScript's grammar, to be matched with texts from elsewhere: the stack that it
// needs does not grow with them. A source that includes <regex> takes 1.6 s longer to compile, so only this
// room does.
class Pattern {
  public:
    // ignores_case: of ASCII letters. Throws std::regex_error for a text that is no expression.
    explicit Pattern(const std::string& expression, bool ignores_case = false);

    // The first match, then its groups, of which those that have no part in it are empty. No elements where
    // nothing matches.
    [[nodiscard]] std::vector<std::string> first(const std::string& text) const;
    // All matches, none of which overlap.
    [[nodiscard]] std::vector<std::string> all(const std::string& text) const;
    // The text with other words in the place of each match.
    [[nodiscard]] std::string replaced(const std::string& text, const std::string& with) const;

  private:
    struct Compiled;
    std::shared_ptr<const Compiled> compiled_;
};

}  // namespace gloam::base
