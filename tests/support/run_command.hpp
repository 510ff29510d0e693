// SPDX-License-Identifier: MIT
#pragma once

#include "support/files.hpp"

namespace gloam::test {

// What a finished program left behind.
struct CommandResult {
    int status = 0;  // its exit status; 128 + N when signal N ended it, as shells have it
    std::string out;
    std::string err;
};

struct CommandOptions {
    // "NAME=value", on top of this process's own without what GoogleTest says of shards
    std::vector<std::string> environment{};
    std::filesystem::path working_directory{};  // empty: this process's own
    std::chrono::seconds timeout{120};
};

// Runs `program` with `arguments`, standard input empty. What cannot be started ends with status 127. Throws
// std::runtime_error when it is still running after the timeout (it is killed then).
[[nodiscard]] CommandResult run_program(const std::filesystem::path& program,
                                        const std::vector<std::string>& arguments,
                                        const CommandOptions& options = {});

// run_program() of the gloam binary that this build makes.
[[nodiscard]] CommandResult run_command(const std::vector<std::string>& arguments,
                                        const CommandOptions& options = {});

// The words of a line, which single blanks part. Each {} in it stands for the next of the further arguments,
// whole even where that holds blanks.
template <class... Texts>
[[nodiscard]] std::vector<std::string> words(std::string_view line, const Texts&... arguments) {
    const std::vector<std::string> given{std::filesystem::path(arguments).string()...};
    auto next = given.begin();
    std::vector<std::string> all;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(' ', begin), line.size());
        const std::string_view word = line.substr(begin, end - begin);
        all.push_back(word == "{}" && next != given.end() ? *next++ : std::string(word));
        begin = end + 1;
    }
    return all;
}

// run_command() of the words of a line: gloam("check {} --inputs 64", file).
template <class... Texts>
[[nodiscard]] CommandResult gloam(std::string_view line, const Texts&... arguments) {
    return run_command(words(line, arguments...));
}

}  // namespace gloam::test
