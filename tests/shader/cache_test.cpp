// SPDX-License-Identifier: MIT
#include "shader/cache.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <thread>

#include "support.hpp"

namespace gloam::shader {
namespace cache_test {

using test::fixture;
using test::kernel;
using test::TempDir;
using test::with_fixtures;

const Source source = kernel("#include \"math/hypot.glsl\"", "fx_hypot(3.0, 4.0)");

std::size_t files_in(const std::filesystem::path& directory) {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(directory), std::filesystem::directory_iterator()));
}

std::vector<std::string> prototypes(const std::vector<Function>& functions) {
    std::vector<std::string> texts;
    for (const Function& function : functions)
        texts.push_back((function.defined ? "" : "? ") + to_glsl(function) + " " + to_glsl(function.result));
    return texts;
}

TEST(SpirvCache, GivesWhatTheCompilerGives) {
    const TempDir dir;
    const SpirvCache cache(dir.path() / "new" / "folder");
    const Spirv expected = compile(source, with_fixtures());
    EXPECT_EQ(cache.compile(source, with_fixtures()), expected);
    EXPECT_EQ(cache.compile(source, with_fixtures()), expected);
    EXPECT_EQ(files_in(dir.path() / "new" / "folder"), 1u);
}

// An entry that is exchanged for another valid one is what comes back: so it is really read.
TEST(SpirvCache, ReadsTheEntryInsteadOfCompiling) {
    const TempDir dir;
    const auto lib = dir.write("lib.glsl", "float f() { return 1.0; }\n");
    const Source user = kernel("#include \"lib.glsl\"", "f()");
    const CompileOptions options{.include_roots = {dir.path()}};
    const SpirvCache cache(dir.path() / "cache");
    const Spirv stored = cache.compile(user, options);
    const auto entry = std::filesystem::directory_iterator(dir.path() / "cache")->path();
    const auto written = std::filesystem::last_write_time(entry);
    std::filesystem::last_write_time(entry, written - std::chrono::hours(1));
    EXPECT_EQ(cache.compile(user, options), stored);
    EXPECT_EQ(std::filesystem::last_write_time(entry), written - std::chrono::hours(1))
        << "the entry was written again";
}

TEST(SpirvCache, FunctionsSurviveTheRoundTrip) {
    const TempDir dir;
    const SpirvCache cache(dir.path());
    for (const char* name : {"types.glsl", "fetch.glsl"}) {
        const Source text{"text", "#version 450\n#include \"" + std::string(name) +
                                      "\"\nfloat f(float a[2], out double d) { d = 1.0LF; return a[0]; }\n"};
        const auto expected = prototypes(functions(text, with_fixtures()));
        EXPECT_EQ(prototypes(cache.functions(text, with_fixtures())), expected);
        EXPECT_EQ(prototypes(cache.functions(text, with_fixtures())), expected);
    }
    EXPECT_EQ(files_in(dir.path()), 2u);
}

TEST(SpirvCache, KeepsApartWhateverDiffers) {
    const TempDir dir;
    const SpirvCache cache(dir.path());
    Source renamed = source;
    renamed.name = "other";
    Source changed = source;
    changed.text += " ";
    EXPECT_EQ(cache.compile(source, with_fixtures()), compile(source, with_fixtures()));
    EXPECT_EQ(cache.compile(source, with_fixtures(Optimization::performance)),
              compile(source, with_fixtures(Optimization::performance)));
    EXPECT_EQ(cache.compile(source, with_fixtures(Optimization::size)),
              compile(source, with_fixtures(Optimization::size)));
    for (const char* name : {"strict", "relaxed", "round_trip"}) {
        CompileOptions options = with_fixtures();
        options.variant = variant(name);
        EXPECT_EQ(cache.compile(source, options), compile(source, options)) << name;
    }
    static_cast<void>(cache.compile(renamed, with_fixtures()));
    static_cast<void>(cache.compile(changed, with_fixtures()));
    static_cast<void>(cache.functions(source, with_fixtures()));
    EXPECT_EQ(files_in(dir.path()), 9u);
    CompileOptions strict = with_fixtures();
    strict.variant = variant("strict");
    static_cast<void>(cache.functions(source, strict));
    EXPECT_EQ(files_in(dir.path()), 9u) << "functions are those of every variant";

    const Source any_stage{"any", "#version 450\nvoid main() {}\n"};
    for (const Stage stage : {Stage::compute, Stage::vertex, Stage::fragment})
        EXPECT_EQ(cache.compile(any_stage, {.stage = stage}), compile(any_stage, {.stage = stage}));
}

