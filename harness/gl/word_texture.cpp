// SPDX-License-Identifier: MIT
#include "gl/word_texture.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "gl/internal/context.hpp"

namespace gloam::gl {

WordTexture::WordTexture(const Device& device, std::span<const Word> words) : device_(&device) {
    if (words.size() > most_words(device.info()))
        throw std::invalid_argument("more words than a texture of this device holds");
    const std::size_t height = std::max<std::size_t>((words.size() + row - 1) / row, 1);
    std::vector<Word> texels(words.begin(), words.end());
    texels.resize(row * height);
    const internal::Context& context = device.context();
    const internal::Functions& gl = context.use();
    gl.GenTextures(1, &handle_);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, handle_);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32UI, static_cast<GLsizei>(row), static_cast<GLsizei>(height), 0,
                  GL_RED_INTEGER, GL_UNSIGNED_INT, texels.data());
    try {
        context.check("a texture");
    } catch (...) {
        gl.DeleteTextures(1, &handle_);
        throw;
    }
}

WordTexture::~WordTexture() {
    if (handle_ != 0) device_->context().use().DeleteTextures(1, &handle_);
}

WordTexture::WordTexture(WordTexture&& other) noexcept
    : device_(other.device_), handle_(std::exchange(other.handle_, 0U)) {}

}  // namespace gloam::gl
