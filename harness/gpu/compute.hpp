// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "gpu/buffer.hpp"
#include "gpu/image.hpp"

namespace gloam::gpu {

// sampled_image: read by texelFetch; it has a sampler, which no fetch uses.
enum class BindingKind { storage_buffer, storage_image, sampled_image };

struct SpecializationConstant {
    std::uint32_t id = 0;
    std::uint32_t bits = 0;  // the 32-bit pattern of the bool, int, uint or float
};

// The parts of a compute pipeline. Entry point "main"; binding i of descriptor set 0 has kind bindings[i].
struct ComputeProgram {
    std::span<const std::uint32_t> spirv;
    std::vector<BindingKind> bindings;
    std::uint32_t push_constant_bytes = 0;
    std::vector<SpecializationConstant> constants;
};

// A compiled compute pipeline. Throws std::runtime_error when the driver rejects it; std::invalid_argument
// when the words are not a SPIR-V module, or when the bindings or push constants (a multiple of 4 bytes)
// exceed the device's limits. The module must match the bindings; only the validation layer checks this.
class ComputePipeline {
  public:
    ComputePipeline(const Device& device, const ComputeProgram& program);
    ~ComputePipeline();
    ComputePipeline(ComputePipeline&&) noexcept;
    ComputePipeline& operator=(ComputePipeline&&) noexcept;

    struct Impl;
    [[nodiscard]] Impl& impl() const { return *impl_; }

  private:
    std::unique_ptr<Impl> impl_;
};

// The resource of a binding: a whole storage buffer, or an image. Shaders may write to buffers and storage
// images.
using Resource = std::variant<std::reference_wrapper<const Buffer>, std::reference_wrapper<const Image>>;

}  // namespace gloam::gpu
