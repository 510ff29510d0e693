// SPDX-License-Identifier: MIT
#include "gl/device.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gl/internal/context.hpp"

namespace gloam::gl {
namespace {

using internal::Context;

DeviceName required_name(const std::string& text) {
    const auto name = device_name_from(text);
    if (name) return *name;
    throw std::invalid_argument(fmt::format(
        "no OpenGL device \"{}\": expected a name such as gl:llvmpipe-4.5 or es:softpipe-3.1", text));
}

std::uint32_t limit(const Context& context, GLenum what) {
    return static_cast<std::uint32_t>(std::max(context.integer(what), 0));
}

DeviceInfo describe(const Context& context, const DeviceName& name) {
    DeviceInfo info{.name = name,
                    .vendor = context.text(GL_VENDOR),
                    .renderer = context.text(GL_RENDERER),
                    .version = context.text(GL_VERSION),
                    .glsl_version = context.text(GL_SHADING_LANGUAGE_VERSION),
                    .max_texture_size = limit(context, GL_MAX_TEXTURE_SIZE),
                    .max_draw_buffers = limit(context, GL_MAX_DRAW_BUFFERS),
                    .max_texture_units = limit(context, GL_MAX_TEXTURE_IMAGE_UNITS)};
    if (has_compute(name.version)) {
        GLint64 bytes = 0;
        context.functions.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
        info.max_storage_bytes = static_cast<std::uint64_t>(std::max<GLint64>(bytes, 0));
        info.max_storage_blocks = limit(context, GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS);
    }
    return info;
}

bool runs(const DeviceInfo& info, const std::string& executor) {
    return info.renderer.find(executor) != std::string::npos;
}

}  // namespace

Device::Device(const std::string& name) {
    const DeviceName wanted = required_name(name);
    context_ = std::make_unique<Context>(wanted);
    info_ = describe(*context_, wanted);
    if (wanted.executor != "system" && !runs(info_, wanted.executor)) {
        throw Unavailable(fmt::format("{}: OpenGL is executed by \"{}\", not by {}", name, info_.renderer,
                                      wanted.executor));
    }
    context_->check("opening " + name);
}

Device::~Device() = default;

std::vector<DeviceInfo> list_devices(const std::string& executor) {
    std::vector<DeviceInfo> devices;
    for (const Version& version : versions()) {
        try {
            devices.push_back(Device(to_string(DeviceName{executor, version})).info());
        } catch (const VersionRefused&) {
            continue;
        }
    }
    const auto is_other = [&](const DeviceInfo& info) {
        return std::ranges::any_of(executors(), [&](const auto& other) { return runs(info, other); });
    };
    if (executor == "system") std::erase_if(devices, is_other);
    return devices;
}

}  // namespace gloam::gl
