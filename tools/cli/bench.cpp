// SPDX-License-Identifier: MIT
#include "cli/bench.hpp"

#include "cli/bench/methods.hpp"
#include "cli/bench/temporal.hpp"

namespace gloam::cli {

void add_bench(CLI::App& app, int& status) {
    CLI::App* group = app.add_subcommand("bench", "measure the effect against the truth");
    group->require_subcommand(1);
    add_bench_temporal(*group, status);
    add_bench_methods(*group, status);
}

}  // namespace gloam::cli
