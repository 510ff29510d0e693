// SPDX-License-Identifier: MIT
// What does not fit a pipeline or a device is refused before Vulkan hears of it.
#include <numeric>

#include "gpu/gpu_test.hpp"
#include "shaders/fill_comp.h"
#include "shaders/image_comp.h"

namespace gloam::gpu::test {
namespace mismatch_test {

class MismatchTest : public GpuTest {
  protected:
    ComputePipeline fill() {
        return {device(),
                {.spirv = fill_comp, .bindings = {BindingKind::storage_buffer}, .push_constant_bytes = 8}};
    }
    ComputePipeline image_pipeline() {
        return {device(),
                {.spirv = image_comp,
                 .bindings = {BindingKind::storage_image, BindingKind::storage_image,
                              BindingKind::storage_buffer}}};
    }
    static constexpr std::array constants{0.0f, 0.0f};
};

void expect_refused(Commands& commands, const ComputePipeline& pipeline,
                    const std::vector<Resource>& resources, std::array<std::uint32_t, 3> groups,
                    std::span<const std::byte> push_constants, std::initializer_list<const char*> parts) {
    expect_error<std::invalid_argument>(
        [&] { commands.dispatch(pipeline, resources, groups, push_constants); }, parts);
}

TEST_F(MismatchTest, NumberOfResources) {
    const auto pipeline = fill();
    Buffer buffer(device(), 64);
    Commands commands(device());
    expect_refused(commands, pipeline, {}, {1, 1, 1}, bytes_of(constants), {"0 resources", "1 bindings"});
    expect_refused(commands, pipeline, {buffer, buffer}, {1, 1, 1}, bytes_of(constants),
                   {"2 resources", "1 bindings"});
    commands.submit();  // the refused commands have left no trace
}

TEST_F(MismatchTest, KindOfResource) {
    const auto pipeline = image_pipeline();
    Buffer buffer(device(), 64);
    Image image(device(), {2, 2}, Format::r32f);
    Commands commands(device());
    expect_refused(commands, pipeline, {buffer, image, buffer}, {1, 1, 1}, {},
                   {"resource 0", "storage buffer", "storage image"});
    expect_refused(commands, pipeline, {image, image, image}, {1, 1, 1}, {},
                   {"resource 2", "an image", "storage buffer"});
}

TEST_F(MismatchTest, DepthImagesAreNoStorageImages) {
    const auto pipeline = image_pipeline();
    Buffer buffer(device(), 64);
    Image image(device(), {2, 2}, Format::r32f);
    Image depth(device(), {2, 2}, Format::depth32f);
    Commands commands(device());
    expect_refused(commands, pipeline, {image, depth, buffer}, {1, 1, 1}, {}, {"resource 1", "depth32f"});
}

TEST_F(MismatchTest, PushConstants) {
    const auto pipeline = fill();
    Buffer buffer(device(), 64);
    Commands commands(device());
    expect_refused(commands, pipeline, {buffer}, {1, 1, 1}, {}, {"0 bytes", "8"});
    expect_refused(commands, pipeline, {buffer}, {1, 1, 1}, bytes_of(1.0f), {"4 bytes", "8"});
}

TEST_F(MismatchTest, GroupCounts) {
    const auto pipeline = fill();
    Buffer buffer(device(), 64);
    Commands commands(device());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto limit = device().info().max_group_count[axis];
        if (limit == 0xffffffffu) continue;
        std::array<std::uint32_t, 3> groups{1, 1, 1};
        groups[axis] = limit + 1;
        const std::string in = std::string("in ") + "xyz"[axis];
        expect_refused(commands, pipeline, {buffer}, groups, bytes_of(constants),
                       {in.c_str(), std::to_string(limit).c_str(), std::to_string(limit + 1).c_str()});
    }
}

TEST_F(MismatchTest, ObjectsOfAnotherDevice) {
    const Device other({.device = device_name()});
    const auto pipeline = fill();
    Buffer buffer(device(), 64);
    Buffer foreign(other, 64);
    Commands commands(device());
    expect_refused(commands, pipeline, {foreign}, {1, 1, 1}, bytes_of(constants),
                   {"a buffer", "another device"});
    Commands foreign_commands(other);
    expect_refused(foreign_commands, pipeline, {buffer}, {1, 1, 1}, bytes_of(constants),
                   {"the pipeline", "another device"});
}

TEST_F(MismatchTest, PipelinesThatCannotBe) {
    const auto make = [&](ComputeProgram program) { ComputePipeline(device(), program); };
    const std::vector<std::uint32_t> garbage{0x12345678u, 0u, 0u, 0u, 0u, 0u};
    expect_error<std::invalid_argument>([&] { make({.spirv = {}}); }, {"not a SPIR-V module", "0 words"});
    expect_error<std::invalid_argument>([&] { make({.spirv = garbage}); },
                                        {"not a SPIR-V module", "0x12345678"});
    expect_error<std::invalid_argument>([&] { make({.spirv = fill_comp, .push_constant_bytes = 6}); },
                                        {"6 bytes"});
    expect_error<std::invalid_argument>([&] { make({.spirv = fill_comp, .push_constant_bytes = 1u << 20}); },
                                        {"1048576 bytes"});
    const std::vector<BindingKind> many(2'000'000, BindingKind::storage_buffer);
    expect_error<std::invalid_argument>([&] { make({.spirv = fill_comp, .bindings = many}); },
                                        {"2000000 storage buffer bindings"});
}

}  // namespace mismatch_test
}  // namespace gloam::gpu::test
