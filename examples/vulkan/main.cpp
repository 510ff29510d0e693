// SPDX-License-Identifier: MIT
// vulkan_frame GBUFFERS OUT RADIUS linear|buffer: the ambient occlusion of a sequence, by the passes that
// `gloam pack --effect` wrote. An engine has what stands above `struct Images`.
#include <gloam_frame.h>

#include <optional>
#include <vulkan/vulkan_raii.hpp>

#include "gbuffers.hpp"

constexpr auto general = vk::ImageLayout::eGeneral;
constexpr vk::ImageSubresourceRange all_levels(vk::ImageAspectFlagBits::eColor, 0, VK_REMAINING_MIP_LEVELS, 0,
                                               1);

using Commands = vk::raii::CommandBuffer;

struct Device {
    Device() {
        const float priority = 1.0F;
        const vk::DeviceQueueCreateInfo queues({}, 0, 1, &priority);
        vk::PhysicalDeviceFeatures features;
        features.shaderStorageImageExtendedFormats = VK_TRUE;
        const char* const extension = VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME;
        device = {physical, vk::DeviceCreateInfo({}, queues, {}, extension, &features)};
        vk::SamplerCreateInfo sampler;
        sampler.setMaxLod(VK_LOD_CLAMP_NONE);
        sampler.addressModeU = sampler.addressModeV = vk::SamplerAddressMode::eClampToEdge;
        nearest = {device, sampler};
        linear = {device, sampler.setMagFilter(vk::Filter::eLinear)};
    }

    vk::raii::DeviceMemory memory(const vk::MemoryRequirements& needs, vk::MemoryPropertyFlags wanted) const {
        const vk::PhysicalDeviceMemoryProperties all = physical.getMemoryProperties();
        std::uint32_t i = 0;
        while ((needs.memoryTypeBits >> i & 1U) == 0 || (all.memoryTypes[i].propertyFlags & wanted) != wanted)
            ++i;
        return {device, vk::MemoryAllocateInfo(needs.size, i)};
    }

    // Records, submits and waits.
    template <class Record>
    void run(const Record& record) const {
        const vk::raii::CommandPool pool(device, {vk::CommandPoolCreateFlagBits::eTransient, 0});
        const vk::raii::CommandBuffers buffers(device, {*pool, vk::CommandBufferLevel::ePrimary, 1});
        buffers[0].begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        record(buffers[0]);
        buffers[0].end();
        const vk::raii::Queue queue(device, 0, 0);
        queue.submit(vk::SubmitInfo({}, {}, *buffers[0]));
        queue.waitIdle();
    }

    vk::raii::Context context;
    vk::ApplicationInfo application{"vulkan_frame", 1, "", 0, VK_API_VERSION_1_2};
    vk::raii::Instance instance{context, vk::InstanceCreateInfo({}, &application)};
    vk::raii::PhysicalDevice physical{vk::raii::PhysicalDevices(instance).at(0)};
    vk::raii::Device device{nullptr};
    vk::raii::Sampler nearest{nullptr}, linear{nullptr};
};

void barrier(const Commands& commands, vk::ArrayProxy<const vk::ImageMemoryBarrier> images = nullptr) {
    const auto all = vk::PipelineStageFlagBits::eAllCommands;
    const vk::MemoryBarrier memory(vk::AccessFlagBits::eMemoryWrite,
                                   vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite);
    commands.pipelineBarrier(all, all, {}, memory, nullptr, images);
}

struct Buffer {
    Buffer(const Device& d, vk::DeviceSize bytes, vk::BufferUsageFlags usage, vk::MemoryPropertyFlags wanted)
        : handle(d.device, {{}, bytes, usage}), memory(d.memory(handle.getMemoryRequirements(), wanted)) {
        handle.bindMemory(*memory, 0);
    }
    vk::raii::Buffer handle;
    vk::raii::DeviceMemory memory;
};

// In the layout general, filled with zeros. divisor: of the size, rounded up.
struct Image {
    Image(const Device& d, vk::Format format, const int size[2], int divisor = 1, std::uint32_t levels = 1)
        : extent((size[0] + divisor - 1) / divisor, (size[1] + divisor - 1) / divisor, 1),
          handle(d.device,
                 vk::ImageCreateInfo({}, vk::ImageType::e2D, format, extent, levels, 1)
                     .setUsage(vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eSampled |
                               vk::ImageUsageFlagBits::eTransferSrc | vk::ImageUsageFlagBits::eTransferDst)),
          memory(d.memory(handle.getMemoryRequirements(), {})) {
        handle.bindMemory(*memory, 0);
        for (std::uint32_t view = 0; view <= levels; ++view) {
            const vk::ImageSubresourceRange level(vk::ImageAspectFlagBits::eColor, view - 1, 1, 0, 1);
            views.emplace_back(d.device, vk::ImageViewCreateInfo({}, *handle, vk::ImageViewType::e2D, format,
                                                                 {}, view == 0 ? all_levels : level));
        }
        d.run([&](const Commands& commands) {
            barrier(commands, vk::ImageMemoryBarrier({}, vk::AccessFlagBits::eMemoryWrite, {}, general, 0, 0,
                                                     *handle, all_levels));
            commands.clearColorImage(*handle, general, vk::ClearColorValue{}, all_levels);
        });
    }
    operator vk::ImageView() const { return *views[0]; }  // of all levels
    vk::ImageView level(int number) const { return *views[number + 1]; }
    vk::Extent3D extent;
    vk::raii::Image handle;
    vk::raii::DeviceMemory memory;
    std::vector<vk::raii::ImageView> views;
};

