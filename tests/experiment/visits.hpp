// SPDX-License-Identifier: MIT
#pragma once

#include "experiment/results.hpp"
#include "experiment/table.hpp"
#include "support/test.hpp"

namespace gloam::experiment {

// A visit in round 1 with five readings of so many milliseconds, in the mean, with a tenth of it as spread to
// each side. Round 0 judges and gives the error.
inline Visit make_visit(const std::string& shown, const std::string& candidate, int round, double ms,
                        double error) {
    Visit visit{.size = {320, 180},
                .shown = {.name = shown},
                .candidate = candidate,
                .group = candidate.substr(0, candidate.find('/')),
                .round = round,
                .samples_asked = 4};
    if (round == 0) {
        visit.quality = FrameQuality{.raw_geometry = 1.5 * error,
                                     .geometry = error,
                                     .depth = 0.5 * error,
                                     .similarity = 0.9,
                                     .samples = 4.0,
                                     .memory_bytes = 3'145'728};
        return visit;
    }
    for (const double part : {0.9, 0.9, 1.0, 1.1, 1.1})
        visit.readings.push_back({{{"ambient_occlusion", 0.6 * part * ms}, {"filter_x", 0.4 * part * ms}}});
    return visit;
}

// The text with a part replaced.
inline std::string with(std::string text, const std::string& part, const std::string& other) {
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), other);
}

struct Row {
    std::string shown;
    std::string candidate;
    double ms;
    double error;
};

inline Record make_record(const std::vector<Row>& rows) {
    Record record({.experiment = "mine",
                   .device = "device",
                   .driver = "driver 1",
                   .frames = 16,
                   .scored = 8,
                   .repeat = 1,
                   .rays = 256});
    for (const int round : {0, 1})
        for (const Row& row : rows)
            record.add(make_visit(row.shown, row.candidate, round, row.ms, row.error));
    return record;
}

// The lines of a record, as a journal has them.
inline std::string lines_of(const Record& record) {
    std::string text = line_of(record.conditions()) + "\n";
    for (const Visit& visit : record.visits()) text += line_of(visit) + "\n";
    return text;
}

// The rows of a table, without its heading.
inline std::string rows_of(const Record& record, const std::string& select, bool* missed = nullptr) {
    const Text text = to_text({.tables = {{.select = {select}}}}, Database(record));
    if (missed != nullptr) *missed = text.missed;
    return text.text.substr(text.text.find("|\n", text.text.find("--")) + 2);
}

}  // namespace gloam::experiment
