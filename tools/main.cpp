// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/files.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/framework/check.hpp"
#include "cli/framework/check/checker.hpp"
#include "cli/framework/cost.hpp"
#include "cli/occlusion/names.hpp"

namespace {

constexpr int could_not_run = 2;
constexpr int skip_this_build = 125;  // of `git bisect run`
constexpr std::size_t longest_message = 2000;

// One line, whatever the message holds.
void complain(const std::string& message) {
    const std::string line = gloam::base::shortened(gloam::base::one_line(message), longest_message);
    std::fputs(("gloam: " + line + "\n").c_str(), stderr);  // nothing is left to do where this fails
}

// What was printed has arrived, or the run has failed: a full disk shows as late as here.
int finished(int status) {
    errno = 0;
    const bool streamed = static_cast<bool>(std::cout.flush());
    if (std::ferror(stdout) == 0 && std::fflush(stdout) == 0 && streamed) return status;
    const int error = errno;
    if (status != could_not_run)
        complain(fmt::format("cannot write to standard output: {}",
                             error == 0 ? "an earlier write failed" : std::strerror(error)));
    return could_not_run;
}

// What one does first, for a call without a subcommand.
constexpr const char* first_steps =
    "gloam: GLSL ambient occlusion, measured, and tests for any GLSL function\n\n"
    "  gloam demo                         pictures and a check of this device, on one page\n"
    "  gloam render room --truth          ambient occlusion of a scene, a mesh or a G-buffer\n"
    "  gloam pack --effect --out FOLDER   copy: the effect, or functions, for an engine\n"
    "  gloam check FILE.glsl              test: the functions of a file of your own\n"
    "  gloam check --device all           judge: every equation on every driver here\n\n"
    "gloam --help lists all commands, gloam COMMAND --help the options of one.\n";

int fail(const std::exception& error) {
    if (std::ferror(stdout) != 0 && dynamic_cast<const std::system_error*>(&error) != nullptr)
        complain(fmt::format("standard output: {}", error.what()));
    else
        complain(error.what());
    return could_not_run;
}

// The command whose arguments are wrong, with --help.
std::string help_of(const CLI::App& app) {
    std::string words = "gloam";
    for (const CLI::App* command = &app; !command->get_subcommands().empty();) {
        command = command->get_subcommands().front();
        words += " " + command->get_name();
    }
    return words + " --help";
}

int run(int argc, char** argv) {
    int status = 0;
    std::vector<std::string> arguments =
        gloam::cli::with_numbers_apart(gloam::cli::with_own_experiment({argv + 1, argv + argc}));
    std::vector<std::string> tested = gloam::cli::take_command(arguments);
    CLI::App app("gloam: GLSL ambient occlusion, measured", "gloam");
    app.require_subcommand(0, 1);
    app.failure_message(CLI::FailureMessage::simple);
    app.set_version_flag("--version", [] { return gloam::cli::versions(); });
    gloam::cli::add_demo(app, status);
    gloam::cli::add_devices(app);
    gloam::cli::add_list(app);
    gloam::cli::add_check(app, gloam::cli::subjects_named, status);
    gloam::cli::add_check_worker(app, gloam::cli::subjects_named);
    gloam::cli::add_audit(app, gloam::cli::equations_named, status);
    gloam::cli::add_explain(app, gloam::cli::equations_named);
    gloam::cli::add_cost(app, gloam::cli::equations_named, gloam::cli::frame_of, status);
    gloam::cli::add_mutate(app, std::move(tested), status);
    gloam::cli::add_report(app, status);
    gloam::cli::add_render(app, status);
    gloam::cli::add_bench(app, status);
    gloam::cli::add_stress(app, status);
    gloam::cli::add_pack(app);
    gloam::cli::add_help_examples(app);
    gloam::cli::refuse_meaningless_values(app);
    try {
        std::ranges::reverse(arguments);  // the order in which CLI11 takes them
        app.parse(std::move(arguments));
        if (app.get_subcommands().empty()) fmt::print("{}", first_steps);
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::CallForVersion& version) {
        return app.exit(version);
    } catch (const CLI::CallForAllHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        complain(fmt::format("{} ({} tells more)", error.what(), help_of(app)));
        return could_not_run;
    }
    return status;
}

int status_of(int argc, char** argv) {
    try {
        return finished(run(argc, argv));
    } catch (const std::exception& error) {
        return fail(error);
    }
}

}  // namespace

int main(int argc, char** argv) {
    gloam::base::reserve_standard_streams();
    std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of its write, not the end
    const int status = status_of(argc, argv);
    const std::vector<std::string_view> words(argv, argv + argc);
    const bool bisects =
        words.size() > 1 && words[1] == "check" && std::ranges::count(words, gloam::cli::bisect_option) > 0;
    return bisects && status == could_not_run ? skip_this_build : status;
}
