// SPDX-License-Identifier: MIT
#pragma once

#include <regex>

#include "support/library_files.hpp"

// Which functions of the library call which, by their text: tests choose their methods by it before they run,
// in a few milliseconds.
namespace gloam::test {

// The text of each function of glsl/gloam that has a body, by its name.
inline const std::map<std::string, std::string>& library_functions() {
    static const std::map<std::string, std::string> all = [] {
        const std::regex head(R"((?:\w+ )+(\w+)\(.*)");
        std::map<std::string, std::string> found;
        for (const std::string& name : library_files()) {
            std::ifstream file(std::filesystem::path(GLOAM_GLSL_DIR) / name);
            std::string text;  // of the function so far
            std::smatch match;
            std::string function;
            for (std::string line; std::getline(file, line);) {
                if (text.empty() && !std::regex_match(line, match, head)) continue;
                if (text.empty()) function = match[1];
                text += line + "\n";
                const bool has_body = text.find('{') != std::string::npos;
                if (line == "}") found[function] += text;
                if (line == "}" || (!has_body && line.ends_with(';'))) text.clear();
            }
        }
        return found;
    }();
    return all;
}

// Whether a method calls a function, itself or through others.
inline bool calls(const std::string& method, const std::string& wanted) {
    static const std::regex call(R"((\w+)\()");
    std::set<std::string> reached{"gloam_" + method};
    std::vector<std::string> rest{"gloam_" + method};
    while (!rest.empty()) {
        const auto function = library_functions().find(rest.back());
        rest.pop_back();
        if (function == library_functions().end()) continue;
        const std::string& text = function->second;
        for (std::sregex_iterator one(text.begin(), text.end(), call), end; one != end; ++one)
            if (reached.insert((*one)[1]).second) rest.push_back((*one)[1]);
    }
    return reached.contains(wanted);
}

}  // namespace gloam::test
