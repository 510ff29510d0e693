// SPDX-License-Identifier: MIT
#include "backend/vulkan/device.hpp"

#include <unistd.h>
#include <algorithm>
#include <array>
#include <stdexcept>

#include "backend/vulkan/internal/context.hpp"
#include "backend/vulkan/internal/instance.hpp"
#include "base/cached_file.hpp"
#include "base/process.hpp"

namespace gloam::backend::vulkan {
namespace {

Physical choose(const vk::raii::Instance& instance, const std::string& selector) {
    auto devices = physical_devices(instance);
    std::vector<DeviceInfo> infos;
    for (const auto& device : devices) infos.push_back(describe(device, infos.size()));
    const auto chosen = select_device(infos, selector);
    return {std::move(devices[chosen]), std::move(infos[chosen])};
}

vk::PhysicalDeviceVulkan12Features wanted_of_1_2(const vk::raii::PhysicalDevice& device) {
    const auto offered =
        device.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan12Features>()
            .get<vk::PhysicalDeviceVulkan12Features>();
    return {.shaderFloat16 = offered.shaderFloat16};
}

// The requested device features besides the core: robustBufferAccess, which every device has, unless the
// options switch it off. With it, a shader under test that reads beyond its buffer cannot crash the process.
// And arrays of cubes, storing to images of r16f and r8, and storing of fragment shaders to buffers, where
// the device can.
vk::PhysicalDeviceFeatures features_of(const DeviceOptions& options,
                                       const vk::PhysicalDeviceFeatures& offered) {
    return {.robustBufferAccess = options.robust_buffer_access ? VK_TRUE : VK_FALSE,
            .imageCubeArray = offered.imageCubeArray,
            .fragmentStoresAndAtomics = offered.fragmentStoresAndAtomics,
            .shaderStorageImageExtendedFormats = offered.shaderStorageImageExtendedFormats};
}

vk::raii::Device open_device(const Physical& physical, const vk::PhysicalDeviceFeatures& features) {
    constexpr float priority = 1.0f;
    const vk::PhysicalDeviceVulkan12Features newer = wanted_of_1_2(physical.handle);
    const vk::DeviceQueueCreateInfo queue{
        .queueFamilyIndex = physical.queue_family, .queueCount = 1, .pQueuePriorities = &priority};
    return {physical.handle,
            {.pNext = &newer,
             .queueCreateInfoCount = 1,
             .pQueueCreateInfos = &queue,
             .pEnabledFeatures = &features}};
}

// Whether the process ends: C++ destroys what is thread_local in the main thread, then all that is static.
// What a layer keeps in statics of its own may be gone before a static device.
bool ends = false;

void watch_for_the_end() {
    struct OfThread {
        const bool is_main = gettid() == getpid();
        ~OfThread() { ends = ends || is_main; }
    };
    static thread_local const OfThread watched;
}

const DeviceOptions& checked(const DeviceOptions& options) {
    watch_for_the_end();
    if (options.timeout <= std::chrono::milliseconds::zero()) {
        throw std::invalid_argument(
            fmt::format("device timeout of {} ms: must be positive", options.timeout.count()));
    }
    return options;
}

vk::SamplerCreateInfo sampler_info(vk::Filter filter) {
    return {.magFilter = filter,
            .minFilter = filter,
            .addressModeU = vk::SamplerAddressMode::eClampToEdge,
            .addressModeV = vk::SamplerAddressMode::eClampToEdge,
            .maxLod = VK_LOD_CLAMP_NONE};
}

// SwiftShader returns the data that it was given behind one more header, so its file would grow with every
// use.
bool is_news(std::string_view data, std::string_view cached) {
    if (data == cached) return false;
    const bool one_header_more =
        !cached.empty() && data.size() == cached.size() + sizeof(VkPipelineCacheHeaderVersionOne);
    return !(one_header_more && data.ends_with(cached));
}

std::optional<std::uint32_t> find_type(const vk::PhysicalDeviceMemoryProperties& memory,
                                       std::uint32_t allowed, vk::MemoryPropertyFlags wish) {
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
        const bool fits = (allowed >> i & 1u) != 0;
        if (fits && (memory.memoryTypes[i].propertyFlags & wish) == wish) return i;
    }
    return std::nullopt;
}

std::string failure(const Context& context, const vk::MemoryRequirements& needs, const std::string& purpose,
                    const char* reason) {
    return fmt::format("{}: device \"{}\" {} for the {} bytes it needs", purpose, context.physical.info.name,
                       reason, needs.size);
}

}  // namespace

