// SPDX-License-Identifier: MIT
#include "base/pattern.hpp"

#include <regex>

namespace gloam::base {

struct Pattern::Compiled {
    std::regex expression;
};

Pattern::Pattern(const std::string& expression, bool ignores_case) {
    std::regex::flag_type flags = std::regex::ECMAScript;
    if (ignores_case) flags |= std::regex::icase;
#if defined(__GLIBCXX__)
    flags |= std::regex_constants::__polynomial;  // otherwise libstdc++ calls itself for each character that
                                                  // it matches
#endif
    compiled_ = std::make_shared<const Compiled>(Compiled{std::regex(expression, flags)});
}

std::vector<std::string> Pattern::first(const std::string& text) const {
    std::smatch found;
    if (!std::regex_search(text, found, compiled_->expression)) return {};
    return {found.begin(), found.end()};
}

std::vector<std::string> Pattern::all(const std::string& text) const {
    return {std::sregex_token_iterator(text.begin(), text.end(), compiled_->expression),
            std::sregex_token_iterator()};
}

std::string Pattern::replaced(const std::string& text, const std::string& with) const {
    return std::regex_replace(text, compiled_->expression, with);
}

}  // namespace gloam::base
