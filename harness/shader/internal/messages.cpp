// SPDX-License-Identifier: MIT
#include "shader/internal/messages.hpp"

#include <algorithm>
#include <optional>
#include <regex>
#include <sstream>
#include <string_view>
#include <vector>

namespace gloam::shader::internal {
namespace {

// What follows the mark of an error; nothing for another line.
std::optional<std::string> error_of(const std::string& line) {
    for (const std::string_view mark : {"ERROR: ", "INTERNAL ERROR: ", "UNIMPLEMENTED: "})
        if (line.starts_with(mark)) return line.substr(mark.size());
    return std::nullopt;
}

// Says only that there were others.
bool is_summary(const std::string& message) {
    return message.find("No code generated.") != std::string::npos ||
           message.find("compilation terminated") != std::string::npos;
}

// "'#include' : reason for header name: x" as its reason.
std::string without_include_token(std::string message) {
    constexpr std::string_view token = "'#include' : ";
    const auto begin = message.find(token);
    const auto end = message.rfind(" for header name: ");
    if (begin == std::string::npos || end == std::string::npos || end < begin) return message;
    return message.erase(end).erase(begin, token.size());
}

// "f(vi2;f1;" as "f()", single blanks.
std::string tidied(const std::string& message) {
    static const std::regex mangled("([A-Za-z_][A-Za-z_0-9]*)\\(([A-Za-z_0-9\\[\\]-]+;)+");
    static const std::regex blanks(" +");
    std::string text = without_include_token(message);
    if (text.find("Linking ") != std::string::npos) text = std::regex_replace(text, mangled, "$1()");
    text = std::regex_replace(text, blanks, " ");
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

bool has_place(const std::string& message) {
    static const std::regex place(".:[0-9]+: ");
    return std::regex_search(message, place);
}

}  // namespace

std::string error_lines(const std::string& log, const std::string& file) {
    std::vector<std::string> errors;
    bool in_error = false;
    std::istringstream stream(log);
    for (std::string line; std::getline(stream, line);) {
        if (const auto error = error_of(line)) {
            in_error = !is_summary(*error);
            if (in_error) errors.push_back(*error);
        } else if (in_error && line.starts_with(' ')) {
            errors.back() += line;  // the rest of a message of several lines
        } else {
            in_error = false;
        }
    }
    if (errors.empty()) return file + ": the compiler gave no reason";
    std::string text;
    for (const std::string& error : errors) {
        if (!text.empty()) text += "\n";
        if (!has_place(error)) text.append(file).append(": ");
        text += tidied(error);
    }
    return text;
}

}  // namespace gloam::shader::internal
