// SPDX-License-Identifier: MIT
// The pipeline cache on disk: the file format by itself, then a device that finds the file in every state.
#include <sys/stat.h>
#include <unistd.h>

#include "backend/shader_cache.hpp"
#include "backend/vulkan/gpu_test.hpp"
#include "base/cached_file.hpp"
#include "support/full_disk.hpp"

namespace gloam::backend::vulkan::test::cache_test {

namespace fs = std::filesystem;

std::string some_bytes(std::size_t count) {
    std::string bytes(count, '\0');
    for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<char>(i * 7);
    return bytes;
}

constexpr base::Hash key{1, 2};

std::vector<fs::path> files_in(const fs::path& folder) {
    return {fs::directory_iterator(folder), fs::directory_iterator()};
}

// A file system of the kernel has no space: as a disk that is full.
TEST(DriversCache, IsLeftOutWhereTheDiskIsFull) {
    const auto is_left_out = [](const fs::path& cache) {
        ::unsetenv("MESA_SHADER_CACHE_DISABLE");
        ::setenv("MESA_SHADER_CACHE_DIR", cache.c_str(), 1);
        backend::spare_a_full_disk();
        ::unsetenv("MESA_SHADER_CACHE_DIR");
        return std::getenv("MESA_SHADER_CACHE_DISABLE") != nullptr;
    };
    EXPECT_TRUE(is_left_out("/proc"));
    EXPECT_TRUE(is_left_out("/proc/not/there"));
    EXPECT_FALSE(is_left_out(fs::temp_directory_path()));
}

// A device that is destroyed writes its pipelines. The child of the test has its parent's environment.
TEST(StaticDevice, IsNotDestroyedAtTheEndOfTheProcess) {
    const char* const variable = "GLOAM_STATIC_DEVICE_CACHE";
    const fs::path folder = fs::temp_directory_path() / ("gloam-static-" + std::to_string(::getpid()));
    ::setenv(variable, folder.c_str(), 0);
    ::setenv("LSAN_OPTIONS", "detect_leaks=0", 1);  // of the child: it leaves the device
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto use = [&](Validation validation) {
        static const Device device({.validation = validation, .cache_directory = std::getenv(variable)});
        std::exit(0);
    };
    EXPECT_EXIT(use(Validation::on), testing::ExitedWithCode(0), "");
    EXPECT_FALSE(fs::exists(folder));
    EXPECT_EXIT(use(Validation::off), testing::ExitedWithCode(0), "");
    EXPECT_TRUE(fs::exists(folder)) << "without the layers it can be";
    fs::remove_all(folder);
}

using CacheFile = InFolder;

// With the same key.
TEST_F(CacheFile, ComesBackAsItWas) {
    EXPECT_FALSE(base::read_cached("/nonexistent/cache", key));
    const auto file = folder.path() / "made" / "on the way" / "cache";
    for (const std::size_t size : {0u, 1u, 1000u}) {
        ASSERT_TRUE(base::write_cached(file, key, some_bytes(size)));
        EXPECT_EQ(base::read_cached(file, key), some_bytes(size));
        EXPECT_FALSE(base::read_cached(file, {1, 3}));
    }
    EXPECT_EQ(files_in(file.parent_path()).size(), 1u) << "a temporary file was left behind";
}

TEST_F(CacheFile, AnyFlippedBitAndAnyOtherLengthShow) {
    const auto file = folder.path() / "cache";
    ASSERT_TRUE(base::write_cached(file, key, some_bytes(40)));
    const auto good = read_file(file);
    for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
        auto bad = good;
        bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ (1 << bit % 8));
        folder.write("cache", bad);
        ASSERT_FALSE(base::read_cached(file, key)) << "bit " << bit;
    }
    for (std::size_t length = 0; length <= good.size() + 1; ++length) {
        folder.write("cache", (good + '\0').substr(0, length));
        ASSERT_EQ(base::read_cached(file, key).has_value(), length == good.size()) << length << " bytes";
    }
}