TEST(SpirvCache, ChangedIncludeIsCompiledAgain) {
    const TempDir dir;
    const SpirvCache cache(dir.path() / "cache");
    const CompileOptions options{.include_roots = {dir.path()}};
    const Source user = kernel("#include \"outer.glsl\"", "f()");
    dir.write("outer.glsl", "#include \"inner.glsl\"\n");
    dir.write("inner.glsl", "float f() { return 1.0; }\n");
    const Spirv one = cache.compile(user, options);
    dir.write("inner.glsl", "float f() { return 2.0; }\n");
    const Spirv two = cache.compile(user, options);
    EXPECT_NE(one, two);
    EXPECT_EQ(two, compile(user, options));
    dir.write("inner.glsl", "float f() { return 1.0; }\n");
    EXPECT_EQ(cache.compile(user, options), one);
    dir.write("inner.glsl", "float f() { return x; }\n");
    EXPECT_THROW(static_cast<void>(cache.compile(user, options)), CompileError);
}

TEST(SpirvCache, AFileThatHidesAnotherIsNoticed) {
    const TempDir dir;
    const SpirvCache cache(dir.path() / "cache");
    const CompileOptions options{.include_roots = {dir.path() / "first", dir.path() / "second"}};
    const Source user = kernel("#include \"f.glsl\"", "f()");
    dir.write("second/f.glsl", "float f() { return 1.0; }\n");
    static_cast<void>(cache.compile(user, options));
    dir.write("first/f.glsl", "float f() { return 2.0; }\n");
    EXPECT_EQ(cache.compile(user, options), compile(user, options));
}

TEST(SpirvCache, IncludeBesideTheSourceCounts) {
    const TempDir dir;
    const SpirvCache cache(dir.path() / "cache");
    Source user = kernel("#include \"f.glsl\"", "f()");
    user.name = (dir.path() / "user.comp").string();
    dir.write("f.glsl", "float f() { return 1.0; }\n");
    const Spirv one = cache.compile(user, {});
    dir.write("f.glsl", "float f() { return 2.0; }\n");
    EXPECT_NE(cache.compile(user, {}), one);
}

TEST(SpirvCache, ErrorsAreThrownEveryTimeAndNotStored) {
    const TempDir dir;
    const SpirvCache cache(dir.path());
    const Source bad = kernel("#include \"broken/outer.glsl\"", "1.0");
    for (int i = 0; i < 2; ++i) {
        EXPECT_THROW(static_cast<void>(cache.compile(bad, with_fixtures())), CompileError);
        EXPECT_THROW(static_cast<void>(cache.functions(bad, with_fixtures())), CompileError);
    }
    EXPECT_EQ(files_in(dir.path()), 0u);
}

TEST(SpirvCache, WithoutAFolderNothingIsKept) {
    const SpirvCache cache;
    EXPECT_EQ(cache.compile(source, with_fixtures()), compile(source, with_fixtures()));
    EXPECT_FALSE(cache.functions(source, with_fixtures()).empty());
}

TEST(SpirvCache, ThreadsMayShareIt) {
    const TempDir dir;
    const SpirvCache cache(dir.path());
    const Spirv expected = compile(source, with_fixtures());
    std::array<Spirv, 4> results;
    {
        std::vector<std::jthread> threads;
        for (Spirv& result : results)
            threads.emplace_back([&] { result = cache.compile(source, with_fixtures()); });
    }
    for (const Spirv& result : results) EXPECT_EQ(result, expected);
    EXPECT_EQ(files_in(dir.path()), 1u);
}

// The children start together on an empty folder and remove the entry now and then, so that reads meet
// writes.
TEST(SpirvCache, ProcessesMayShareIt) {
    const TempDir dir;
    const Spirv expected = compile(source, with_fixtures());
    std::vector<pid_t> children;
    for (int child = 0; child < 2; ++child) {
        const pid_t pid = fork();
        ASSERT_NE(pid, -1);
        if (pid == 0) {
            bool right = true;
            for (int i = 0; i < 40; ++i) {
                right = right && SpirvCache(dir.path()).compile(source, with_fixtures()) == expected;
                std::error_code ignored;
                if (i % 3 == child)
                    for (const auto& entry : std::filesystem::directory_iterator(dir.path(), ignored))
                        if (entry.path().extension() == ".spv")
                            std::filesystem::remove(entry.path(), ignored);
            }
            _exit(right ? 0 : 1);
        }
        children.push_back(pid);
    }
    for (const pid_t pid : children) {
        int status = -1;
        ASSERT_EQ(waitpid(pid, &status, 0), pid);
        EXPECT_TRUE(WIFEXITED(status));
        EXPECT_EQ(WEXITSTATUS(status), 0);
    }
    EXPECT_LE(files_in(dir.path()), 1u) << "temporary files stay behind";
}

}  // namespace cache_test
}  // namespace gloam::shader
