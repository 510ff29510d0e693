// SPDX-License-Identifier: MIT
// What `gloam report`, `bench --from` and `bench --compare` are given. What is read is written and read
// again.
#include <sstream>

#include "fuzz/fuzz.hpp"
#include "report/benchmark/benchmark_json.hpp"
#include "report/check_report.hpp"
#include "report/internal/plot_layout.hpp"
#include "report/laboratory/summary_lines.hpp"

using namespace gloam;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::text_of(data, size);
    fuzz::read_or_refuse([&] {
        const std::string written = report::to_json(report::reports_from_json(text));
        fuzz::require(report::to_json(report::reports_from_json(written)) == written);
    });
    fuzz::read_or_refuse([&] {
        report::LaboratorySummary summary;
        summary.add_file(text);
        std::istringstream lines(report::to_json_lines(summary));
        fuzz::require(report::news_since(report::earlier_from_lines(lines), summary).newly_failed.empty());
    });
    fuzz::read_or_refuse([&] {
        const report::Benchmark benchmark = report::benchmark_from_json(text);
        const std::string written = report::to_json(benchmark);
        fuzz::require(report::to_json(report::benchmark_from_json(written)) == written);
        (void)report::to_csv(benchmark);
        std::vector<double> values;
        for (const report::Row& row : benchmark.rows) values.push_back(row.total_copies.median);
        (void)report::internal::tics_of(report::internal::range_around(values));
    });
    return 0;
}
