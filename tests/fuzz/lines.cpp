// SPDX-License-Identifier: MIT
// The messages of a worker process, which a driver may have overwritten, and the rows of a check.
#include "cli/check/task.hpp"
#include "fuzz/fuzz.hpp"
#include "report/check_report.hpp"

using namespace gloam;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view line = fuzz::text_of(data, size);
    fuzz::read_or_refuse([&] { (void)cli::to_line(cli::task_from(line)); });
    fuzz::read_or_refuse([&] { (void)cli::to_line(cli::greeting_from(line)); });
    fuzz::read_or_refuse([&] {
        const std::string written = report::to_json(report::answer_from_json(line));
        fuzz::require(report::to_json(report::answer_from_json(written)) == written);
    });
    return 0;
}
