// SPDX-License-Identifier: MIT
#pragma once

#include "record/check_report.hpp"
#include "support/test.hpp"

namespace gloam::record {

inline auto says(const std::string& text) {
    return ThrowsMessage<std::runtime_error>(HasSubstr(text));
}

// The first class of an answer's inputs.
inline judge::ClassCount& ordinary(judge::Answer& row) {
    return row.classes.front();
}

// A row with something in every field; it failed.
inline judge::Answer failing_row() {
    judge::Answer row{{.equation = "EQ-1",
                       .function = "f",
                       .file = "gloam/f.glsl",
                       .variant = "strict",
                       .criterion = judge::Criterion::rules,
                       .budget = {.ulp = 4.0, .absolute = 1e-7, .backward_ulp = 1}},
                      {.by_rules = 93, .forbidden = 3, .bounded = 90, .unbounded = 5, .differs = 2},
                      {.largest = {std::numeric_limits<double>::infinity(), 0.1, 0.5},
                       .fraction = 1.25,
                       .worst = judge::Sample{.index = 17,
                                              .scenario = "3 x 3",
                                              .values = "float 0.5 (0x3f000000)",
                                              .inputs = {0x3f000000U, 0xffffffffU},
                                              .got = {0x7fc00000U},
                                              .want = {0.1, std::numeric_limits<double>::infinity()},
                                              .error = {.ulp = 1e9, .absolute = 0.1},
                                              .permitted = {{.low = 0.0, .high = 0.25, .nan = true}}},
                       .first_unbounded = judge::Sample{.values = "float 4 (0x40800000)"}},
                      {.ulp = 2.5, .absolute = 1e-6, .fraction = 0.75}};
    row.coverage = judge::Coverage{.inputs = 100, .points = {{"f.glsl", 7, "return 0.0;", "", true}}};
    row.fault = "gloam_fetch_depth: pixel (-1, 0)";
    row.reason = judge::Reason::fault;
    row.seconds = 0.125;
    row.story = "line one\nline <two> & \"three\"\n";
    ordinary(row) = {.inputs = 90, .outside = 3, .recorded = 0};
    row.classes.back() = {.inputs = 10, .outside = 0, .recorded = 7};
    return row;
}

inline judge::Answer passing_row(const std::string& equation, const std::string& variant = "shipped") {
    judge::Answer row{{.equation = equation, .function = "g", .file = "gloam/g.glsl", .variant = variant}};
    row.largest.fraction = 0.25;
    ordinary(row).inputs = 50;
    return row;
}

// A row whose inputs were only recorded.
inline judge::Answer unjudged_row(const std::string& equation) {
    judge::Answer row = passing_row(equation);
    ordinary(row).recorded = ordinary(row).inputs;
    row.largest.fraction = 0.0;
    return row;
}

// A row of a function that the device's language lacks.
inline judge::Answer unsupported_row(const std::string& equation) {
    judge::Answer row{{.equation = equation, .function = "h", .file = "gloam/h.glsl", .variant = "shipped"}};
    row.error = "h is no GLSL 3.30";
    row.reason = judge::Reason::unsupported;
    return row;
}

inline CheckReport report_of(const std::string& device, std::vector<judge::Answer> rows) {
    return {.device = {.name = device,
                       .driver = "driver 1.2",
                       .type = "cpu",
                       .api_version = "1.3.0",
                       .float32 = {.preserves_signed_zero_inf_nan = true}},
            .rows = std::move(rows)};
}

}  // namespace gloam::record
