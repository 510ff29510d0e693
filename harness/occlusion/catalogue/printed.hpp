// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

// What the papers print, by number and by name. The IDs of the catalogue follow the numbers only in part.
namespace gloam::catalogue {

// An equation, table, figure, section or constant of a paper, and what has it here.
struct PrintedRow {
    std::string paper;                 // the heading that it stands below
    std::vector<std::string> places;   // "TSSAO-5", "CS 3.2.4", "ISSAO figure 3", "TSSAO table 1: 32"
    std::vector<std::string> phrases;  // that people ask it by
    std::string says;                  // in a few words
    // "gloam_blend", "method hsao", "preset sao-code", "scene far", "view bunny", "steps=6" (a setting),
    // "guard" (any value), "gloam stress", a file in docs or glsl; a remark in brackets; "none: why".
    std::vector<std::string> has;
};

struct Erratum {
    std::string place, printed, here;
};

// Paper by paper, as printed_rows.inc has them.
[[nodiscard]] const std::vector<PrintedRow>& printed_rows();
[[nodiscard]] const std::vector<Erratum>& errata();

// The rows that people mean: "TSSAO eq. 5", "Mattausch 6", "eq 3.4", "figure 3 of ISSAO", "section 3.2.4",
// "guard band", or a glob. Numbers of equations come before other places and phrases, and these before a part
// of a phrase.
[[nodiscard]] std::vector<PrintedRow> rows_named(std::string_view name);

// The function of a thing that a row has: "gloam_hsao" of "method hsao"; empty: it is none.
[[nodiscard]] std::string function_of(const std::string& thing);

}  // namespace gloam::catalogue
