// SPDX-License-Identifier: MIT
#include "support/run_command.hpp"

#include "base/process.hpp"

namespace gloam::test {

CommandResult run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                          const CommandOptions& options) {
    // It writes to files, which can never block it. A share of the tests is not a share of what they run.
    const TemporaryDirectory written;
    std::vector<std::string> command{"sh", "-c", R"(exec "$@" >"$0/out" 2>"$0/err")", written.path().string(),
                                     "env"};
    for (const char* sharding : {"GTEST_SHARD_INDEX", "GTEST_SHARD_STATUS_FILE", "GTEST_TOTAL_SHARDS"})
        command.insert(command.end(), {"-u", sharding});
    if (!options.working_directory.empty())
        command.insert(command.end(), {"-C", options.working_directory.string()});
    command.insert(command.end(), options.environment.begin(), options.environment.end());
    command.push_back(program.string());
    command.insert(command.end(), arguments.begin(), arguments.end());
    const base::ProcessResult ended = base::run_process(command, {.patience = options.timeout});
    using End = base::ProcessResult::End;
    if (ended.end == End::time)
        throw std::runtime_error(program.string() + " was still running after " +
                                 std::to_string(options.timeout.count()) + " s");
    return {.status = ended.number + (ended.end == End::signal ? 128 : 0),
            .out = read_file(written.path() / "out"),
            .err = read_file(written.path() / "err")};
}

CommandResult run_command(const std::vector<std::string>& arguments, const CommandOptions& options) {
    return run_program(GLOAM_BUILT_BINARY, arguments, options);
}

}  // namespace gloam::test
