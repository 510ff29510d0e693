// SPDX-License-Identifier: MIT
#include "gpu/internal/format.hpp"

#include <stdexcept>

namespace gloam::gpu {

const FormatTraits& traits(Format format) {
    using Aspect = vk::ImageAspectFlagBits;
    using Usage = vk::ImageUsageFlagBits;
    static constexpr auto color = Usage::eStorage | Usage::eSampled | Usage::eColorAttachment;
    static constexpr FormatTraits r32f{"r32f", vk::Format::eR32Sfloat, 1, 4, Aspect::eColor, color};
    static constexpr FormatTraits rgba32f{"rgba32f", vk::Format::eR32G32B32A32Sfloat, 4, 16, Aspect::eColor,
                                          color};
    static constexpr FormatTraits rgba16f{"rgba16f", vk::Format::eR16G16B16A16Sfloat, 4, 8, Aspect::eColor,
                                          color};
    static constexpr FormatTraits rgba16ui{"rgba16ui",     vk::Format::eR16G16B16A16Uint,    4, 8,
                                           Aspect::eColor, Usage::eStorage | Usage::eSampled};
    static constexpr FormatTraits depth32f{"depth32f",     vk::Format::eD32Sfloat,        1, 4,
                                           Aspect::eDepth, Usage::eDepthStencilAttachment};
    static constexpr FormatTraits r16f{"r16f", vk::Format::eR16Sfloat, 1, 2, Aspect::eColor, color};
    static constexpr FormatTraits r8{"r8", vk::Format::eR8Unorm, 1, 1, Aspect::eColor, color};
    static constexpr FormatTraits r32ui{"r32ui", vk::Format::eR32Uint, 1,
                                        4,       Aspect::eColor,       Usage::eStorage | Usage::eSampled};
    switch (format) {
        case Format::r32f:
            return r32f;
        case Format::rgba32f:
            return rgba32f;
        case Format::rgba16f:
            return rgba16f;
        case Format::rgba16ui:
            return rgba16ui;
        case Format::depth32f:
            return depth32f;
        case Format::r16f:
            return r16f;
        case Format::r8:
            return r8;
        case Format::r32ui:
            return r32ui;
    }
    throw std::invalid_argument(fmt::format("unknown image format {}", static_cast<int>(format)));
}

int channels(Format format) {
    return traits(format).channels;
}

}  // namespace gloam::gpu
