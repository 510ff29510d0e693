// SPDX-License-Identifier: MIT
#include "support/run_command.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

namespace gloam::test {
namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

// An unnamed file rather than a pipe: a program can never block on it, however much it writes.
File scratch_file() {
    File file{std::tmpfile()};
    if (!file)
        throw std::system_error(errno, std::generic_category(), "no temporary file for a program's output");
    return file;
}

std::string contents(std::FILE* file) {
    std::rewind(file);
    std::string text;
    char block[4096];
    while (const std::size_t count = std::fread(block, 1, sizeof block, file)) text.append(block, count);
    return text;
}

// The pointers that exec wants, into strings that outlive the call.
std::vector<char*> pointers(std::vector<std::string>& strings) {
    std::vector<char*> result;
    for (std::string& text : strings) result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

std::vector<std::string> merged_environment(const std::vector<std::string>& extra) {
    const auto same_name = [](const std::string& a, const std::string& b) {
        return a.substr(0, a.find('=')) == b.substr(0, b.find('='));
    };
    std::vector<std::string> result = extra;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string text = *entry;
        // A share of the tests is not a share of what they run.
        const bool sharding = text.starts_with("GTEST_SHARD_") || text.starts_with("GTEST_TOTAL_SHARDS=");
        const bool replaced =
            std::any_of(extra.begin(), extra.end(), [&](const auto& e) { return same_name(e, text); });
        if (!replaced && !sharding) result.push_back(text);
    }
    return result;
}

class SpawnActions {
  public:
    SpawnActions() { posix_spawn_file_actions_init(&actions_); }
    ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;
    posix_spawn_file_actions_t* get() { return &actions_; }

  private:
    posix_spawn_file_actions_t actions_{};
};

pid_t start(const std::string& program, const std::vector<std::string>& arguments,
            const CommandOptions& options, std::FILE* out, std::FILE* err) {
    SpawnActions actions;
    posix_spawn_file_actions_addopen(actions.get(), STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(actions.get(), fileno(out), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(actions.get(), fileno(err), STDERR_FILENO);
    if (!options.working_directory.empty())
        posix_spawn_file_actions_addchdir_np(actions.get(), options.working_directory.c_str());

    std::vector<std::string> words{program};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<std::string> environment = merged_environment(options.environment);
    pid_t child = 0;
    const int error = posix_spawnp(&child, program.c_str(), actions.get(), nullptr, pointers(words).data(),
                                   pointers(environment).data());
    if (error != 0) throw std::system_error(error, std::generic_category(), "cannot start " + program);
    return child;
}

int wait_for(pid_t child, const std::string& program, std::chrono::seconds timeout) {
    const auto deadline = std::chrono::steady_clock::now() + timeout;
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > deadline) {
            kill(child, SIGKILL);
            waitpid(child, &status, 0);
            throw std::runtime_error(program + " was still running after " + std::to_string(timeout.count()) +
                                     " s");
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

CommandResult run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                          const CommandOptions& options) {
    const File out = scratch_file();
    const File err = scratch_file();
    const pid_t child = start(program.string(), arguments, options, out.get(), err.get());
    const int status = wait_for(child, program.string(), options.timeout);
    return {status, contents(out.get()), contents(err.get())};
}

CommandResult run_command(const std::vector<std::string>& arguments, const CommandOptions& options) {
    return run_program(GLOAM_BUILT_BINARY, arguments, options);
}

int line_count(const std::string& text) {
    const auto newlines = std::count(text.begin(), text.end(), '\n');
    return static_cast<int>(newlines) + (!text.empty() && text.back() != '\n' ? 1 : 0);
}

}  // namespace gloam::test
