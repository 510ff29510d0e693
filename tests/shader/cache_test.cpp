// SPDX-License-Identifier: MIT
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "shader/include.hpp"
#include "support.hpp"

namespace gloam::shader::cache_test {

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

using SpirvCacheTest = InFolder;

TEST_F(SpirvCacheTest, GivesWhatTheCompilerGives) {
    const SpirvCache cache(folder.path() / "new" / "folder");
    const Spirv expected = compile(source, with_fixtures());
    EXPECT_EQ(cache.compile(source, with_fixtures()), expected);
    EXPECT_EQ(cache.compile(source, with_fixtures()), expected);
    EXPECT_EQ(files_in(folder.path() / "new" / "folder"), 1u);
}

// An entry that is exchanged for another valid one is what comes back: so it is really read.
TEST_F(SpirvCacheTest, ReadsTheEntryInsteadOfCompiling) {
    const auto lib = folder.write("lib.glsl", "float f() { return 1.0; }\n");
    const Source user = kernel("#include \"lib.glsl\"", "f()");
    const CompileOptions options{.include_roots = {folder.path()}};
    const SpirvCache cache(folder.path() / "cache");
    const Spirv stored = cache.compile(user, options);
    const auto entry = std::filesystem::directory_iterator(folder.path() / "cache")->path();
    const auto written = std::filesystem::last_write_time(entry);
    std::filesystem::last_write_time(entry, written - std::chrono::hours(1));
    EXPECT_EQ(cache.compile(user, options), stored);
    EXPECT_EQ(std::filesystem::last_write_time(entry), written - std::chrono::hours(1))
        << "the entry was written again";
}

TEST_F(SpirvCacheTest, FunctionsSurviveTheRoundTrip) {
    const SpirvCache cache(folder.path());
    for (const char* name : {"types.glsl", "fetch.glsl"}) {
        const Source text{"text", "#version 450\n#include \"" + std::string(name) +
                                      "\"\nfloat f(float a[2], out double d) { d = 1.0LF; return a[0]; }\n"};
        const auto expected = prototypes(functions(text, with_fixtures()));
        EXPECT_EQ(prototypes(cache.functions(text, with_fixtures())), expected);
        EXPECT_EQ(prototypes(cache.functions(text, with_fixtures())), expected);
    }
    EXPECT_EQ(files_in(folder.path()), 2u);
}

TEST_F(SpirvCacheTest, KeepsApartWhateverDiffers) {
    const SpirvCache cache(folder.path());
    Source renamed = source;
    renamed.name = "other";
    Source changed = source;
    changed.text += " ";
    EXPECT_EQ(cache.compile(source, with_fixtures()), compile(source, with_fixtures()));
    EXPECT_EQ(cache.compile(source, with_fixtures(Optimization::performance)),
              compile(source, with_fixtures(Optimization::performance)));
    EXPECT_EQ(cache.compile(source, with_fixtures(Optimization::size)),
              compile(source, with_fixtures(Optimization::size)));
    for (const char* name : {"strict", "relaxed"}) {
        CompileOptions options = with_fixtures();
        options.variant = variant(name);
        EXPECT_EQ(cache.compile(source, options), compile(source, options)) << name;
    }
    static_cast<void>(cache.compile(renamed, with_fixtures()));
    static_cast<void>(cache.compile(changed, with_fixtures()));
    static_cast<void>(cache.functions(source, with_fixtures()));
    EXPECT_EQ(files_in(folder.path()), 8u);
    CompileOptions strict = with_fixtures();
    strict.variant = variant("strict");
    static_cast<void>(cache.functions(source, strict));
    EXPECT_EQ(files_in(folder.path()), 8u) << "functions are those of every variant";

    const Source any_stage{"any", "#version 450\nvoid main() {}\n"};
    for (const Stage stage : {Stage::compute, Stage::vertex, Stage::fragment})
        EXPECT_EQ(cache.compile(any_stage, {.stage = stage}), compile(any_stage, {.stage = stage}));
}

TEST_F(SpirvCacheTest, ChangedIncludeIsCompiledAgain) {
    const SpirvCache cache(folder.path() / "cache");
    const CompileOptions options{.include_roots = {folder.path()}};
    const Source user = kernel("#include \"outer.glsl\"", "f()");
    folder.write("outer.glsl", "#include \"inner.glsl\"\n");
    folder.write("inner.glsl", "float f() { return 1.0; }\n");
    const Spirv one = cache.compile(user, options);
    folder.write("inner.glsl", "float f() { return 2.0; }\n");
    const Spirv two = cache.compile(user, options);
    EXPECT_NE(one, two);
    EXPECT_EQ(two, compile(user, options));
    folder.write("inner.glsl", "float f() { return 1.0; }\n");
    EXPECT_EQ(cache.compile(user, options), one);
    folder.write("inner.glsl", "float f() { return x; }\n");
    EXPECT_THROW(static_cast<void>(cache.compile(user, options)), CompileError);
}

TEST_F(SpirvCacheTest, AFileThatHidesAnotherIsNoticed) {
    const SpirvCache cache(folder.path() / "cache");
    const CompileOptions options{.include_roots = {folder.path() / "first", folder.path() / "second"}};
    const Source user = kernel("#include \"f.glsl\"", "f()");
    folder.write("second/f.glsl", "float f() { return 1.0; }\n");
    static_cast<void>(cache.compile(user, options));
    folder.write("first/f.glsl", "float f() { return 2.0; }\n");
    EXPECT_EQ(cache.compile(user, options), compile(user, options));
}

TEST_F(SpirvCacheTest, IncludeBesideTheSourceCounts) {
    const SpirvCache cache(folder.path() / "cache");
    Source user = kernel("#include \"f.glsl\"", "f()");
    user.name = (folder.path() / "user.comp").string();
    folder.write("f.glsl", "float f() { return 1.0; }\n");
    const Spirv one = cache.compile(user, {});
    folder.write("f.glsl", "float f() { return 2.0; }\n");
    EXPECT_NE(cache.compile(user, {}), one);
}

TEST_F(SpirvCacheTest, ErrorsAreThrownEveryTimeAndNotStored) {
    const SpirvCache cache(folder.path());
    const Source bad = kernel("#include \"broken/outer.glsl\"", "1.0");
    for (int i = 0; i < 2; ++i) {
        EXPECT_THROW(static_cast<void>(cache.compile(bad, with_fixtures())), CompileError);
        EXPECT_THROW(static_cast<void>(cache.functions(bad, with_fixtures())), CompileError);
    }
    EXPECT_EQ(files_in(folder.path()), 0u);
}

TEST_F(SpirvCacheTest, WithoutAFolderNothingIsKept) {
    const SpirvCache cache;
    EXPECT_EQ(cache.compile(source, with_fixtures()), compile(source, with_fixtures()));
    EXPECT_FALSE(cache.functions(source, with_fixtures()).empty());
}

TEST_F(SpirvCacheTest, ThreadsMayShareIt) {
    const SpirvCache cache(folder.path());
    const Spirv expected = compile(source, with_fixtures());
    std::array<Spirv, 4> results;
    {
        std::vector<std::jthread> threads;
        for (Spirv& result : results)
            threads.emplace_back([&] { result = cache.compile(source, with_fixtures()); });
    }
    for (const Spirv& result : results) EXPECT_EQ(result, expected);
    EXPECT_EQ(files_in(folder.path()), 1u);
}

// The children start together on an empty folder and remove the entry now and then, so that reads meet
// writes.
TEST_F(SpirvCacheTest, ProcessesMayShareIt) {
    const Spirv expected = compile(source, with_fixtures());
    std::vector<pid_t> children;
    for (int child = 0; child < 2; ++child) {
        const pid_t pid = fork();
        ASSERT_NE(pid, -1);
        if (pid == 0) {
            bool right = true;
            for (int i = 0; i < 40; ++i) {
                right = right && SpirvCache(folder.path()).compile(source, with_fixtures()) == expected;
                std::error_code ignored;
                if (i % 3 == child)
                    for (const auto& entry : std::filesystem::directory_iterator(folder.path(), ignored))
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
    EXPECT_LE(files_in(folder.path()), 1u) << "temporary files stay behind";
}

const Source doubling = kernel("float f(float x) { return x * 2.0; }", "f(3.0)");

// A cache with one entry of a module and one of functions; `damage` gets the file of an entry and its bytes.
class CacheDamage : public testing::Test {
  protected:
    CacheDamage() {
        static_cast<void>(cache_.compile(doubling, {}));
        module_entry_ = only_file("spv");
        static_cast<void>(cache_.functions(doubling, {}));
        functions_entry_ = only_file("functions");
        module_bytes_ = base::read_file(module_entry_);
        functions_bytes_ = base::read_file(functions_entry_);
    }

    std::filesystem::path only_file(const std::string& extension) const {
        std::vector<std::filesystem::path> found;
        for (const auto& entry : std::filesystem::directory_iterator(dir_.path()))
            if (entry.path().extension() == "." + extension) found.push_back(entry.path());
        EXPECT_EQ(found.size(), 1u);
        return found.at(0);
    }

    static void write(const std::filesystem::path& file, std::string_view bytes) {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
    }

    // The result is right, and the entry is as new.
    void expect_repaired(const std::string& what) const {
        EXPECT_EQ(cache_.compile(doubling, {}), module_) << what;
        EXPECT_EQ(base::read_file(module_entry_), module_bytes_) << what;
        const auto functions = cache_.functions(doubling, {});
        ASSERT_EQ(functions.size(), 2u) << what;
        EXPECT_EQ(to_glsl(functions[0]), "float f(float x)") << what;
        EXPECT_EQ(base::read_file(functions_entry_), functions_bytes_) << what;
    }

    // Both entries with their bytes changed.
    void damage(const std::string& what, const std::function<std::string(std::string)>& change) const {
        write(module_entry_, change(module_bytes_));
        write(functions_entry_, change(functions_bytes_));
        expect_repaired(what);
    }

    TemporaryDirectory dir_;
    SpirvCache cache_{dir_.path()};
    Spirv module_ = compile(doubling, {});
    std::filesystem::path module_entry_;
    std::filesystem::path functions_entry_;
    std::string module_bytes_;
    std::string functions_bytes_;
};

TEST_F(CacheDamage, EveryTruncationIsNoticed) {
    for (std::size_t length = 0; length < functions_bytes_.size(); ++length)
        damage("cut to " + std::to_string(length),
               [&](std::string bytes) { return bytes.substr(0, length); });
    for (std::size_t missing : {1u, 2u, 3u, 4u, 5u, 8u, 64u})
        damage("cut by " + std::to_string(missing),
               [&](std::string bytes) { return bytes.substr(0, bytes.size() - missing); });
}

TEST_F(CacheDamage, AdditionalBytesAreNoticed) {
    damage("one more", [](std::string bytes) { return bytes + '\0'; });
    damage("four more", [](std::string bytes) { return bytes + "abcd"; });
    damage("twice", [](const std::string& bytes) { return bytes + bytes; });
}

TEST_F(CacheDamage, EveryFlippedByteIsNoticed) {
    for (std::size_t at = 0; at < functions_bytes_.size(); ++at)
        damage("byte " + std::to_string(at), [&](std::string bytes) {
            bytes[at] = static_cast<char>(bytes[at] ^ (1 << (at % 8)));
            return bytes;
        });
    damage("last byte", [](std::string bytes) {
        bytes.back() = static_cast<char>(bytes.back() ^ 0x40);
        return bytes;
    });
}

TEST_F(CacheDamage, ForeignFilesAreReplaced) {
    damage("text", [](const std::string&) { return "this is not an entry\n"; });
    damage("zeros", [](const std::string& bytes) { return std::string(bytes.size(), '\0'); });
    damage("megabyte", [](const std::string&) { return std::string(1u << 20, 'x'); });
    const Spirv foreign = module_;
    damage("bare module", [&](const std::string&) {
        return std::string(reinterpret_cast<const char*>(foreign.data()),
                           foreign.size() * sizeof(foreign[0]));
    });
}

// A whole, valid entry of another key or kind under this name.
TEST_F(CacheDamage, ExchangedEntriesAreNoticed) {
    write(module_entry_, functions_bytes_);
    write(functions_entry_, module_bytes_);
    expect_repaired("exchanged");

    TemporaryDirectory other;
    static_cast<void>(SpirvCache(other.path()).compile(kernel("", "7.0"), {}));
    write(module_entry_, base::read_file(std::filesystem::directory_iterator(other.path())->path()));
    expect_repaired("other key");
}

TEST_F(CacheDamage, AnEmptyFolderInPlaceIsReplaced) {
    std::filesystem::remove(module_entry_);
    std::filesystem::create_directory(module_entry_);
    expect_repaired("empty folder");
}

TEST_F(CacheDamage, AFullFolderInPlaceStaysAndCostsOnlySpeed) {
    std::filesystem::remove(module_entry_);
    std::filesystem::create_directory(module_entry_);
    write(module_entry_ / "precious", "kept");
    for (int i = 0; i < 2; ++i) EXPECT_EQ(cache_.compile(doubling, {}), module_);
    EXPECT_EQ(base::read_file(module_entry_ / "precious"), "kept");
    for (const auto& entry : std::filesystem::directory_iterator(dir_.path()))
        EXPECT_NE(entry.path().extension(), ".tmp");
}

TEST_F(CacheDamage, ALinkToNowhereIsReplaced) {
    std::filesystem::remove(module_entry_);
    std::filesystem::create_symlink(dir_.path() / "nowhere", module_entry_);
    expect_repaired("link");
}

// Opening it would wait for ever.
TEST_F(CacheDamage, APipeInPlaceIsReplaced) {
    std::filesystem::remove(module_entry_);
    ASSERT_EQ(mkfifo(module_entry_.c_str(), 0600), 0);
    expect_repaired("pipe");
}

TEST_F(CacheDamage, AFolderThatCannotBeCostsOnlySpeed) {
    const auto file = dir_.write("file", "in the way");
    for (const auto& folder : {file, file / "below", std::filesystem::path("/proc/gloam-cache"),
                               std::filesystem::path("/dev/null")})
        for (int i = 0; i < 2; ++i) EXPECT_EQ(SpirvCache(folder).compile(doubling, {}), module_) << folder;
    EXPECT_EQ(base::read_file(file), "in the way");
}

TEST_F(CacheDamage, AReadOnlyFolderCostsOnlySpeed) {
    const auto folder = dir_.path() / "read-only";
    std::filesystem::create_directory(folder);
    std::filesystem::permissions(folder,
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    EXPECT_EQ(SpirvCache(folder).compile(doubling, {}), module_);
    std::filesystem::permissions(folder, std::filesystem::perms::owner_all);
}

TEST_F(CacheDamage, AnUnreadableEntryCostsOnlySpeed) {
    std::filesystem::permissions(module_entry_, std::filesystem::perms::none);
    EXPECT_EQ(cache_.compile(doubling, {}), module_);
}

// As on a full disk, no file may grow past a few bytes: nothing half-written stays.
TEST_F(CacheDamage, AFileThatCannotBeWrittenWholeIsNotKept) {
    const auto folder = dir_.path() / "full";
    const pid_t pid = fork();
    ASSERT_NE(pid, -1);
    if (pid == 0) {
        const rlimit limit{40, 40};
        signal(SIGXFSZ, SIG_IGN);
        const bool limited = setrlimit(RLIMIT_FSIZE, &limit) == 0;
        const bool right = SpirvCache(folder).compile(doubling, {}) == module_;
        _exit(limited && right ? 0 : 1);
    }
    int status = -1;
    ASSERT_EQ(waitpid(pid, &status, 0), pid);
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(std::filesystem::is_directory(folder));
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace gloam::shader::cache_test
