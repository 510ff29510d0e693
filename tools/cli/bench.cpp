// SPDX-License-Identifier: MIT
#include "cli/bench.hpp"

#include <CLI/CLI.hpp>

#include "cli/bench/bar.hpp"
#include "cli/bench/benchmark_command.hpp"
#include "cli/bench/front.hpp"
#include "cli/bench/methods.hpp"
#include "cli/bench/passes.hpp"
#include "cli/bench/plain.hpp"
#include "cli/bench/skips.hpp"
#include "cli/bench/sources.hpp"
#include "cli/bench/temporal.hpp"
#include "cli/bench/views.hpp"

namespace gloam::cli {

void add_bench(CLI::App& app, int& status) {
    CLI::App* group =
        app.add_subcommand("bench", "time against error: which method with how many samples, on this device");
    group->require_subcommand(0, 1);
    add_benchmark(*group, status);
    add_bench_temporal(*group, status);
    add_bench_methods(*group, status);
    add_bench_passes(*group, status);
    add_bench_plain(*group, status);
    add_bench_skips(*group, status);
    add_bench_bar(*group, status);
    add_bench_sources(*group, status);
    add_bench_views(*group, status);
    add_bench_front(*group, status);
}

}  // namespace gloam::cli
