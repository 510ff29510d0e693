// SPDX-License-Identifier: MIT
#pragma once

#include "gl/image.hpp"
#include "gl/internal/functions.hpp"

namespace gloam::gl::internal {

// OpenGL's name of an image's format.
inline GLenum format_of(Image::Format format) {
    switch (format) {
        case Image::Format::r32f:
            return GL_R32F;
        case Image::Format::rgba16f:
            return GL_RGBA16F;
        case Image::Format::rgba32f:
            break;
    }
    return GL_RGBA32F;
}

}  // namespace gloam::gl::internal
