// SPDX-License-Identifier: MIT
#include "backend/vulkan/device.hpp"
#include "backend/vulkan/gpu_test.hpp"
#include "backend/vulkan/internal/instance.hpp"

namespace gloam::backend::vulkan::test::device_test {

using ValidationTest = GpuTest;

TEST(Devices, ATimeoutMustBePositive) {
    expect_error<std::invalid_argument>([] { Device({.timeout = std::chrono::milliseconds(0)}); }, {"0 ms"});
    expect_error<std::invalid_argument>([] { Device({.timeout = std::chrono::milliseconds(-3)}); },
                                        {"-3 ms"});
}

std::vector<DeviceInfo> machine(std::initializer_list<std::pair<const char*, const char*>> devices) {
    std::vector<DeviceInfo> infos;
    for (const auto& [name, type] : devices)
        infos.push_back({.index = infos.size(), .name = name, .type = type});
    return infos;
}

TEST(Select, ByKindByIndexOrByAPartOfTheName) {
    const auto cards = machine({{"card 1", "discrete"}, {"card 2", "discrete"}});
    const auto mixed = machine({{"Radeon", "discrete"}, {"llvmpipe (LLVM 15)", "cpu"}, {"LLVM too", "cpu"}});
    const auto soft = machine({{"odd", "other"}, {"soft", "cpu"}, {"softer", "cpu"}});
    const std::tuple<std::vector<DeviceInfo>, const char*, std::size_t> rows[] = {
        {machine({{"soft", "cpu"}, {"small", "integrated"}, {"big", "discrete"}}), "", 1},  // the first GPU
        {machine({{"big", "discrete"}, {"small", "integrated"}}), "", 0},
        {machine({{"soft", "cpu"}, {"guest", "virtual"}}), "", 1},
        {soft, "", 1},  // without one the first CPU device
        {machine({{"odd", "other"}}), "", 0},
        {cards, "0", 0},
        {cards, "1", 1},
        {cards, "0001", 1},
        {mixed, "LLVM", 1},
        {mixed, "too", 2},
        {mixed, "rADEON", 0},
        {mixed, "(llvm 15)", 1}};
    for (const auto& [devices, selector, index] : rows)
        EXPECT_EQ(select_device(devices, selector), index) << selector;
}

TEST(Select, AnUnknownDeviceListsThoseThereAre) {
    const auto devices = machine({{"Radeon", "discrete"}, {"llvmpipe", "cpu"}});
    for (const char* selector : {"2", "99999999999999999999999", "geforce", " 1"}) {
        expect_error<std::runtime_error>([&] { static_cast<void>(select_device(devices, selector)); },
                                         {selector, "0 \"Radeon\" (discrete)", "1 \"llvmpipe\" (cpu)"});
    }
}

// That messages arrive at all: without this, no other test's silence would mean anything.

TEST_F(ValidationTest, SeesAShaderThatDisagreesWithItsBindings) {
    const ComputePipeline wrong = pipeline_of(device(), fill_shader, 8, {BindingKind::storage_image});
    const auto messages = device().take_validation_messages();
    EXPECT_THAT(messages, Contains(HasSubstr("VUID-VkComputePipelineCreateInfo-layout")));
    EXPECT_THAT(messages, Each(Not(HasSubstr("\n"))));
    EXPECT_TRUE(device().take_validation_messages().empty()) << "taken twice";
    EXPECT_EQ(take_messages(), messages) << "the listener hears the same";
}

namespace fs = std::filesystem;

constexpr const char* good_manifest =
    R"({"file_format_version": "1.0.0", "ICD": {"library_path": "./driver.so"}})";

// A folder for driver files, and an environment that names none.
class DriversTest : public testing::Test {
  protected:
    void expect_refused(const fs::path& manifest, std::initializer_list<std::string> parts) const {
        expect_error<std::runtime_error>([&] { choose_drivers(std::array{manifest}); }, parts);
        EXPECT_THAT(chosen_drivers(), IsEmpty()) << "changed all the same";
    }

    const TemporaryDirectory folder;
    ScopedVariable no_instead{"VK_DRIVER_FILES", nullptr};
    ScopedVariable no_old_instead{"VK_ICD_FILENAMES", nullptr};
    ScopedVariable no_besides{"VK_ADD_DRIVER_FILES", nullptr};
};

TEST_F(DriversTest, SwiftShaderIsFoundInTheFirstFolderThatHasAllOfIt) {
    const std::vector folders{folder.path() / "none", folder.path() / "manifest only",
                              folder.path() / "browser", folder.path() / "other"};
    folder.write("manifest only/vk_swiftshader_icd.json", good_manifest);
    EXPECT_EQ(find_swiftshader(folders), std::nullopt);
    for (const char* name : {"browser", "other"}) {
        folder.write(fs::path(name) / "vk_swiftshader_icd.json", good_manifest);
        folder.write(fs::path(name) / "libvk_swiftshader.so", "");
    }
    EXPECT_EQ(find_swiftshader(folders), folder.path() / "browser" / "vk_swiftshader_icd.json");
    EXPECT_EQ(find_swiftshader(std::vector<fs::path>()), std::nullopt);
}

// A relative path is made absolute, and what was chosen before is replaced.
TEST_F(DriversTest, DriversComeInsteadOfAllOthers) {
    const fs::path first = folder.write("first.json", good_manifest);
    const fs::path second =
        folder.write("second.json", R"({"ICD": {"library_path": "libsystem_finds_it.so"}})");
    folder.write("driver.so", "");
    EXPECT_THAT(chosen_drivers(), IsEmpty());
    for (const char* before : {"", "/the/only.json"}) {
        const ScopedVariable chosen("VK_DRIVER_FILES", before);
        add_swiftshader();
        EXPECT_EQ(std::getenv("VK_ADD_DRIVER_FILES"), nullptr);
        choose_drivers(std::array{first, fs::relative(second)});
        const std::string both = first.string() + ":" + fs::absolute(fs::relative(second)).string();
        EXPECT_THAT(chosen_drivers(),
                    ElementsAre(std::pair<std::string, std::string>("VK_DRIVER_FILES", both)));
    }
}

TEST_F(DriversTest, WhatIsNoDriverIsNamed) {
    expect_refused(folder.path() / "nowhere.json", {"nowhere.json", "no such file"});
    expect_refused(folder.path(), {folder.path().c_str(), "a folder"});
    for (const char* text : {"", "no JSON", "[]", "{}", R"({"ICD": 3})", R"({"ICD": {"library_path": 7}})"})
        expect_refused(folder.write("bad.json", text), {"bad.json", "not a driver manifest", "library_path"});
    expect_refused(folder.write("lonely.json", good_manifest), {"lonely.json", "driver.so", "missing"});
    expect_refused(folder.write("a:b.json", good_manifest), {"a:b.json", "colon"});
}

}  // namespace gloam::backend::vulkan::test::device_test
