// SPDX-License-Identifier: MIT
#include "backend/vulkan/radv.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "backend/vulkan/internal/instance.hpp"
#include "backend/vulkan/internal/objects.hpp"
#include "base/text.hpp"

namespace gloam::backend::vulkan {
namespace {

void choose(const std::string& chip) {
    std::map<std::string, std::string> kept{{"RADV_FORCE_FAMILY", chip},
                                            {"NODEVICE_SELECT", "1"},  // Mesa's layer asks the desktop
                                            {"MESA_SHADER_CACHE_DISABLE", "true"}};
    for (const char* name :
         {"VK_DRIVER_FILES", "VK_ICD_FILENAMES", "VK_ADD_DRIVER_FILES", "VK_LAYER_PATH", "XDG_DATA_DIRS"})
        if (const char* value = std::getenv(name)) kept[name] = value;
    ::clearenv();
    for (const auto& [name, value] : kept) ::setenv(name.c_str(), value.c_str(), 1);
}

vk::raii::Instance instance_of(const vk::raii::Context& loader, MessageLog* log) {
    try {
        return create_instance(loader, log);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(
            std::string_view(error.what()).starts_with(no_device_message) ? no_radv_message : error.what());
    }
}

vk::raii::PhysicalDevice radv_of(const vk::raii::Instance& instance) {
    for (vk::raii::PhysicalDevice& device : physical_devices(instance)) {
        const auto chain =
            device.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
        if (chain.get<vk::PhysicalDeviceDriverProperties>().driverID == vk::DriverId::eMesaRadv)
            return std::move(device);
    }
    throw std::runtime_error(no_radv_message);
}

// With every feature, but for those of capture tools and of several devices.
vk::raii::Device opened(const vk::raii::PhysicalDevice& physical) {
    auto features = physical.getFeatures2<vk::PhysicalDeviceFeatures2, vk::PhysicalDeviceVulkan11Features,
                                          vk::PhysicalDeviceVulkan12Features,
                                          vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR>();
    auto& newer = features.get<vk::PhysicalDeviceVulkan12Features>();
    newer.bufferDeviceAddressCaptureReplay = newer.bufferDeviceAddressMultiDevice = VK_FALSE;
    const float priority = 1.0F;
    const vk::DeviceQueueCreateInfo queue{.queueCount = 1, .pQueuePriorities = &priority};
    const char* extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
    return {physical, vk::DeviceCreateInfo{.pNext = &features.get<vk::PhysicalDeviceFeatures2>(),
                                           .queueCreateInfoCount = 1,
                                           .pQueueCreateInfos = &queue,
                                           .enabledExtensionCount = 1,
                                           .ppEnabledExtensionNames = &extension}};
}

vk::DescriptorType type_of(DescriptorKind kind) {
    constexpr std::array types{vk::DescriptorType::eStorageImage,  vk::DescriptorType::eCombinedImageSampler,
                               vk::DescriptorType::eSampledImage,  vk::DescriptorType::eSampler,
                               vk::DescriptorType::eStorageBuffer, vk::DescriptorType::eUniformBuffer};
    return types.at(static_cast<std::size_t>(kind));
}

std::vector<vk::raii::DescriptorSetLayout> sets_of(const vk::raii::Device& device, std::uint32_t most,
                                                   const std::vector<Descriptor>& descriptors) {
    std::vector<std::map<std::uint32_t, vk::DescriptorSetLayoutBinding>> sets;  // by number
    for (const Descriptor& one : descriptors) {
        if (one.set >= most)
            throw std::runtime_error(fmt::format("descriptor set {}: expected one below {}", one.set, most));
        if (one.set >= sets.size()) sets.resize(one.set + std::size_t{1});
        sets[one.set][one.number] = {.binding = one.number,
                                     .descriptorType = type_of(one.kind),
                                     .descriptorCount = one.count,
                                     .stageFlags = vk::ShaderStageFlagBits::eCompute};
    }
    std::vector<vk::raii::DescriptorSetLayout> layouts;
    for (const auto& set : sets) {
        std::vector<vk::DescriptorSetLayoutBinding> bindings;
        for (const auto& [number, binding] : set) bindings.push_back(binding);
        layouts.emplace_back(device, vk::DescriptorSetLayoutCreateInfo{
                                         .bindingCount = static_cast<std::uint32_t>(bindings.size()),
                                         .pBindings = bindings.data()});
    }
    return layouts;
}

vk::raii::PipelineLayout layout_of(const vk::raii::Device& device, std::uint32_t push_constant_bytes,
                                   const std::vector<vk::raii::DescriptorSetLayout>& sets) {
    std::vector<vk::DescriptorSetLayout> handles;
    for (const vk::raii::DescriptorSetLayout& set : sets) handles.push_back(*set);
    const vk::PushConstantRange range{.stageFlags = vk::ShaderStageFlagBits::eCompute,
                                      .size = (push_constant_bytes + 3) / 4 * 4};
    return {device, vk::PipelineLayoutCreateInfo{.setLayoutCount = static_cast<std::uint32_t>(handles.size()),
                                                 .pSetLayouts = handles.data(),
                                                 .pushConstantRangeCount = range.size > 0 ? 1U : 0U,
                                                 .pPushConstantRanges = &range}};
}

vk::raii::Pipeline pipeline_of(const vk::raii::Device& device, const RadvProgram& program,
                               const vk::raii::PipelineLayout& layout) {
    const vk::raii::ShaderModule module(
        device,
        vk::ShaderModuleCreateInfo{.codeSize = program.spirv.size_bytes(), .pCode = program.spirv.data()});
    const Specialization specialization(program.constants);
    return {
        device, nullptr,
        vk::ComputePipelineCreateInfo{.flags = vk::PipelineCreateFlagBits::eCaptureStatisticsKHR |
                                               vk::PipelineCreateFlagBits::eCaptureInternalRepresentationsKHR,
                                      .stage = {.stage = vk::ShaderStageFlagBits::eCompute,
                                                .module = *module,
                                                .pName = "main",
                                                .pSpecializationInfo = &specialization.info},
                                      .layout = *layout}};
}

// Called twice: Vulkan tells the sizes of the texts, then writes them where it is told. The C++ binding keeps
// no place for them.
std::string assembly_of(const vk::raii::Device& device, const VkPipelineExecutableInfoKHR& executable) {
    using Text = VkPipelineExecutableInternalRepresentationKHR;
    const auto get = device.getDispatcher()->vkGetPipelineExecutableInternalRepresentationsKHR;
    std::uint32_t count = 0;
    get(*device, &executable, &count, nullptr);
    std::vector<Text> texts(count,
                            Text{.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INTERNAL_REPRESENTATION_KHR});
    get(*device, &executable, &count, texts.data());
    for (Text& text : texts) {
        if (std::string_view(text.name) != "Assembly") continue;
        std::string assembly(text.dataSize, '\0');
        text.pData = assembly.data();
        get(*device, &executable, &count, texts.data());
        return assembly.substr(0, assembly.find('\0'));
    }
    throw std::runtime_error("RADV gives no text of its program");
}

}  // namespace

std::vector<RadvReport> compiled_by_radv(std::span<const RadvProgram> programs, const std::string& chip,
                                         Validation validation) {
    choose(chip);
    MessageLog log;
    std::vector<RadvReport> reports;
    {
        const vk::raii::Context loader = open_loader();
        const bool validated = validation == Validation::on;
        const vk::raii::Instance instance = instance_of(loader, validated ? &log : nullptr);
        std::optional<vk::raii::DebugUtilsMessengerEXT> messenger;
        if (validated) messenger = create_messenger(instance, log);
        const vk::raii::PhysicalDevice physical = radv_of(instance);
        const vk::raii::Device device = opened(physical);
        const std::uint32_t most_sets = physical.getProperties().limits.maxBoundDescriptorSets;
        for (const RadvProgram& program : programs) {
            const auto sets = sets_of(device, most_sets, program.descriptors);
            const vk::raii::PipelineLayout layout = layout_of(device, program.push_constant_bytes, sets);
            const vk::raii::Pipeline pipeline = pipeline_of(device, program, layout);
            const vk::PipelineExecutableInfoKHR executable{.pipeline = *pipeline};
            RadvReport& report = reports.emplace_back();
            for (const auto& one : device.getPipelineExecutableStatisticsKHR(executable))
                report.statistics[base::lower(one.name)] = one.value.u64;
            report.assembly = assembly_of(device, executable);
        }
    }
    if (!reports.empty()) reports.front().messages = log.take();
    return reports;
}

}  // namespace gloam::backend::vulkan