TEST_F(CacheFile, WhatIsInPlaceIsReplaced) {
    const auto file = folder.path() / "cache";
    const std::array<std::function<void()>, 3> in_place{
        [&] { fs::create_directory(file); }, [&] { fs::create_symlink(folder.path() / "nowhere", file); },
        [&] { ASSERT_EQ(mkfifo(file.c_str(), 0600), 0); }};  // opening a pipe would wait for ever
    for (const auto& make : in_place) {
        make();
        EXPECT_FALSE(base::read_cached(file, key));
        EXPECT_TRUE(base::write_cached(file, key, some_bytes(4)));
        EXPECT_EQ(base::read_cached(file, key), some_bytes(4));
        fs::remove(file);
    }
}

TEST_F(CacheFile, WhatCannotBeReadOrWrittenIsNoError) {
    folder.write("file", "");
    folder.write("taken/x", "");
    for (const char* name : {"file/cache", "taken"})
        EXPECT_FALSE(base::write_cached(folder.path() / name, key, some_bytes(4)));
    {
        const gloam::test::FullDisk disk(40);
        EXPECT_FALSE(base::write_cached(folder.path() / "full", key, some_bytes(400)));
    }
    EXPECT_EQ(files_in(folder.path()).size(), 2u) << "a temporary file was left behind";
    if (geteuid() == 0) return;  // root reads and writes everything
    const auto file = folder.path() / "cache";
    ASSERT_TRUE(base::write_cached(file, key, some_bytes(4)));
    fs::permissions(file, fs::perms::none);
    EXPECT_FALSE(base::read_cached(file, key));
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_FALSE(base::write_cached(file, key, some_bytes(4)));
    fs::permissions(folder.path(), fs::perms::owner_all);
}

class PipelineCacheTest : public GpuTest {
  protected:
    // Opens the device with the folder, computes something, and closes it.
    void use(const fs::path& folder) {
        open({.cache_directory = folder});
        identity_ = device().info().identity;
        {
            const ComputePipeline fill = pipeline_of(device(), fill_shader, 8);
            Buffer buffer(device(), 12);
            run(device(), fill, {buffer}, {1, 1, 1}, bytes_of(std::array{4.0f, 2.0f}));
            EXPECT_EQ(buffer.as<float>()[2], 8.0f);
        }
        close();
    }

    fs::path file(const fs::path& folder) const { return folder / ("pipelines-" + identity_ + ".bin"); }

    // What the folder holds for the device.
    std::optional<std::string> kept(const fs::path& folder) const {
        return base::read_cached(file(folder), base::hash_of(identity_));
    }

    std::string identity_;
};

TEST_F(PipelineCacheTest, IsNotWrittenAgainWithoutNeed) {
    const TemporaryDirectory folder;
    use(folder.path());
    const auto written = fs::last_write_time(file(folder.path()));
    const auto long_ago = written - std::chrono::hours(1);
    fs::last_write_time(file(folder.path()), long_ago);
    use(folder.path());
    EXPECT_EQ(fs::last_write_time(file(folder.path())), long_ago);
}

// Cut short, or of another driver.
TEST_F(PipelineCacheTest, IsRebuiltWhenItIsNone) {
    const std::array<std::function<void(const fs::path&)>, 2> spoils{
        [](const fs::path& cache) { fs::resize_file(cache, fs::file_size(cache) / 2); },
        [](const fs::path& cache) { ASSERT_TRUE(base::write_cached(cache, key, some_bytes(10))); }};
    for (const auto& spoil : spoils) {
        const TemporaryDirectory folder;
        use(folder.path());
        const auto good = kept(folder.path());
        ASSERT_TRUE(good);
        spoil(file(folder.path()));
        ASSERT_EQ(kept(folder.path()), std::nullopt);
        use(folder.path());
        EXPECT_EQ(kept(folder.path()), good);
        EXPECT_EQ(files_in(folder.path()).size(), 1u);
    }
}

TEST_F(PipelineCacheTest, CannotBeWrittenIsNoError) {
    const TemporaryDirectory folder;
    folder.write("file", "");
    use(folder.path() / "file" / "below");
    EXPECT_EQ(files_in(folder.path()).size(), 1u);
}

}  // namespace gloam::backend::vulkan::test::cache_test
