// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "catalogue/entry.hpp"
#include "catalogue/printed.hpp"

namespace gloam::catalogue {

// Every equation, room by room in the order of glsl/gloam, as the comments of the shader library in the
// folder `glsl` describe it. Throws std::runtime_error that names the first equation that they do not
// describe.
[[nodiscard]] Entries all_entries(const std::filesystem::path& glsl);

// What names stand for.
struct Found {
    Entries entries;               // each once, in the order of the names
    std::vector<PrintedRow> rows;  // of the names that are no entry's own
    std::string several;           // a name that fits several rows; none of these has its entries here
    std::string lacking;           // a name whose rows have no function with an entry
};

// Every command of the command line finds equations by this. A name is an ID, a function ("gloam_blend",
// "blend"), a file of the library ("gloam/filter/weights.glsl"), or what people call them in the papers
// (rows_named()); or a shell glob (* and ?) of these or of sources. Case does not matter. No name is all.
// Throws std::invalid_argument with a name that is none of them.
[[nodiscard]] Found find(const Entries& entries, const std::vector<std::string>& names);

// The entries of find().
[[nodiscard]] Entries select(const Entries& entries, const std::vector<std::string>& names);

// Whether the text matches the glob, in any case.
[[nodiscard]] bool matches_glob(std::string_view text, std::string_view glob);

}  // namespace gloam::catalogue
