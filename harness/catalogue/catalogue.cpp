// SPDX-License-Identifier: MIT
#include "catalogue/catalogue.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <stdexcept>

#include "catalogue/rooms.hpp"
#include "catalogue/worst_inputs.hpp"

namespace gloam::catalogue {
namespace {

bool same_letter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

bool matches_entry(const Entry& entry, std::string_view glob) {
    return matches_glob(entry.description.id, glob) || matches_glob(entry.description.function, glob);
}

void require_unique(const Entries& entries) {
    std::set<std::string> ids;
    for (const Entry& entry : entries) {
        if (!ids.insert(entry.description.id).second) {
            throw std::logic_error("two catalogue entries are called " + entry.description.id);
        }
    }
}

}  // namespace

Entries all_entries() {
    Entries entries;
    append_numeric(entries);
    append_sampling(entries);
    append_geometry(entries);
    append_occlusion(entries);
    append_temporal(entries);
    append_filter(entries);
    append_shading(entries);
    append_builtins(entries);
    require_unique(entries);
    add_worst_inputs(entries);
    return entries;
}

bool matches_glob(std::string_view text, std::string_view glob) {
    if (glob.empty()) return text.empty();
    if (glob.front() == '*') {
        return matches_glob(text, glob.substr(1)) || (!text.empty() && matches_glob(text.substr(1), glob));
    }
    if (text.empty()) return false;
    return (glob.front() == '?' || same_letter(glob.front(), text.front())) &&
           matches_glob(text.substr(1), glob.substr(1));
}

Entries select(const Entries& entries, const std::vector<std::string>& patterns) {
    if (patterns.empty()) return entries;
    for (const std::string& pattern : patterns) {
        const auto known = [&pattern](const Entry& entry) { return matches_entry(entry, pattern); };
        if (std::ranges::none_of(entries, known)) {
            throw std::invalid_argument("no equation matches \"" + pattern +
                                        "\"; `gloam list equations` names them all");
        }
    }
    Entries selected;
    for (const Entry& entry : entries) {
        const auto wanted = [&entry](const std::string& pattern) { return matches_entry(entry, pattern); };
        if (std::ranges::any_of(patterns, wanted)) selected.push_back(entry);
    }
    return selected;
}

}  // namespace gloam::catalogue
