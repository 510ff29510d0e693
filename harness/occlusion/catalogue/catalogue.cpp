// SPDX-License-Identifier: MIT
#include "catalogue/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <stdexcept>

namespace gloam::catalogue {
namespace {

bool same_letter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

bool matches_entry(const Entry& entry, std::string_view glob) {
    return matches_glob(entry.description.id, glob) || matches_glob(entry.description.function, glob);
}

// Gives each entry what the comments of the shader library say of its equation.
void describe(Entries& entries, const std::filesystem::path& glsl) {
    const std::map<std::string, Description> described = descriptions(glsl);
    std::set<std::string> ids;
    for (auto& [description, question] : entries) {
        const std::string id = description.id;
        if (!ids.insert(id).second) throw std::logic_error("two catalogue entries are called " + id);
        const auto found = described.find(id);
        if (found == described.end())
            throw std::runtime_error(
                fmt::format("nothing below {} describes {}: expected a function whose comment begins with "
                            "\"TITLE ({}): `FORMULA` [SOURCE].\"",
                            glsl.string(), id, id));
        description = found->second;
        question.name = id;
        question.file = description.file;
        question.function = description.function;
    }
}

}  // namespace

Entries all_entries(const std::filesystem::path& glsl) {
    Entries entries;
    append_numeric(entries);
    append_sampling(entries);
    append_geometry(entries);
    append_geometry_camera(entries);
    append_occlusion(entries);
    append_occlusion_slices(entries);
    append_occlusion_volumes(entries);
    append_occlusion_gathers(entries);
    append_occlusion_scalable(entries);
    append_temporal(entries);
    append_filter(entries);
    append_filter_edges(entries);
    append_shading(entries);
    append_builtins(entries);
    describe(entries, glsl);
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
