// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "cli/bench.hpp"
#include "cli/check.hpp"
#include "cli/check/worker.hpp"
#include "cli/demo.hpp"
#include "cli/devices.hpp"
#include "cli/list.hpp"
#include "cli/pack.hpp"
#include "cli/render.hpp"
#include "cli/report.hpp"
#include "cli/stress.hpp"

namespace {

constexpr int could_not_run = 2;

// One line, whatever the message holds.
std::string one_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    for (char& c : text) {
        if (c == '\n') c = ' ';
    }
    return text;
}

int run(int argc, char** argv) {
    int status = 0;
    CLI::App app("gloam: GLSL ambient occlusion, measured", "gloam");
    app.require_subcommand(0, 1);  // none is said below: an unknown word must be named first
    app.failure_message(CLI::FailureMessage::simple);
    gloam::cli::add_demo(app, status);
    gloam::cli::add_devices(app);
    gloam::cli::add_list(app);
    gloam::cli::add_check(app, status);
    gloam::cli::add_check_worker(app);
    gloam::cli::add_report(app, status);
    gloam::cli::add_render(app, status);
    gloam::cli::add_bench(app, status);
    gloam::cli::add_stress(app, status);
    gloam::cli::add_pack(app);
    try {
        app.parse(argc, argv);
        if (app.get_subcommands().empty()) throw CLI::RequiredError("A subcommand");
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::CallForAllHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr, "gloam: {} (gloam --help tells more)\n", one_line(error.what()));
        return could_not_run;
    }
    return status;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "gloam: {}\n", one_line(error.what()));
        return could_not_run;
    }
}
