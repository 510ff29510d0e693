// SPDX-License-Identifier: MIT
#include "gpu/commands.hpp"

#include <stdexcept>

#include "gpu/internal/barrier.hpp"
#include "gpu/internal/buffer_impl.hpp"
#include "gpu/internal/commands_impl.hpp"
#include "gpu/internal/image_impl.hpp"

namespace gloam::gpu {
namespace {

Recording create(const Context& context) {
    vk::raii::CommandBuffers buffers(context.device, {.commandPool = *context.command_pool,
                                                      .level = vk::CommandBufferLevel::ePrimary,
                                                      .commandBufferCount = 1});
    buffers.front().begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    device_barrier(buffers.front());
    return {.buffers = std::move(buffers), .descriptors = {}, .timestamps = {}, .framebuffers = {}};
}

bool is_buffer(const Resource& resource) {
    return std::holds_alternative<std::reference_wrapper<const Buffer>>(resource);
}

void check_resource(const ComputePipeline::Impl& pipeline, const Resource& resource, std::size_t binding) {
    const auto wanted = pipeline.bindings[binding];
    if (is_buffer(resource) != (wanted == BindingKind::storage_buffer)) {
        throw std::invalid_argument(
            fmt::format("dispatch: resource {} is {}, the pipeline's binding is a {}", binding,
                        is_buffer(resource) ? "a storage buffer" : "an image", name_of(wanted)));
    }
    if (wanted == BindingKind::storage_buffer) {
        const Buffer& buffer = std::get<std::reference_wrapper<const Buffer>>(resource);
        check_same_device(buffer.impl().context, pipeline.context, "dispatch: a buffer");
        return;
    }
    const Image& image = std::get<std::reference_wrapper<const Image>>(resource);
    check_same_device(image.impl().context, pipeline.context, "dispatch: an image");
    if (image.format() == Format::depth32f) {
        throw std::invalid_argument(
            fmt::format("dispatch: resource {} is a depth32f image, which no shader can store to: expected a "
                        "colour format",
                        binding));
    }
}

void check_resources(const ComputePipeline::Impl& pipeline, std::span<const Resource> resources) {
    if (resources.size() != pipeline.bindings.size()) {
        throw std::invalid_argument(fmt::format("dispatch: {} resources, the pipeline has {} bindings",
                                                resources.size(), pipeline.bindings.size()));
    }
    for (std::size_t i = 0; i < resources.size(); ++i) check_resource(pipeline, resources[i], i);
}

void check_groups(const DeviceInfo& device, const std::array<std::uint32_t, 3>& groups) {
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i] > device.max_group_count[i]) {
            throw std::invalid_argument(fmt::format("dispatch: {} work groups in {}, device \"{}\" allows {}",
                                                    groups[i], "xyz"[i], device.name,
                                                    device.max_group_count[i]));
        }
    }
}

void check_push_constants(const ComputePipeline::Impl& pipeline, std::span<const std::byte> push_constants) {
    if (push_constants.size() != pipeline.push_constant_bytes) {
        throw std::invalid_argument(fmt::format("dispatch: {} bytes of push constants, the pipeline has {}",
                                                push_constants.size(), pipeline.push_constant_bytes));
    }
}

}  // namespace

void check_same_device(const Context& a, const Context& b, const char* what) {
    if (&a != &b) {
        throw std::invalid_argument(fmt::format("{} belongs to another device than the one in use, \"{}\"",
                                                what, b.physical.info.name));
    }
}

Commands::Impl::Impl(Context& owner) : context(owner), handles(owner, create(owner)) {}

const vk::raii::CommandBuffer& Commands::Impl::recording() const {
    if (state != State::recording) throw std::runtime_error("these commands were submitted: record new ones");
    return handles->buffers.front();
}

void Commands::Impl::check(const ComputePipeline& pipeline, std::span<const Resource> resources,
                           std::span<const std::byte> push_constants) const {
    (void)recording();
    check_same_device(pipeline.impl().context, context, "dispatch: the pipeline");
    check_resources(pipeline.impl(), resources);
    check_push_constants(pipeline.impl(), push_constants);
}

void Commands::Impl::bind(const ComputePipeline& pipeline, std::span<const Resource> resources,
                          std::span<const std::byte> push_constants) {
    constexpr auto point = vk::PipelineBindPoint::eCompute;
    const auto& program = pipeline.impl();
    const auto& commands = recording();
    commands.bindPipeline(point, *program.handles->pipeline);
    if (!resources.empty()) {
        const auto& set = handles->descriptors.allocate(program);
        write_descriptors(context, set, program.bindings, resources);
        commands.bindDescriptorSets(point, *program.handles->layout, 0, *set, nullptr);
    }
    if (!push_constants.empty()) {
        commands.pushConstants<std::byte>(*program.handles->layout, vk::ShaderStageFlagBits::eCompute, 0,
                                          push_constants);
    }
}

Commands::Commands(const Device& device) : impl_(std::make_unique<Impl>(device.impl())) {}
Commands::~Commands() = default;
Commands::Commands(Commands&&) noexcept = default;
Commands& Commands::operator=(Commands&&) noexcept = default;

void Commands::dispatch(const ComputePipeline& pipeline, std::span<const Resource> resources,
                        std::array<std::uint32_t, 3> groups, std::span<const std::byte> push_constants) {
    impl_->check(pipeline, resources, push_constants);
    check_groups(impl_->context.physical.info, groups);
    impl_->bind(pipeline, resources, push_constants);
    const auto& commands = impl_->recording();
    commands.dispatch(groups[0], groups[1], groups[2]);
    device_barrier(commands);
}

void Commands::dispatch_indirect(const ComputePipeline& pipeline, std::span<const Resource> resources,
                                 const Buffer& groups, std::size_t offset,
                                 std::span<const std::byte> push_constants) {
    impl_->check(pipeline, resources, push_constants);
    check_same_device(groups.impl().context, impl_->context, "dispatch: the buffer of group counts");
    constexpr std::size_t needed = sizeof(vk::DispatchIndirectCommand);
    if (offset % 4 != 0 || offset > groups.size() || groups.size() - offset < needed) {
        throw std::invalid_argument(fmt::format(
            "dispatch: group counts at byte {} of a buffer of {}: expected a multiple of 4 and {} "
            "bytes from there on",
            offset, groups.size(), needed));
    }
    impl_->bind(pipeline, resources, push_constants);
    const auto& commands = impl_->recording();
    commands.dispatchIndirect(*groups.impl().handles->buffer, offset);
    device_barrier(commands);
}

std::size_t Commands::timestamp() {
    const auto& commands = impl_->recording();
    const std::size_t position = impl_->handles->timestamps.record(impl_->context, commands);
    // lavapipe delays a dispatch until something waits for it. Without a barrier, the time of the work before
    // the reading would count after it.
    device_barrier(commands);
    return position;
}

void Commands::submit() {
    const auto& commands = impl_->recording();
    host_barrier(commands);
    commands.end();
    impl_->state = Impl::State::submitted;
    impl_->context.run(commands);
    impl_->state = Impl::State::finished;
}

std::vector<double> Commands::times_ms() const {
    if (impl_->state != Impl::State::finished) {
        throw std::runtime_error("times of commands that have not been submitted and finished");
    }
    return impl_->handles->timestamps.read_ms(impl_->context);
}

}  // namespace gloam::gpu