// Copies values into an image, or those of an image.
template <class Values>
void copy(const Device& d, Values& values, const Image& image, bool to_image) {
    const std::size_t bytes = values.size() * sizeof values[0];
    const auto usage = vk::BufferUsageFlagBits::eTransferSrc | vk::BufferUsageFlagBits::eTransferDst;
    const auto seen = vk::MemoryPropertyFlagBits::eHostVisible | vk::MemoryPropertyFlagBits::eHostCoherent;
    const Buffer buffer(d, bytes, usage, seen);
    void* mapped = buffer.memory.mapMemory(0, VK_WHOLE_SIZE);
    if (to_image) std::memcpy(mapped, values.data(), bytes);
    d.run([&](const Commands& commands) {
        const vk::BufferImageCopy all(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {}, image.extent);
        if (to_image) commands.copyBufferToImage(*buffer.handle, *image.handle, general, all);
        if (!to_image) commands.copyImageToBuffer(*image.handle, general, *buffer.handle, all);
    });
    if constexpr (!std::is_const_v<Values>)
        if (!to_image) std::memcpy(values.data(), mapped, bytes);
}

// kinds: of its bindings: i, an image that is written; n or l, one whose nearest texel is read, or linearly;
// b, the lists. width, height: what a group makes. work: the list that says how many groups there are.
struct Pass {
    Pass(const Device& device, const char* name, std::string_view kinds, std::uint32_t bytes, int width,
         int height, int work = 0)
        : d(device), kinds(kinds), bytes(bytes), width(width), height(height), work(work) {
        std::vector<vk::DescriptorSetLayoutBinding> bindings;
        for (std::uint32_t i = 0; i < kinds.size(); ++i)
            bindings.emplace_back(i, type(i), 1, vk::ShaderStageFlagBits::eCompute);
        set = {d.device, {vk::DescriptorSetLayoutCreateFlagBits::ePushDescriptorKHR, bindings}};
        const vk::PushConstantRange range(vk::ShaderStageFlagBits::eCompute, 0, bytes);
        layout = {d.device, vk::PipelineLayoutCreateInfo({}, *set, range)};
        const std::string code = read_file(std::string(MODULES) + "/" + name + ".spv");
        const vk::raii::ShaderModule module(
            d.device,
            vk::ShaderModuleCreateInfo({}, code.size(), reinterpret_cast<const std::uint32_t*>(code.data())));
        const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main");
        pipeline = {d.device, nullptr, vk::ComputePipelineCreateInfo({}, stage, *layout)};
    }
    vk::DescriptorType type(std::size_t binding) const {
        return kinds[binding] == 'i'   ? vk::DescriptorType::eStorageImage
               : kinds[binding] == 'b' ? vk::DescriptorType::eStorageBuffer
                                       : vk::DescriptorType::eCombinedImageSampler;
    }
    void record(const Commands& commands, const std::vector<vk::ImageView>& views, const Buffer& lists,
                const void* parameters, const vk::Extent3D& made) const {
        using Access = vk::AccessFlagBits;
        const auto stages =
            vk::PipelineStageFlagBits::eComputeShader | vk::PipelineStageFlagBits::eDrawIndirect;
        const vk::MemoryBarrier memory(
            Access::eShaderWrite, Access::eShaderRead | Access::eShaderWrite | Access::eIndirectCommandRead);
        commands.pipelineBarrier(stages, stages, {}, memory, nullptr, nullptr);
        std::vector<vk::DescriptorImageInfo> images(kinds.size());
        for (std::size_t i = 0; i < views.size(); ++i)
            images[i] = {kinds[i] == 'l' ? *d.linear : *d.nearest, views[i], general};
        const vk::DescriptorBufferInfo list(*lists.handle, 0, VK_WHOLE_SIZE);
        std::vector<vk::WriteDescriptorSet> writes;
        for (std::uint32_t i = 0; i < kinds.size(); ++i)
            writes.emplace_back(vk::DescriptorSet{}, i, 0, 1, type(i), &images[i], &list);
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline);
        commands.pushDescriptorSetKHR(vk::PipelineBindPoint::eCompute, *layout, 0, writes);
        commands.pushConstants<char>(*layout, vk::ShaderStageFlagBits::eCompute, 0,
                                     {bytes, static_cast<const char*>(parameters)});
        if (work > 0) return commands.dispatchIndirect(*lists.handle, 16 * work);
        commands.dispatch((made.width + width - 1) / width, (made.height + height - 1) / height, 1);
    }
    const Device& d;
    std::string_view kinds;
    std::uint32_t bytes;
    int width, height, work;
    vk::raii::DescriptorSetLayout set{nullptr};
    vk::raii::PipelineLayout layout{nullptr};
    vk::raii::Pipeline pipeline{nullptr};
};

