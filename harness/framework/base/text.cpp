// SPDX-License-Identifier: MIT
#include "base/text.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <vector>

#include "base/cached_file.hpp"

namespace gloam::base {
namespace {

bool is_control(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20U || byte == 0x7fU;
}

// The bytes of the UTF-8 character at the front; 0 for a byte that begins none, and for U+0080 to U+009F,
// which are control characters.
std::size_t character_size(std::string_view text) {
    const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    const std::size_t size = first < 0x80U   ? 1
                             : first < 0xc2U ? 0
                             : first < 0xe0U ? 2
                             : first < 0xf0U ? 3
                                             : 4;
    if (first > 0xf4U || size > text.size()) return 0;
    for (std::size_t i = 1; i < size; ++i)
        if ((byte(i) & 0xc0U) != 0x80U) return 0;
    return first == 0xc2U && byte(1) < 0xa0U ? 0 : size;
}

[[noreturn]] void exceed(std::string_view text, std::size_t at, const std::string& what) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    throw std::runtime_error(fmt::format("line {}: {}", line, what));
}

}  // namespace

std::string shortened(std::string_view text, std::size_t most) {
    if (text.size() <= most) return std::string(text);
    constexpr std::string_view dots = "...";
    std::size_t size = most - std::min(most, dots.size());
    while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xc0U) == 0x80U) --size;
    return std::string(text.substr(0, size)) + std::string(dots);
}

std::string for_terminal(std::string_view text) {
    std::string safe;
    while (!text.empty()) {
        const std::size_t size = character_size(text);
        const bool layout = text.front() == '\n' || text.front() == '\t';
        safe += size == 0 || (is_control(text.front()) && !layout) ? " " : text.substr(0, size);
        text.remove_prefix(std::max<std::size_t>(size, 1));
    }
    return safe;
}

std::string one_line(std::string_view text) {
    while (!text.empty() && text.back() == '\n') text.remove_suffix(1);
    std::string line = for_terminal(text);
    std::ranges::replace_if(line, is_control, ' ');
    return line;
}

std::string lower(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

bool is_name(std::string_view text) {
    constexpr std::size_t longest = 1000;
    return !text.empty() && text.size() <= longest && std::ranges::none_of(text, is_control);
}

std::string file_name_of(std::string_view text) {
    constexpr std::size_t longest = 100;
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
    std::string name;
    for (const char c : text) {
        const bool stays = plain.find(c) != std::string_view::npos || (c == '.' && !name.empty());
        name += stays ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    if (name.size() > longest)
        name = fmt::format("{}-{:016x}", name.substr(0, longest), hash_of(text).front());
    return name.empty() ? "unnamed" : name;
}

std::string base64(std::span<const unsigned char> bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    std::uint32_t bits = 0;
    int held = 0;
    for (const unsigned char byte : bytes) {
        bits = bits << 8U | byte;
        for (held += 8; held >= 6; held -= 6) text += digits[bits >> (held - 6) & 63U];
    }
    if (held > 0) text += digits[bits << (6 - held) & 63U];
    while (text.size() % 4 != 0) text += '=';
    return text;
}

void require_bounded_json(std::string_view text) {
    constexpr std::size_t most_bytes = std::size_t{64} << 20;
    constexpr std::size_t deepest = 64;
    constexpr std::size_t most_members = 1000;
    if (text.size() > most_bytes)
        throw std::runtime_error(
            fmt::format("{} bytes of JSON, expected at most {}", text.size(), most_bytes));
    std::vector<std::size_t> names;  // colons seen, in each array or object that is open
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"') {
            for (++at; at < text.size() && text[at] != '"'; ++at)
                if (text[at] == '\\') ++at;
        } else if (c == '[' || c == '{') {
            if (names.size() == deepest) exceed(text, at, fmt::format("nested more than {} deep", deepest));
            names.push_back(0);
        } else if ((c == ']' || c == '}') && !names.empty()) {
            names.pop_back();
        } else if (c == ':' && !names.empty() && ++names.back() > most_members) {
            exceed(text, at, fmt::format("an object of more than {} members", most_members));
        }
    }
}

}  // namespace gloam::base