Physical::Physical(vk::raii::PhysicalDevice device, DeviceInfo description)
    : handle(std::move(device)),
      info(std::move(description)),
      properties(handle.getProperties()),
      memory(handle.getMemoryProperties()) {
    const auto family = find_queue_family(handle);
    if (!family) {
        throw std::runtime_error(
            fmt::format("Vulkan device \"{}\" has no queue for both graphics and compute", info.name));
    }
    queue_family = *family;
    const auto bits = handle.getQueueFamilyProperties()[queue_family].timestampValidBits;
    timestamp_mask = bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

Device::Impl::Impl(const DeviceOptions& options)
    : log(checked(options).on_validation_message),
      loader(open_loader()),
      instance(create_instance(loader, options.validation == Validation::on ? &log : nullptr)),
      messenger(options.validation == Validation::on ? std::optional(create_messenger(instance, log))
                                                     : std::nullopt),
      physical(choose(instance, options.device)),
      device(open_device(physical, features_of(options, physical.handle.getFeatures()))),
      queue(device, physical.queue_family, 0),
      command_pool(device, vk::CommandPoolCreateInfo{.flags = vk::CommandPoolCreateFlagBits::eTransient,
                                                     .queueFamilyIndex = physical.queue_family}),
      fence(device, vk::FenceCreateInfo{}),
      sampler(device, sampler_info(vk::Filter::eNearest)),
      linear(device, sampler_info(vk::Filter::eLinear)),
      cache_file(options.cache_directory.empty()
                     ? std::filesystem::path()
                     : options.cache_directory / ("pipelines-" + physical.info.identity + ".bin")),
      cached(base::read_cached(cache_file, base::hash_of(physical.info.identity)).value_or("")),
      cache(device,
            vk::PipelineCacheCreateInfo{.initialDataSize = cached.size(), .pInitialData = cached.data()}),
      timeout(options.timeout) {}

Device::Impl::~Impl() {
    if (cache_file.empty()) return;
    try {
        const auto data = cache.getData();
        const std::string_view bytes(reinterpret_cast<const char*>(data.data()), data.size());
        if (is_news(bytes, cached))
            base::write_cached(cache_file, base::hash_of(physical.info.identity), bytes);
    } catch (...) {  // the next process compiles again
    }
}

vk::raii::CommandBuffers begun(const Context& context) {
    vk::raii::CommandBuffers buffers(context.device, {.commandPool = *context.command_pool,
                                                      .level = vk::CommandBufferLevel::ePrimary,
                                                      .commandBufferCount = 1});
    buffers.front().begin({.flags = vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    device_barrier(buffers.front());
    return buffers;
}

void Device::Impl::run_once(const std::function<void(const vk::raii::CommandBuffer&)>& record) {
    struct OneTime {
        Context& context;
        vk::raii::CommandBuffers buffers;
    };
    const auto once = owned(OneTime{*this, begun(*this)});
    const auto& commands = once->buffers.front();
    record(commands);
    host_barrier(commands);
    commands.end();
    run(commands);
}

void Device::Impl::require_idle() {
    if (idle()) return;
    throw backend::Hang(
        fmt::format("device \"{}\" still runs an earlier submission that timed out", physical.info.name));
}

void Device::Impl::run(const vk::raii::CommandBuffer& commands) {
    require_idle();
    try {
        device.resetFences(*fence);
        queue.submit(vk::SubmitInfo{.commandBufferCount = 1, .pCommandBuffers = &*commands}, *fence);
        busy_ = true;
        const auto result = wait();
        if (result == vk::Result::eTimeout) {
            throw backend::Hang(fmt::format("device \"{}\" did not finish a submission within {} s",
                                            physical.info.name,
                                            std::chrono::duration<double>(timeout).count()));
        }
        busy_ = false;
    } catch (const vk::DeviceLostError&) {
        busy_ = false;  // work of a lost device counts as complete: destruction is allowed
        throw backend::DeviceLost(
            fmt::format("device \"{}\" was lost while it ran a submission: the shader crashed it, or its "
                        "driver's watchdog ended it",
                        physical.info.name));
    }
}

vk::Result Device::Impl::wait() const {
    // Whether the driver computes on the processor, in this process.
    constexpr std::chrono::milliseconds longest =
        std::chrono::years(100);  // in nanoseconds they fit a clock's count
    const auto used = [] { return base::processor_time_of(getpid()); };
    vk::Result result = vk::Result::eTimeout;
    base::wait_patiently(std::min(timeout, longest), used, [&](auto until) {
        const auto left = std::max(until - std::chrono::steady_clock::now(), std::chrono::nanoseconds(0));
        result = device.waitForFences(*fence, VK_TRUE, static_cast<std::uint64_t>(left.count()));
        return result != vk::Result::eTimeout;
    });
    return result;
}

bool Device::Impl::idle() noexcept {
    if (messenger && ends) return false;
    if (!busy_) return true;
    try {
        busy_ = fence.getStatus() == vk::Result::eNotReady;
    } catch (...) {
        busy_ = false;  // lost
    }
    if (!busy_) kept_.clear();
    return !busy_;
}

Device::Device(const DeviceOptions& options)
    : impl_(with_typed_errors([&] { return std::make_unique<Impl>(options); })) {}

Device::~Device() {
    static auto& left = *new std::vector<std::unique_ptr<Impl>>;  // itself never destroyed
    if (!impl_->idle()) left.push_back(std::move(impl_));
}

const DeviceInfo& Device::info() const {
    return impl_->physical.info;
}

bool lacks_float16(const Context& context, std::span<const std::uint32_t> spirv) {
    constexpr std::size_t header_words = 5;
    constexpr std::uint32_t capability = 17;  // OpCapability: two words
    constexpr std::uint32_t float16 = 9;
    for (std::size_t at = header_words; at + 1 < spirv.size() && (spirv[at] & 0xffffU) == capability; at += 2)
        if (spirv[at + 1] == float16) return wanted_of_1_2(context.physical.handle).shaderFloat16 == VK_FALSE;
    return false;
}

std::vector<std::string> Device::take_validation_messages() {
    return impl_->log.take();
}

vk::raii::DeviceMemory allocate(const Context& context, const vk::MemoryRequirements& needs,
                                std::initializer_list<vk::MemoryPropertyFlags> wishes,
                                const std::string& purpose) {
    std::optional<std::uint32_t> type;
    for (auto wish = wishes.begin(); wish != wishes.end() && !type; ++wish) {
        type = find_type(context.physical.memory, needs.memoryTypeBits, *wish);
    }
    if (!type) throw std::runtime_error(failure(context, needs, purpose, "has no memory type"));
    try {
        return {context.device,
                vk::MemoryAllocateInfo{.allocationSize = needs.size, .memoryTypeIndex = *type}};
    } catch (const vk::SystemError&) {
        throw backend::OutOfMemory(failure(context, needs, purpose, "has not enough memory"));
    }
}

vk::raii::ShaderModule make_module(const Context& context, std::span<const std::uint32_t> spirv) {
    constexpr std::size_t header_words = 5;
    constexpr std::uint32_t magic = 0x07230203;
    if (spirv.size() <= header_words || spirv[0] != magic) {
        throw std::invalid_argument(
            fmt::format("not a SPIR-V module: {} words, the first {:#010x}, expected {:#010x}", spirv.size(),
                        spirv.empty() ? 0u : spirv[0], magic));
    }
    return {context.device,
            vk::ShaderModuleCreateInfo{.codeSize = spirv.size_bytes(), .pCode = spirv.data()}};
}

vk::raii::PipelineLayout make_layout(const Context& context, const vk::raii::DescriptorSetLayout& set_layout,
                                     vk::ShaderStageFlags stages, std::uint32_t bytes) {
    const auto limit = context.physical.properties.limits.maxPushConstantsSize;
    if (bytes % 4 != 0 || bytes > limit) {
        throw std::invalid_argument(
            fmt::format("{} bytes of push constants: device \"{}\" allows multiples of 4 up to {}", bytes,
                        context.physical.info.name, limit));
    }
    const vk::PushConstantRange range{.stageFlags = stages, .size = bytes};
    return {context.device, vk::PipelineLayoutCreateInfo{.setLayoutCount = 1,
                                                         .pSetLayouts = &*set_layout,
                                                         .pushConstantRangeCount = bytes > 0 ? 1u : 0u,
                                                         .pPushConstantRanges = &range}};
}

}  // namespace gloam::backend::vulkan
