// SPDX-License-Identifier: MIT
#include "gl/image.hpp"

#include <stdexcept>
#include <utility>

#include "gl/internal/context.hpp"
#include "gl/internal/image_format.hpp"

namespace gloam::gl {
std::size_t channels_of(Image::Format format) {
    return format == Image::Format::r32f ? 1 : 4;
}

Image::Image(const Device& device, Format format, std::size_t width, std::size_t height)
    : device_(&device), format_(format), width_(width), height_(height) {
    const internal::Context& context = device.context();
    const internal::Functions& gl = context.use();
    if (!has_compute(device.info().name.version))
        throw CallFailed(to_string(device.info().name.version) + " has no images");
    gl.GenTextures(1, &handle_);
    gl.BindTexture(GL_TEXTURE_2D, handle_);
    gl.TexStorage2D(GL_TEXTURE_2D, 1, internal::format_of(format), static_cast<GLsizei>(width),
                    static_cast<GLsizei>(height));
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    try {
        context.check("an image");
        write(std::vector<float>(width * height * channels_of(format)));
    } catch (...) {
        gl.DeleteTextures(1, &handle_);
        throw;
    }
}

Image::~Image() {
    if (handle_ != 0) device_->context().use().DeleteTextures(1, &handle_);
}

Image::Image(Image&& other) noexcept
    : device_(other.device_),
      format_(other.format_),
      width_(other.width_),
      height_(other.height_),
      handle_(std::exchange(other.handle_, 0U)) {}

void Image::write(std::span<const float> channels) {
    if (channels.size() != width_ * height_ * channels_of(format_))
        throw std::invalid_argument("an image has one number for each channel of each texel");
    const internal::Functions& gl = device_->context().use();
    gl.BindTexture(GL_TEXTURE_2D, handle_);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_),
                     channels_of(format_) == 1 ? GL_RED : GL_RGBA, GL_FLOAT, channels.data());
    device_->context().check("writing an image");
}

std::vector<float> Image::read() const {
    const internal::Functions& gl = device_->context().use();
    std::vector<float> texels(width_ * height_ * 4);
    GLuint framebuffer = 0;
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, handle_, 0);
    gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl.ReadPixels(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_), GL_RGBA, GL_FLOAT,
                  texels.data());
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.DeleteFramebuffers(1, &framebuffer);
    device_->context().check("reading an image");
    return texels;
}

}  // namespace gloam::gl
