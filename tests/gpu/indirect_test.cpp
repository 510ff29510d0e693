// SPDX-License-Identifier: MIT
// Dispatches whose size a shader decides.
#include <algorithm>
#include <numeric>

#include "gpu/gpu_test.hpp"
#include "shaders/count_comp.h"
#include "shaders/fill_comp.h"

namespace gloam::gpu::test {
namespace indirect_test {

class IndirectTest : public GpuTest {
  protected:
    ComputePipeline fill() {
        return {device(),
                {.spirv = fill_comp, .bindings = {BindingKind::storage_buffer}, .push_constant_bytes = 8}};
    }
    static constexpr std::array constants{1.0F, 0.0F};
};

// The counts are written in the same submission: fill.comp writes 64 values a group.
TEST_F(IndirectTest, RunsAsManyGroupsAsTheShaderBeforeAsked) {
    const auto pipeline = fill();
    const ComputePipeline count(device(),
                                {.spirv = count_comp,
                                 .bindings = {BindingKind::storage_buffer, BindingKind::storage_buffer},
                                 .push_constant_bytes = 4});
    Buffer values(device(), 5 * sizeof(float));
    std::iota(values.as<float>().begin(), values.as<float>().end(), 0.0F);
    for (const std::ptrdiff_t wanted : {0, 1, 3, 5}) {
        Buffer groups(device(), 16);
        Buffer filled(device(), 320 * sizeof(float));
        std::ranges::fill(filled.as<float>(), 0.0F);
        Commands commands(device());
        commands.dispatch(count, std::vector<Resource>{values, groups}, {1, 1, 1},
                          bytes_of(4.5F - static_cast<float>(wanted)));
        commands.dispatch_indirect(pipeline, std::vector<Resource>{filled}, groups, 4, bytes_of(constants));
        commands.submit();
        EXPECT_EQ(std::ranges::count(filled.as<float>(), 1.0F), 64 * wanted);
    }
}

TEST_F(IndirectTest, RefusesWhatDoesNotFit) {
    const auto pipeline = fill();
    Buffer groups(device(), 16);
    Buffer filled(device(), 64);
    const std::vector<Resource> resources{filled};
    Commands commands(device());
    for (const std::size_t offset : {2U, 8U, 16U, 1000U}) {
        expect_error<std::invalid_argument>(
            [&] { commands.dispatch_indirect(pipeline, resources, groups, offset, bytes_of(constants)); },
            {"group counts", "buffer of 16", "12 bytes"});
    }
    expect_error<std::invalid_argument>(
        [&] { commands.dispatch_indirect(pipeline, {}, groups, 0, bytes_of(constants)); }, {"0 resources"});
    expect_error<std::invalid_argument>([&] { commands.dispatch_indirect(pipeline, resources, groups, 0); },
                                        {"push constants"});
    commands.submit();  // the refused commands have left no trace
    expect_error<std::runtime_error>(
        [&] { commands.dispatch_indirect(pipeline, resources, groups, 0, bytes_of(constants)); },
        {"submitted"});
}

TEST_F(IndirectTest, RefusesTheBufferOfAnotherDevice) {
    const auto pipeline = fill();
    Buffer filled(device(), 64);
    const Device other({.device = device_name()});
    Buffer groups(other, 16);
    Commands commands(device());
    expect_error<std::invalid_argument>(
        [&] {
            commands.dispatch_indirect(pipeline, std::vector<Resource>{filled}, groups, 0,
                                       bytes_of(constants));
        },
        {"group counts", "another device"});
}

}  // namespace indirect_test
}  // namespace gloam::gpu::test
