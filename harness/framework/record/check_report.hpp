// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <set>
#include <string_view>

#include "judge/answer.hpp"
#include "record/table.hpp"

namespace gloam::record {

// The device of a check, for reports.
struct DeviceSummary {
    std::string name;
    std::string manifest = {};  // backend::DeviceInfo::manifest
    std::string driver;
    std::string type;
    std::string api_version;
    backend::FloatControls float32 = {};
};

// "NAME (DRIVER)", and the manifest where there is one, which identifies a driver in a report.
[[nodiscard]] std::string name_of(const DeviceSummary& device);

// "Vulkan 1.3.230", "OpenGL ES 3.1", "WebGL 2.0 (OpenGL ES 3.0 Chromium)".
[[nodiscard]] std::string api_of(const DeviceSummary& device);

// The results of all checks of one device.
struct CheckReport {
    DeviceSummary device;
    std::vector<judge::Answer> rows;
    std::string versions{};          // of gloam and of the compilers; empty: unknown
    std::size_t inputs = 0;          // that were asked for; 0: unknown
    std::uint64_t seed = 0;          // of these; 0: unknown
    std::set<std::string> shards{};  // that it is made of, "0/3"; empty: it is whole

    [[nodiscard]] std::size_t count(judge::Outcome outcome) const;
};

// Checks by their outcome.
struct OutcomeCounts {
    std::size_t checks = 0;
    std::size_t failed = 0;
    std::size_t not_judged = 0;

    // Of a command: 1 if a check failed; 2 if there were some and none was judged; 0 otherwise.
    [[nodiscard]] int exit_status() const;
};
[[nodiscard]] OutcomeCounts counts_of(const std::vector<CheckReport>& reports);

// "411 checks, 0 failed, 14 not judged"; the last part only if there are any.
[[nodiscard]] std::string to_text(const OutcomeCounts& counts);

// "ok", the number of inputs outside what is allowed ("3 outside"), "not judged", or the reason why the check
// did not run ("hang").
[[nodiscard]] std::string verdict_of(const judge::Answer& row);

// Why a row was not judged, or what the verdict says nothing of: "any result would pass for 3 of 512; not
// promised: nan". Empty if there is nothing to say.
[[nodiscard]] std::string remark_on(const judge::Answer& row);

// Column titles, and one line for each row: ID, function, variant, inputs that were judged, worst ULP, worst
// absolute error, worst error as a part of what is allowed, by what it was judged ("budget" or "rules"),
// verdict_of() and remark_on() at the end. The legend explains the titles in a few lines.
[[nodiscard]] std::string table_header();
// `verdict`: another text in its place, for example in colour.
[[nodiscard]] std::string table_line(const judge::Answer& row, const std::string& verdict = {});
[[nodiscard]] std::string table_legend();

// The columns from "judged" to "of allowed", and a row's cells in them.
[[nodiscard]] const std::vector<Column>& error_columns();
[[nodiscard]] std::vector<Cell> error_cells(const judge::Answer& row);

// An object, or an array of them for several devices: "gloam", "device", "versions", "inputs", "seed" and
// "results", whose members are those of judge::Answer (record/answer_json.hpp). Those that the verdict does
// not need are null, infinite numbers are the strings "inf" and "-inf", NaN is "nan".
[[nodiscard]] std::string to_json(const std::vector<CheckReport>& reports);

// Throws std::runtime_error with the place in the text, what was found and what was expected.
[[nodiscard]] std::vector<CheckReport> reports_from_json(std::string_view text);

// JUnit XML: a test suite for each device, a test case for each row. A row that did not run is an error whose
// type is its reason; one that was not judged is skipped.
[[nodiscard]] std::string to_junit(const std::vector<CheckReport>& reports);

// A row for each equation: documented error, error on any driver, and measured error of each driver.
[[nodiscard]] Table accuracy_table(const std::vector<CheckReport>& reports);

// Every check of every device, failures first: a row each, with its results and its worst input. There is a
// column for the device if there are several.
[[nodiscard]] Table check_table(const std::vector<CheckReport>& reports);

// The results of `gloam check` as one HTML page: the devices with the number of failed checks, the story of
// each failure, accuracy_table() and check_table(). `notes`: paragraphs below the title.
[[nodiscard]] std::string to_check_page(const std::vector<CheckReport>& reports,
                                        const std::vector<std::string>& notes = {});

// A report, and the file that it was read from.
struct ReportFile {
    std::string file;
    CheckReport report;
};

// Reports merged from one or more files: a report for each driver, with each equation in each variant once.
struct MergedReports {
    std::vector<CheckReport> reports;    // drivers in the order of their files; rows sorted by equation
    std::vector<std::string> conflicts;  // a line for each row that differs between two files
    std::vector<std::string> missing;    // a line for each driver of which there are not all shards
};

// Merges files. Two drivers are the same if all their reported properties are; their rows for the same inputs
// and seed are united, so that shards become the whole. Of two rows that differ (except in time) the worse is
// kept: one that did not run, then one with a fault, then the larger share outside, then the larger error.
[[nodiscard]] MergedReports merge(const std::vector<ReportFile>& files);

// A line for each check that newly failed or was mended since an earlier run, and whose error grew or shrank
// by more than a tenth and by more than a hundredth of what is allowed. A run is compared with one of the
// same device, inputs and seed: of the same driver if there is one, otherwise of another build. Where each
// side has one device, that may have another name.
[[nodiscard]] std::vector<std::string> changes_since(const std::vector<CheckReport>& before,
                                                     const std::vector<CheckReport>& now);

// A table of equation by driver and variant. A cell is "ok 0.85" with the worst error as a fraction of what
// is allowed, "FAIL 3/100" with the inputs outside, or "not judged". It is the reason of a check that did not
// run, and "-" if no check was run. Above the table are the drivers by number. Below it are, for each driver,
// how many checks failed and why, how many were not judged, and the worst error.
[[nodiscard]] std::string to_matrix(const std::vector<CheckReport>& reports);

// The same as a Markdown page.
[[nodiscard]] std::string to_matrix_markdown(const std::vector<CheckReport>& reports);

}  // namespace gloam::record
