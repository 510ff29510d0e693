// SPDX-License-Identifier: MIT
#pragma once

#include "gpu/commands.hpp"
#include "gpu/internal/descriptors.hpp"
#include "gpu/internal/guarded.hpp"
#include "gpu/internal/timestamps.hpp"

namespace gloam::gpu {

// The objects that must outlive the execution of a recording.
struct Recording {
    vk::raii::CommandBuffers buffers;
    DescriptorAllocator descriptors;
    Timestamps timestamps;
    std::vector<vk::raii::Framebuffer> framebuffers;
};

struct Commands::Impl {
    explicit Impl(Context& owner);

    // The command buffer. Throws std::runtime_error after submit().
    [[nodiscard]] const vk::raii::CommandBuffer& recording() const;

    // Throws like dispatch() if the arguments do not match the pipeline.
    void check(const ComputePipeline& pipeline, std::span<const Resource> resources,
               std::span<const std::byte> push_constants) const;
    // Records the pipeline, its resources and its push constants.
    void bind(const ComputePipeline& pipeline, std::span<const Resource> resources,
              std::span<const std::byte> push_constants);

    enum class State { recording, submitted, finished };
    Context& context;
    Guarded<Recording> handles;
    State state = State::recording;
};

// Throws std::invalid_argument when the object belongs to another device.
void check_same_device(const Context& a, const Context& b, const char* what);

}  // namespace gloam::gpu
