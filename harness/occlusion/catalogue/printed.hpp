// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "catalogue/entry.hpp"

// The numbers that equations have in the papers, which the IDs of the catalogue follow only in part.
namespace gloam::catalogue {

// An equation as its paper numbers it, and what stands for it here.
struct PrintedEquation {
    std::string number;            // "TSSAO-4", "CGF-6", "ISSAO-7", "CS-3.10"
    std::string title;             // in a few words
    std::vector<std::string> ids;  // of entries, the one nearest to the equation first
    std::string note;  // where no entry is the equation itself: why, and which function stands for it
};

// Every numbered equation of the papers, paper by paper.
[[nodiscard]] const std::vector<PrintedEquation>& printed_equations();

// The number in the form above of how people write it: "TSSAO eq. 5", "Mattausch 6", "cs 3.10". Other text is
// only put in lower case.
[[nodiscard]] std::string number_from(std::string_view text);

// A page of Markdown: a table for each paper of its numbers and our functions.
[[nodiscard]] std::string printed_page(const Entries& entries);

}  // namespace gloam::catalogue
