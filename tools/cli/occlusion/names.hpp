// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "catalogue/catalogue.hpp"
#include "cli/framework/cost.hpp"
#include "effect/plan.hpp"
#include "scene/pass_library.hpp"

namespace gloam::cli {

// A name that the command line accepts, and its meaning.
struct Named {
    std::string name;
    std::string description;
};

// What names stand for. Throws std::invalid_argument, for a name that fits several rows of the papers when it
// has printed these on standard error.
[[nodiscard]] catalogue::Found found_named(const std::vector<std::string>& names);

// The equations among these, for all commands. Throws like found_named(), and for a row without a function.
[[nodiscard]] std::vector<judge::Question> equations_named(const std::vector<std::string>& names);

// The same, and passes ("PASS-remap", "PASS-frame-fast") by their names or globs of these.
[[nodiscard]] std::vector<judge::Question> subjects_named(const std::vector<std::string>& names);

// What the papers print, and what has it; and as a page.
[[nodiscard]] std::vector<Named> names_of(const std::vector<catalogue::PrintedRow>& rows);
[[nodiscard]] std::string numbers_page();

// The passes of a preset's frame with NAME=VALUE set. It takes depth and normals as most engines store them.
[[nodiscard]] PresetFrame frame_of(const std::string& preset, const std::vector<std::string>& set,
                                   std::optional<double> tiles);

// A pass of a plan as one text, with its constants set.
[[nodiscard]] std::string text_of(const effect::PlannedPass& pass, const scene::PassLibrary& library,
                                  source::Language language = source::Language::vulkan450);

}  // namespace gloam::cli
