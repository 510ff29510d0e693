// SPDX-License-Identifier: MIT
// What `gloam report`, `bench --from` and `bench --compare` are given. What is read is written and read
// again.
#include "experiment/results.hpp"
#include "fuzz/fuzz.hpp"
#include "report/check_report.hpp"
#include "report/internal/plot_layout.hpp"
#include "report/results_database.hpp"

using namespace gloam;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::text_of(data, size);
    fuzz::read_or_refuse([&] {
        const std::string written = report::to_json(report::reports_from_json(text));
        fuzz::require(report::to_json(report::reports_from_json(written)) == written);
    });
    fuzz::read_or_refuse([&] {
        report::ResultsDatabase database("", report::ResultsDatabase::Access::add);
        database.add(text);
        const report::LaboratorySummary summary = database.summary();
        database.add(text);
        const report::News news = report::news_since(summary, database.summary());
        fuzz::require(news.newly_failed.empty() && news.grew.empty() &&
                      database.summary().size() == summary.size());
    });
    fuzz::read_or_refuse([&] {
        const experiment::Record record = experiment::read_record("results", text);
        std::string written = record.heading();
        std::vector<double> values;
        for (const experiment::Visit& visit : record.visits()) {
            written += "\n" + line_of(visit);
            for (const experiment::FrameReading& reading : visit.readings) values.push_back(reading.copy_ms);
        }
        const experiment::Record back = experiment::read_record("results", written);
        fuzz::require(back.visits().size() == record.visits().size());
        for (std::size_t i = 0; i < back.visits().size(); ++i)
            fuzz::require(line_of(back.visits()[i]) == line_of(record.visits()[i]));
        (void)report::internal::tics_of(report::internal::range_around(values));
    });
    return 0;
}
