// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "report/benchmark/result.hpp"

namespace gloam::report {

// A row that was measured: `copies` with a tenth of it as spread to each side, milliseconds a tenth of
// copies.
inline Row make_row(const std::string& scene, const std::string& method, std::uint32_t samples, double copies,
                    double error, bool temporal = false) {
    const Spread time{copies, 0.9 * copies, 1.1 * copies};
    const Spread ms{0.1 * copies, 0.09 * copies, 0.11 * copies};
    Row row{.configuration = {.scene = scene, .method = method, .samples = samples, .temporal = temporal},
            .passes = {{"ambient_occlusion", 0.06 * copies}, {"filter_x", 0.04 * copies}},
            .gather_ms = ms,
            .total_ms = ms,
            .gather_copies = time,
            .total_copies = time,
            .readings = 5};
    row.quality = {.raw_geometry = 1.5 * error,
                   .raw_depth = 1.25 * error,
                   .geometry = error,
                   .depth = 0.5 * error,
                   .similarity = 0.9,
                   .samples = static_cast<double>(samples),
                   .memory_bytes = 3'145'728};
    if (temporal) row.quality.flicker = 0.001;
    return row;
}

inline Benchmark make_benchmark(std::vector<Row> rows) {
    return {.device = "device",
            .driver = "driver 1",
            .width = 320,
            .height = 180,
            .frames = 16,
            .scored = 8,
            .repeat = 5,
            .rays = 256,
            .copy_ms = {0.1, 0.09, 0.12},
            .rows = std::move(rows)};
}

}  // namespace gloam::report
