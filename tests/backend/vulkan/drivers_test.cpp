// SPDX-License-Identifier: MIT
#include "backend/vulkan/device.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "backend/vulkan/gpu_test.hpp"
#include "support/devices.hpp"

namespace gloam::gpu::test::drivers_test {

namespace fs = std::filesystem;

constexpr const char* good_manifest =
    R"({"file_format_version": "1.0.0", "ICD": {"library_path": "./driver.so"}})";

// A folder for driver files, and an environment that names none.
class DriversTest : public testing::Test {
  protected:
    void expect_refused(const fs::path& manifest, std::initializer_list<const char*> parts) const {
        expect_error<std::runtime_error>([&] { add_drivers(std::array{manifest}); }, parts);
        EXPECT_FALSE(drivers_are_chosen()) << "changed all the same";
    }

    const TemporaryDirectory folder;
    ScopedVariable no_instead{"VK_DRIVER_FILES", nullptr};
    ScopedVariable no_old_instead{"VK_ICD_FILENAMES", nullptr};
    ScopedVariable no_besides{"VK_ADD_DRIVER_FILES", nullptr};
};

TEST_F(DriversTest, SwiftShaderIsFoundInTheFirstFolderThatHasAllOfIt) {
    const std::array folders{folder.path() / "none", folder.path() / "manifest only",
                             folder.path() / "browser", folder.path() / "other"};
    folder.write("manifest only/vk_swiftshader_icd.json", good_manifest);
    EXPECT_EQ(find_swiftshader(folders), std::nullopt);
    for (const char* name : {"browser", "other"}) {
        folder.write(fs::path(name) / "vk_swiftshader_icd.json", good_manifest);
        folder.write(fs::path(name) / "libvk_swiftshader.so", "");
    }
    EXPECT_EQ(find_swiftshader(folders), folder.path() / "browser" / "vk_swiftshader_icd.json");
    EXPECT_EQ(find_swiftshader(std::span<const fs::path>()), std::nullopt);
}

TEST_F(DriversTest, DriversComeBesidesThoseOfTheSystem) {
    const fs::path first = folder.write("first.json", good_manifest);
    const fs::path second =
        folder.write("second.json", R"({"ICD": {"library_path": "libsystem_finds_it.so"}})");
    folder.write("driver.so", "");
    EXPECT_FALSE(drivers_are_chosen());
    add_drivers(std::array{first, second});
    EXPECT_TRUE(drivers_are_chosen());
    EXPECT_EQ(std::string(std::getenv("VK_ADD_DRIVER_FILES")), first.string() + ":" + second.string());
    EXPECT_EQ(std::getenv("VK_DRIVER_FILES"), nullptr);
    add_drivers(std::array{first});
    EXPECT_EQ(std::string(std::getenv("VK_ADD_DRIVER_FILES")),
              first.string() + ":" + second.string() + ":" + first.string());
}

TEST_F(DriversTest, DriversComeBesidesThoseThatTheEnvironmentNames) {
    const fs::path manifest = folder.write("manifest.json", good_manifest);
    folder.write("driver.so", "");
    for (const char* variable : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"}) {
        const ScopedVariable chosen(variable, "/the/only.json");
        EXPECT_TRUE(drivers_are_chosen());
        add_drivers(std::array{manifest});
        EXPECT_EQ(std::string(std::getenv(variable)), "/the/only.json:" + manifest.string());
        EXPECT_EQ(std::getenv("VK_ADD_DRIVER_FILES"), nullptr);
    }
}

TEST_F(DriversTest, AVariableThatIsSetToNothingIsAChoiceToo) {
    const fs::path manifest = folder.write("manifest.json", good_manifest);
    folder.write("driver.so", "");
    const ScopedVariable chosen("VK_DRIVER_FILES", "");
    EXPECT_TRUE(drivers_are_chosen());
    add_drivers(std::array{manifest});
    EXPECT_EQ(std::string(std::getenv("VK_DRIVER_FILES")), manifest.string());
}

TEST_F(DriversTest, ARelativePathIsMadeAbsolute) {
    const fs::path manifest = folder.write("manifest.json", good_manifest);
    folder.write("driver.so", "");
    add_drivers(std::array{fs::relative(manifest)});
    EXPECT_TRUE(fs::path(std::getenv("VK_ADD_DRIVER_FILES")).is_absolute());
    EXPECT_TRUE(fs::equivalent(std::getenv("VK_ADD_DRIVER_FILES"), manifest));
}

TEST_F(DriversTest, NoneChangesNothing) {
    add_drivers({});
    EXPECT_FALSE(drivers_are_chosen());
}

TEST_F(DriversTest, WhatIsNoDriverIsNamed) {
    expect_refused(folder.path() / "nowhere.json", {"nowhere.json", "no such file"});
    expect_refused(folder.path(), {folder.path().c_str(), "no such file"});
    for (const char* text : {"", "no JSON", "[]", "{}", R"({"ICD": 3})", R"({"ICD": {"library_path": 7}})"})
        expect_refused(folder.write("bad.json", text), {"bad.json", "not a driver manifest", "library_path"});
    expect_refused(folder.write("lonely.json", good_manifest), {"lonely.json", "driver.so", "missing"});
    expect_refused(folder.write("a:b.json", good_manifest), {"a:b.json", "colon"});
}

TEST(Devices, SoftwareComesLastAndTheDefaultStays) {
    const std::string before = Device().info().name;
    const auto devices = gloam::test::devices_at_hand();
    const auto is_swiftshader = [](const DeviceInfo& d) {
        return d.name.find("SwiftShader") != std::string::npos;
    };
    const auto found = std::ranges::find_if(devices, is_swiftshader);
    if (found == devices.end()) GTEST_SKIP() << "no SwiftShader here (Debian's package chromium has it)";
    EXPECT_EQ(found, devices.end() - 1);
    EXPECT_EQ(found->driver.find_last_of("0123456789"), found->driver.size() - 1) << found->driver;
    EXPECT_EQ(Device().info().name, before);
    EXPECT_EQ(is_swiftshader(Device().info()), devices.size() == 1);
    EXPECT_EQ(Device({.device = "swiftshader"}).info().identity, found->identity);
}

}  // namespace gloam::gpu::test::drivers_test
