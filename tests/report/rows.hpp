// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string>

#include "report/check_report.hpp"

namespace gloam::report {

// A row with something in every field; it failed.
inline CheckRow failing_row() {
    return {.equation = "EQ-1",
            .function = "f",
            .file = "gloam/f.glsl",
            .variant = "strict",
            .verdict = "rules",
            .inputs = 100,
            .outside = 3,
            .recorded = 7,
            .unbounded = 5,
            .differs = 2,
            .max_ulp = std::numeric_limits<double>::infinity(),
            .max_abs = 0.1,
            .width_fraction = 1.25,
            .budget_fraction = 0.5,
            .budget = {.ulp = 4.0, .absolute = 1e-7, .backward_ulp = 1, .text = "4 ulp or 1e-07 absolute"},
            .classes = {{.name = "ordinary", .inputs = 90, .outside = 3, .recorded = 0},
                        {.name = "nan", .inputs = 10, .outside = 0, .recorded = 7}},
            .worst = WorstInput{.input = 17,
                                .input_class = "ordinary",
                                .images = "3 x 3",
                                .values = "float 0.5 (0x3f000000)",
                                .input_words = {0x3f000000U, 0xffffffffU},
                                .got_words = {0x7fc00000U},
                                .want = {0.1, std::numeric_limits<double>::infinity()},
                                .allowed = {{.low = 0.0, .high = 0.25, .nan = true}},
                                .ulp = 1e9,
                                .absolute = 0.1},
            .fault = "gloam_fetch_depth: pixel (-1, 0)",
            .error = {},
            .reason = Reason::fault,
            .seconds = 0.125,
            .story = "line one\nline <two> & \"three\"\n"};
}

inline CheckRow passing_row(const std::string& equation, const std::string& variant = "shipped") {
    return {.equation = equation,
            .function = "g",
            .file = "gloam/g.glsl",
            .variant = variant,
            .inputs = 50,
            .budget_fraction = 0.25};
}

inline CheckReport report_of(const std::string& device, std::vector<CheckRow> rows) {
    return {.device = {.name = device,
                       .driver = "driver 1.2",
                       .type = "cpu",
                       .api_version = "1.3.0",
                       .preserves_signed_zero_inf_nan = true},
            .rows = std::move(rows)};
}

}  // namespace gloam::report
