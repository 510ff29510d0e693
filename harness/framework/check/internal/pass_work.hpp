// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "backend/backend.hpp"
#include "backend/vulkan/device.hpp"
#include "backend/vulkan/resources.hpp"
#include "check/internal/pass_interface.hpp"
#include "check/pass.hpp"

// One run of a pass: what is bound, in the host's memory. A run changes it as the pass does.
namespace gloam::check::internal {

// A storage image or colour output.
struct BoundImage {
    gpu::Format format = gpu::Format::rgba32f;
    glm::ivec2 size{1};
    std::vector<Word> texels;  // bits of the floats or integers that the shader sees, channel by channel
    bool integers = false;
    bool written = false;  // the shader may write to it
    bool fresh = false;    // not given
};

struct BoundSampler {
    std::vector<Word> words;  // backend/sampled.hpp
    bool stateless = false;   // no state is given: the nearest texel, of 32 bits
};

struct BoundBuffer {
    std::vector<Word> words;
    std::vector<bool> fresh;  // by word: not given
    bool uniform = false;
};

using Bound = std::variant<std::monostate, BoundImage, BoundSampler, BoundBuffer>;

struct PassWork {
    std::vector<Bound> bindings;  // by number
    std::vector<BoundImage> colors;
    std::vector<std::byte> push_constants;
    std::vector<backend::Constant> constants;
    std::array<std::uint32_t, 3> groups{};
    std::array<std::uint32_t, 3> group_size{};
    std::vector<float> vertices;
    std::vector<int> attribute_sizes;
    std::uint32_t vertex_count = 0;
    float background = 0.0F;
};

// A run of a pass with these inputs, ready but for the contents of what is not given. Throws
// std::invalid_argument like Pass::run().
[[nodiscard]] PassWork bound(const PassInterface& pass, const PassInputs& inputs, const PassOptions& options);

// Runs a pass on a device. Throws like gpu::Commands and the pipelines.
void run_on_device(const gpu::Device& device, const PassModules& modules, PassWork& work);

// Runs a compute pass on the interpreter, one invocation after another. Throws backend::Unsupported for other
// passes, barriers, and instructions that it does not know; backend::Fault, with the place, for an access
// outside an image or array.
void run_interpreted(const PassModules& modules, PassWork& work);

}  // namespace gloam::check::internal
