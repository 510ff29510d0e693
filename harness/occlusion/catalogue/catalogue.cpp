// SPDX-License-Identifier: MIT
#include "catalogue/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <stdexcept>

#include "catalogue/printed.hpp"

namespace gloam::catalogue {
namespace {

bool same_letter(char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

bool is_glob(std::string_view name) {
    return name.find_first_of("*?") != std::string_view::npos;
}

// Whether the name is the entry's ID or function, also without "gloam_", or the file that has it, also by a
// longer or shorter path.
bool names_entry(const Entry& entry, std::string_view name) {
    const Description& d = entry.description;
    if (matches_glob(d.id, name) || matches_glob(d.function, name) || matches_glob(d.file, name)) return true;
    if (!is_glob(name) && matches_glob(d.function, "gloam_" + std::string(name))) return true;
    return name.ends_with(".glsl") &&
           (name.ends_with("/" + d.file) || d.file.ends_with("/" + std::string(name)));
}

// Adds an entry that is not there yet.
void add_once(Entries& entries, const Entry& entry) {
    const auto same = [&entry](const Entry& other) { return other.description.id == entry.description.id; };
    if (std::ranges::none_of(entries, same)) entries.push_back(entry);
}

// Rows of the papers. A row leads to the entries of its functions and methods.
void find_row(const Entries& all, const std::string& name, Found& found) {
    const std::vector<PrintedRow> rows = rows_named(name);
    found.rows.insert(found.rows.end(), rows.begin(), rows.end());
    if (rows.size() > 1 && !is_glob(name)) return found.several = name, void();
    bool any = false;
    for (const PrintedRow& row : rows)
        for (const std::string& thing : row.has)
            for (const Entry& entry : all) {
                if (entry.description.function != function_of(thing)) continue;
                any = true;
                add_once(found.entries, entry);
            }
    if (!any && !rows.empty()) found.lacking = name;
}

void find_one(const Entries& all, const std::string& name, Found& found) {
    const std::size_t before = found.entries.size() + found.rows.size();
    bool any = false;
    for (const Entry& entry : all) {
        if (!names_entry(entry, name)) continue;
        any = true;
        add_once(found.entries, entry);
    }
    if (any) return;
    if (is_glob(name))
        for (const Entry& entry : all)
            if (matches_glob(entry.description.source, name)) add_once(found.entries, entry);
    find_row(all, name, found);
    if (found.entries.size() + found.rows.size() == before)
        throw std::invalid_argument("no equation matches \"" + name +
                                    "\"; `gloam list equations` and `gloam list numbers` name them all");
}

// Gives each entry what the comments of the shader library say of its equation.
void describe(Entries& entries, const std::filesystem::path& glsl) {
    const std::map<std::string, Description> described = descriptions(glsl);
    std::set<std::string> ids;
    for (auto& [description, question, known] : entries) {
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

judge::Question& add_question(Entries& entries, std::string id, judge::Question question,
                              const subject::Domain& domain) {
    question.scenarios = with_exact_ends(std::move(question.scenarios));
    question.domain = domain.and_degenerate(question.signature);
    return entries.emplace_back(Entry{.description = {.id = std::move(id)}, .question = std::move(question)})
        .question;
}

Entries all_entries(const std::filesystem::path& glsl) {
    Entries entries;
    for (const auto append :
         {append_numeric, append_sampling, append_geometry, append_geometry_camera, append_occlusion,
          append_occlusion_slices, append_occlusion_volumes, append_occlusion_gathers, append_methods,
          append_occlusion_scalable, append_temporal, append_filter, append_filter_edges, append_shading,
          append_frame, append_builtins})
        append(entries);
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

Found find(const Entries& entries, const std::vector<std::string>& names) {
    if (names.empty()) return {.entries = entries};
    Found found;
    for (const std::string& name : names) find_one(entries, name, found);
    return found;
}

Entries select(const Entries& entries, const std::vector<std::string>& names) {
    return find(entries, names).entries;
}

}  // namespace gloam::catalogue
