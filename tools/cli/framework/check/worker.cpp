// SPDX-License-Identifier: MIT
#include "cli/framework/check/checker.hpp"

#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <iostream>
#include <optional>
#include <system_error>

#include "backend/gl/device.hpp"
#include "cli/framework/open_device.hpp"

namespace gloam::cli {
namespace {

constexpr const char* this_program = "/proc/self/exe";
constexpr const char* subcommand = "check-worker";

// Sends lines to the parent. Standard output itself is redirected to standard error, because a driver may
// print.
class Replies {
  public:
    Replies() : file_(fdopen(dup(STDOUT_FILENO), "w")) {
        if (file_ == nullptr || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) {
            throw std::system_error(errno, std::generic_category(), "no standard output");
        }
    }
    ~Replies() { std::fclose(file_); }
    Replies(const Replies&) = delete;
    Replies& operator=(const Replies&) = delete;

    void send(const std::string& line) {
        std::fputs((line + "\n").c_str(), file_);
        std::fflush(file_);
    }

  private:
    std::FILE* file_;
};

// Says what devices there are and ends.
template <class List>
void list_and_tell(const List& list) {
    Replies replies;
    Listing listing;
    try {
        for (const backend::DeviceInfo& device : list()) listing.devices.push_back(device);
    } catch (const std::exception& error) {
        listing.error = error.what();
    }
    replies.send(record::line_of(listing));
}

// Lets the Vulkan loader say on standard output what it does, and ends.
void list_manifests() {
    if (dup2(STDOUT_FILENO, STDERR_FILENO) >= 0) list_and_tell(gpu::list_devices);
}

void run_worker(const CheckerOptions& options) {
    Replies replies;
    std::optional<Checker> checker;
    Greeting greeting;
    try {
        checker.emplace(options);
        greeting.device = checker->device();
    } catch (const std::exception& error) {
        greeting.error = error.what();
    }
    replies.send(record::line_of(greeting));
    if (!checker) return;
    for (std::string line; std::getline(std::cin, line);) {
        const auto request = record::from_line<WorkerRequest>(line);
        replies.send(request.failed ? record::line_of(checker->bundle(request.task, *request.failed))
                                    : record::line_of(checker->run(request.task)));
    }
}

}  // namespace

std::vector<std::string> worker_command(const CheckerOptions& options) {
    std::vector<std::string> command{this_program, subcommand, "--timeout",
                                     std::to_string(options.timeout.count())};
    if (!options.device.empty()) command.push_back("--device=" + options.device);
    if (options.validation) command.emplace_back("--validation");
    return command;
}

std::vector<std::string> listing_command(const std::string& option) {
    return {this_program, subcommand, option};
}

Command check_worker_command(EquationsNamed* equations) {
    static CheckerOptions options{.equations = equations};
    static std::optional<int> timeout;
    static bool list = false;
    static bool manifests = false;
    static std::string executor;
    return {.name = subcommand,
            .options = {{"--device", &options.device},
                        {"--timeout", &timeout, positive, "milliseconds"},
                        {"--validation", &options.validation},
                        {"--list", &list, "only list the devices"},
                        {"--manifests", &manifests, "only let the Vulkan loader say which drivers it finds"},
                        {"--opengl", &executor, "only list the OpenGL devices of this executor"}},
            .run = [] {
                if (timeout) options.timeout = std::chrono::milliseconds(*timeout);
                if (!executor.empty())
                    list_and_tell([&] { return gl::list_devices(executor); });
                else if (manifests)
                    list_manifests();
                else if (list)
                    list_and_tell(gpu::list_devices);
                else
                    run_worker(options);
                return 0;
            }};
}

}  // namespace gloam::cli
