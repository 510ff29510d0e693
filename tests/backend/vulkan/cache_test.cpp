// SPDX-License-Identifier: MIT
// The pipeline cache on disk: the file format by itself, then a device that finds the file in every state.
#include <sys/stat.h>
#include <unistd.h>

#include "backend/shader_cache.hpp"
#include "backend/vulkan/gpu_test.hpp"
#include "backend/vulkan/internal/pipeline_cache.hpp"
#include "base/cached_file.hpp"
#include "shaders/fill_comp.h"
#include "support/full_disk.hpp"

namespace gloam::gpu::test::cache_test {

namespace fs = std::filesystem;

void write_all(const fs::path& file, const std::string& content) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
}

std::string some_bytes(std::size_t count) {
    std::string bytes(count, '\0');
    for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<char>(i * 7);
    return bytes;
}

constexpr base::Hash key{1, 2};
constexpr base::Hash
    pipelines{};  // the key of every file of pipelines, which the driver's header tells apart

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

using CacheFile = InFolder;

TEST_F(CacheFile, ComesBackAsItWas) {
    const auto file = folder.path() / "made" / "on the way" / "cache";
    for (const std::size_t size : {0u, 1u, 1000u}) {
        ASSERT_TRUE(base::write_cached(file, key, some_bytes(size)));
        EXPECT_EQ(base::read_cached(file, key), some_bytes(size));
    }
    EXPECT_EQ(files_in(file.parent_path()).size(), 1u) << "a temporary file was left behind";
}

TEST_F(CacheFile, MissingAndOfAnotherKeyIsEmpty) {
    EXPECT_FALSE(base::read_cached("/nonexistent/cache", key));
    const auto file = folder.path() / "cache";
    ASSERT_TRUE(base::write_cached(file, key, some_bytes(40)));
    EXPECT_FALSE(base::read_cached(file, {1, 3}));
}

TEST_F(CacheFile, AnyFlippedBitAndAnyOtherLengthShow) {
    const auto file = folder.path() / "cache";
    ASSERT_TRUE(base::write_cached(file, key, some_bytes(40)));
    const auto good = read_file(file);
    for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
        auto bad = good;
        bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ (1 << bit % 8));
        write_all(file, bad);
        ASSERT_FALSE(base::read_cached(file, key)) << "bit " << bit;
    }
    for (std::size_t length = 0; length <= good.size() + 1; ++length) {
        write_all(file, (good + '\0').substr(0, length));
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

// Vulkan's header: its length, version 1, vendor, device, UUID; then what is the driver's own. A driver never
// gets another's, or one that is cut.
TEST(CacheHeader, IsWholeAndOfTheDriver) {
    const DriverKey driver{.vendor = 0x10005, .device = 7, .uuid = {1, 2, 3, 4, 5, 6, 7, 8}};
    const std::array<std::uint32_t, 4> start{32, 1, driver.vendor, driver.device};
    std::vector<std::byte> blob(32 + 100);
    std::memcpy(blob.data(), start.data(), 16);
    std::memcpy(blob.data() + 16, driver.uuid.data(), 16);
    for (std::size_t length = 0; length <= blob.size(); ++length)
        EXPECT_EQ(is_pipeline_cache_of(std::span(blob).first(length), driver), length >= 32) << length;
    for (std::size_t i = 0; i < 32; ++i) {
        auto other = blob;
        other[i] ^= std::byte{0x80};
        EXPECT_FALSE(is_pipeline_cache_of(other, driver)) << "byte " << i;
    }
}

class PipelineCacheTest : public GpuTest {
  protected:
    // Opens the device with the folder, computes something, and closes it.
    void use(const fs::path& folder) {
        open({.cache_directory = folder});
        identity_ = device().info().identity;
        {
            const ComputePipeline fill(
                device(),
                {.spirv = fill_comp, .bindings = {BindingKind::storage_buffer}, .push_constant_bytes = 8});
            Buffer buffer(device(), 12);
            run(device(), fill, {buffer}, {1, 1, 1}, bytes_of(std::array{4.0f, 2.0f}));
            EXPECT_EQ(buffer.as<float>()[2], 8.0f);
        }
        close();
    }

    fs::path file(const fs::path& folder) const { return folder / ("pipelines-" + identity_ + ".bin"); }

    // Spoils a good file, and expects the next use to put it right.
    void expect_repaired(const std::function<void(const fs::path&)>& spoil) {
        const TemporaryDirectory folder;
        use(folder.path());
        const auto good = base::read_cached(file(folder.path()), pipelines);
        ASSERT_TRUE(good);
        spoil(file(folder.path()));
        ASSERT_NE(base::read_cached(file(folder.path()), pipelines), good);
        use(folder.path());
        EXPECT_EQ(base::read_cached(file(folder.path()), pipelines), good);
        EXPECT_EQ(files_in(folder.path()).size(), 1u);
    }

  private:
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

TEST_F(PipelineCacheTest, IsRebuiltWhenCutShort) {
    expect_repaired([](const fs::path& cache) { fs::resize_file(cache, fs::file_size(cache) / 2); });
}

// Whole and consistent by our own header, yet of another driver by Vulkan's (its UUID is at byte 16).
TEST_F(PipelineCacheTest, IsRebuiltWhenItIsOfAnotherDriver) {
    expect_repaired([](const fs::path& cache) {
        std::string content = base::read_cached(cache, pipelines).value();
        content.at(16) = static_cast<char>(content.at(16) ^ 0xff);
        ASSERT_TRUE(base::write_cached(cache, pipelines, content));
    });
    expect_repaired(
        [](const fs::path& cache) { ASSERT_TRUE(base::write_cached(cache, pipelines, some_bytes(10))); });
}

TEST_F(PipelineCacheTest, CannotBeWrittenIsNoError) {
    const TemporaryDirectory folder;
    folder.write("file", "");
    use(folder.path() / "file" / "below");
    EXPECT_EQ(files_in(folder.path()).size(), 1u);
}

}  // namespace gloam::gpu::test::cache_test
