// SPDX-License-Identifier: MIT
#include "cli/bench.hpp"

#include <CLI/CLI.hpp>

#include "cli/bench/benchmark_command.hpp"
#include "cli/bench/experiments.hpp"
#include "cli/bench/methods.hpp"
#include "cli/bench/temporal.hpp"

namespace gloam::cli {

void add_bench(CLI::App& app, int& status) {
    CLI::App* group =
        app.add_subcommand("bench", "time against error: which method with how many samples, on this device");
    group->require_subcommand(0, 1);
    add_benchmark(*group, status);
    add_experiments(*group, status);
    add_bench_temporal(*group, status);
    add_bench_methods(*group, status);
}

}  // namespace gloam::cli
