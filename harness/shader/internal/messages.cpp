// SPDX-License-Identifier: MIT
#include "shader/internal/messages.hpp"

#include <algorithm>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "base/text.hpp"

namespace gloam::shader::internal {
namespace {

// The text behind the mark of an error; nullopt for another line.
std::optional<std::string> error_of(const std::string& line) {
    for (const std::string_view mark : {"ERROR: ", "INTERNAL ERROR: ", "UNIMPLEMENTED: "})
        if (line.starts_with(mark)) return line.substr(mark.size());
    return std::nullopt;
}

// Whether the message only counts the errors.
bool is_summary(const std::string& message) {
    return message.find("No code generated.") != std::string::npos ||
           message.find("compilation terminated") != std::string::npos;
}

// Replaces "'#include' : reason for header name: x" by its reason.
std::string without_include_token(std::string message) {
    constexpr std::string_view token = "'#include' : ";
    const auto begin = message.find(token);
    const auto end = message.rfind(" for header name: ");
    if (begin == std::string::npos || end == std::string::npos || end < begin) return message;
    return message.erase(end).erase(begin, token.size());
}

// Replaces the compiler's key of an overload, "f(vi2;f1;" or "g(", by "f()".
std::string without_keys(std::string message) {
    constexpr std::string_view key_letters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-[];";
    for (auto at = message.find('('); at != std::string::npos; at = message.find('(', at + 1)) {
        const auto end = std::min(message.find_first_not_of(key_letters, at + 1), message.size());
        const bool closes = end < message.size() && message[end] == ')';
        if (!closes && (end == at + 1 || message[end - 1] == ';'))
            message.erase(at + 1, end - at - 1).insert(at + 1, 1, ')');
    }
    return message;
}

std::string tidied(const std::string& message) {
    std::string text = without_include_token(message);
    if (text.find("Linking ") != std::string::npos) text = without_keys(text);
    const auto two_blanks = [](char a, char b) { return a == ' ' && b == ' '; };
    text.erase(std::unique(text.begin(), text.end(), two_blanks), text.end());
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

// Has the ":line: " that follows a file.
bool has_place(std::string_view message) {
    for (auto at = message.find(':'); at != std::string_view::npos; at = message.find(':', at + 1)) {
        const auto end = message.find_first_not_of("0123456789", at + 1);
        if (end != std::string_view::npos && end > at + 1 && message.substr(end, 2) == ": ") return true;
    }
    return false;
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
    return base::for_terminal(text);  // it quotes the shader
}

}  // namespace gloam::shader::internal
