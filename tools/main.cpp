// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

#include "base/files.hpp"
#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/framework/check.hpp"
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

gloam::cli::Command program() {
    using namespace gloam::cli;
    return {.name = "gloam",
            .about = "gloam: GLSL ambient occlusion, measured",
            .run =
                [] {
                    fmt::print("{}", first_steps);
                    return 0;
                },
            .examples =
                "  gloam demo                                  pictures, a check, a page\n"
                "  gloam check --device all --html check.html  every equation on every Vulkan device\n"
                "  gloam render mesh.obj                       a mesh in light, with and without\n"
                "  gloam COMMAND --help                        the options of a command\n",
            .commands = {demo_command(), devices_command(), list_command(), check_command(subjects_named),
                         check_worker_command(subjects_named), audit_command(equations_named),
                         explain_command(equations_named), cost_command(equations_named, frame_of),
                         mutate_command(), report_command(), render_command(), bench_command(),
                         stress_command(), pack_command()}};
}

}  // namespace

int main(int argc, char** argv) {
    gloam::base::reserve_standard_streams();
    std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of its write, not the end
    const std::vector<std::string> words(argv + 1, argv + argc);
    int status = could_not_run;
    try {
        status = finished(gloam::cli::run_command(program(), words));
    } catch (const std::exception& error) {
        const bool is_output =
            std::ferror(stdout) != 0 && dynamic_cast<const std::system_error*>(&error) != nullptr;
        complain((is_output ? "standard output: " : "") + std::string(error.what()));
    }
    const bool bisects = !words.empty() && words.front() == "check" &&
                         std::ranges::count(words, gloam::cli::bisect_option) > 0;
    return bisects && status == could_not_run ? skip_this_build : status;
}