// What stands in gloam_frame.h, for views of one size.
struct Images {
    Images(const Device& d, const gloam_settings& s)
        : depth(d, vk::Format::eR32Sfloat, s.size),
          normal(d, vk::Format::eR32G32B32A32Sfloat, s.size),
          levels(d, depths(s), s.size, 1, 5),
          levels_before(d, depths(s), s.size, 1, 5),
          texels(d, texel(s), s.size, s.preset.resolution == gloam_full ? 1 : 2),
          history(d, vk::Format::eA2B10G10R10UnormPack32, s.size),
          history_before(d, vk::Format::eA2B10G10R10UnormPack32, s.size),
          shown(d, vk::Format::eR8Unorm, s.size),
          marks(d, vk::Format::eR8Unorm, s.size, 8),
          full_texels(d, texel(s), s.size, s.preset.resolution == gloam_tiles ? 1 : s.size[0] + s.size[1]),
          lists(d, 68 + 8 * marks.extent.width * marks.extent.height,
                vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eIndirectBuffer, {}) {}
    static vk::Format depths(const gloam_settings& s) {
        return s.preset.deep ? vk::Format::eR32Sfloat : vk::Format::eR16Sfloat;
    }
    static vk::Format texel(const gloam_settings& s) {
        return s.preset.deep ? vk::Format::eR32G32Uint : vk::Format::eR32Uint;
    }

    Image depth, normal, levels, levels_before, texels, history, history_before, shown;
    Image marks, full_texels;  // these and the lists are for tiles alone
    Buffer lists;
};

struct Passes {
    Passes(const Device& d, gloam_resolution resolution)
        : prepare(d, "prepare", "niiiiinb", sizeof(gloam_prepare), 32, 16),
          sweep(d, "sweep", "nni", sizeof(gloam_sweep), 16, 8) {
        const bool tiles = resolution == gloam_tiles;
        if (tiles) mark.emplace(d, "mark", "nib", sizeof(gloam_mark), 8, 8);
        if (tiles) refine.emplace(d, "refine", "nniib", sizeof(gloam_sweep), 0, 0, 1);
        if (resolution != gloam_full)
            join.emplace(d, "join", "nnilniib", sizeof(gloam_last), 32, 16, tiles ? 3 : 0);
        if (resolution != gloam_half)
            filter.emplace(d, "filter", "nilnib", sizeof(gloam_last), 32, 8, tiles ? 2 : 0);
    }
    Pass prepare, sweep;
    std::optional<Pass> mark, refine, join, filter;
};

void record(const Commands& commands, const Passes& passes, Images& of, const gloam_frame& frame) {
    std::vector<vk::ImageView> prepared{of.depth};
    for (int i = 0; i < 5; ++i) prepared.push_back(of.levels.level(i));
    prepared.push_back(of.levels_before);
    barrier(commands);  // behind what the engine has written
    passes.prepare.record(commands, prepared, of.lists, &frame.prepare, of.depth.extent);
    passes.sweep.record(commands, {of.levels, of.normal, of.texels}, of.lists, &frame.sweep,
                        of.texels.extent);
    if (passes.mark)
        passes.mark->record(commands, {of.texels, of.marks}, of.lists, &frame.mark, of.marks.extent);
    if (passes.refine)
        passes.refine->record(commands, {of.levels, of.normal, of.full_texels, of.texels}, of.lists,
                              &frame.sweep, {});
    if (passes.join)
        passes.join->record(
            commands,
            {of.texels, of.levels, of.shown, of.history_before, of.levels_before, of.history, of.full_texels},
            of.lists, &frame.join, of.shown.extent);
    if (passes.filter)
        passes.filter->record(commands,
                              {passes.refine ? of.full_texels : of.texels, of.shown, of.history_before,
                               of.levels_before, of.history},
                              of.lists, &frame.filter, of.shown.extent);
    barrier(commands);  // before the engine reads `shown`
    std::swap(of.levels, of.levels_before);
    std::swap(of.history, of.history_before);
}

void run(char** arguments) {
    const Device device;
    const Passes passes(device, PRESET.resolution);
    std::optional<Images> images;
    each_frame(arguments, [&](const gloam_frame& frame, const Picture& depth, const Picture& normal) {
        if (!images || images->depth.extent != vk::Extent3D(depth.width, depth.height, 1))
            images.emplace(device, frame.settings);
        copy(device, depth.values, images->depth, true);
        copy(device, normal.values, images->normal, true);
        device.run([&](const Commands& commands) { record(commands, passes, *images, frame); });
        std::vector<unsigned char> shown(depth.values.size());
        copy(device, shown, images->shown, false);
        return shown;
    });
}

int main(int count, char** arguments) {
    return run_example(count, arguments, run);
}
