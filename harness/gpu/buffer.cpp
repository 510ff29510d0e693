// SPDX-License-Identifier: MIT
#include "gpu/buffer.hpp"

#include <stdexcept>

#include "gpu/internal/buffer_impl.hpp"
#include "gpu/internal/memory.hpp"

namespace gloam::gpu {
namespace {

BufferHandles create(const Context& context, std::size_t bytes) {
    const auto limit = context.physical.info.max_buffer_bytes;
    if (bytes == 0 || bytes > limit) {
        throw std::runtime_error(fmt::format("buffer of {} bytes: device \"{}\" allows 1 to {}", bytes,
                                             context.physical.info.name, limit));
    }
    using Usage = vk::BufferUsageFlagBits;
    vk::raii::Buffer buffer(
        context.device,
        vk::BufferCreateInfo{.size = bytes,
                             .usage = Usage::eStorageBuffer | Usage::eVertexBuffer | Usage::eIndexBuffer |
                                      Usage::eIndirectBuffer | Usage::eTransferSrc | Usage::eTransferDst});
    // Cached memory: the host reads results back, which is very slow from write-combined memory.
    using Property = vk::MemoryPropertyFlagBits;
    constexpr auto coherent = Property::eHostVisible | Property::eHostCoherent;
    auto memory =
        allocate(context, buffer.getMemoryRequirements(), {coherent | Property::eHostCached, coherent},
                 fmt::format("buffer of {} bytes", bytes));
    buffer.bindMemory(*memory, 0);
    return {std::move(buffer), std::move(memory)};
}

}  // namespace

Buffer::Impl::Impl(Context& owner, std::size_t bytes)
    : context(owner),
      handles(owner, create(owner, bytes)),
      mapped(static_cast<std::byte*>(handles->memory.mapMemory(0, VK_WHOLE_SIZE)), bytes) {}

Buffer::Buffer(const Device& device, std::size_t bytes)
    : impl_(std::make_unique<Impl>(device.impl(), bytes)) {}
Buffer::~Buffer() = default;
Buffer::Buffer(Buffer&&) noexcept = default;
Buffer& Buffer::operator=(Buffer&&) noexcept = default;

std::size_t Buffer::size() const {
    return impl_->mapped.size();
}
std::span<std::byte> Buffer::bytes() {
    return impl_->mapped;
}
std::span<const std::byte> Buffer::bytes() const {
    return impl_->mapped;
}

}  // namespace gloam::gpu
