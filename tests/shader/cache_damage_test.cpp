// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>

#include "base/read_file.hpp"
#include "shader/cache.hpp"
#include "shader/include.hpp"
#include "support.hpp"

namespace gloam::shader {
namespace cache_damage_test {

using test::kernel;
using test::TempDir;

const Source source = kernel("float f(float x) { return x * 2.0; }", "f(3.0)");

// A cache with one entry of a module and one of functions; `damage` gets the file of an entry and its bytes.
class CacheDamage : public testing::Test {
  protected:
    CacheDamage() {
        static_cast<void>(cache_.compile(source, {}));
        module_entry_ = only_file("spv");
        static_cast<void>(cache_.functions(source, {}));
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
        EXPECT_EQ(cache_.compile(source, {}), module_) << what;
        EXPECT_EQ(base::read_file(module_entry_), module_bytes_) << what;
        const auto functions = cache_.functions(source, {});
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

    TempDir dir_;
    SpirvCache cache_{dir_.path()};
    Spirv module_ = compile(source, {});
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

    TempDir other;
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
    for (int i = 0; i < 2; ++i) EXPECT_EQ(cache_.compile(source, {}), module_);
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
        for (int i = 0; i < 2; ++i) EXPECT_EQ(SpirvCache(folder).compile(source, {}), module_) << folder;
    EXPECT_EQ(base::read_file(file), "in the way");
}

TEST_F(CacheDamage, AReadOnlyFolderCostsOnlySpeed) {
    const auto folder = dir_.path() / "read-only";
    std::filesystem::create_directory(folder);
    std::filesystem::permissions(folder,
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    EXPECT_EQ(SpirvCache(folder).compile(source, {}), module_);
    std::filesystem::permissions(folder, std::filesystem::perms::owner_all);
}

TEST_F(CacheDamage, AnUnreadableEntryCostsOnlySpeed) {
    std::filesystem::permissions(module_entry_, std::filesystem::perms::none);
    EXPECT_EQ(cache_.compile(source, {}), module_);
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
        const bool right = SpirvCache(folder).compile(source, {}) == module_;
        _exit(limited && right ? 0 : 1);
    }
    int status = -1;
    ASSERT_EQ(waitpid(pid, &status, 0), pid);
    EXPECT_EQ(status, 0);
    EXPECT_TRUE(std::filesystem::is_directory(folder));
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

}  // namespace cache_damage_test
}  // namespace gloam::shader
