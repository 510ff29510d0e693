// SPDX-License-Identifier: MIT
#include "backend/gl/resources.hpp"

#include <algorithm>
#include <stdexcept>

#include "backend/gl/internal/context.hpp"

namespace gloam::gl {
namespace {

// Every version has this target, and nothing else uses it.
constexpr GLenum target = GL_COPY_WRITE_BUFFER;

}  // namespace

Handle::Handle(const Device& device, Kind kind) : device_(&device), kind_(kind) {
    const internal::Functions& gl = device.context().use();
    if (kind == Kind::program)
        name_ = gl.CreateProgram();
    else
        (kind == Kind::buffer ? gl.GenBuffers : gl.GenTextures)(1, &name_);
}

Handle::~Handle() {
    if (name_ == 0) return;
    const internal::Functions& gl = device_->context().use();
    if (kind_ == Kind::program)
        gl.DeleteProgram(name_);
    else
        (kind_ == Kind::buffer ? gl.DeleteBuffers : gl.DeleteTextures)(1, &name_);
}

Buffer::Buffer(const Device& device, std::size_t words)
    : words_(std::max<std::size_t>(words, 1)), handle_(device, Handle::Kind::buffer) {
    const internal::Context& context = device.context();
    const internal::Functions& gl = context.use();
    const std::vector<Word> zeros(words_);
    gl.BindBuffer(target, handle_.name());
    gl.BufferData(target, static_cast<GLsizeiptr>(words_ * sizeof(Word)), zeros.data(), GL_DYNAMIC_COPY);
    context.check("a buffer");
}

void Buffer::write(std::size_t first, std::span<const Word> words) {
    const internal::Functions& gl = handle_.device().context().use();
    gl.BindBuffer(target, handle_.name());
    gl.BufferSubData(target, static_cast<GLintptr>(first * sizeof(Word)),
                     static_cast<GLsizeiptr>(words.size_bytes()), words.data());
    handle_.device().context().check("writing a buffer");
}

std::vector<Word> Buffer::read() const {
    const internal::Functions& gl = handle_.device().context().use();
    gl.BindBuffer(target, handle_.name());
    const auto bytes = static_cast<GLsizeiptr>(words_ * sizeof(Word));
    const void* const mapped = gl.MapBufferRange(target, 0, bytes, GL_MAP_READ_BIT);
    handle_.device().context().check("reading a buffer");
    if (mapped == nullptr) throw backend::Error("reading a buffer: OpenGL maps no memory");
    const auto* const words = static_cast<const Word*>(mapped);
    std::vector<Word> copy(words, words + words_);
    gl.UnmapBuffer(target);
    return copy;
}

std::size_t channels_of(Image::Format format) {
    return format < Image::Format::rgba16f ? 1 : 4;
}

Image::Image(const Device& device, Format format, std::size_t width, std::size_t height, std::size_t levels)
    : format_(format), width_(width), height_(height), handle_(device, Handle::Kind::texture) {
    const internal::Context& context = device.context();
    const internal::Functions& gl = context.use();
    if (!has_compute(device.info().id.version))
        throw backend::Error(to_string(device.info().id.version) + " has no images");
    gl.BindTexture(GL_TEXTURE_2D, handle_.name());
    gl.TexStorage2D(GL_TEXTURE_2D, static_cast<GLsizei>(levels), internal::format_of(format),
                    static_cast<GLsizei>(width), static_cast<GLsizei>(height));
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    context.check("an image");
    write(std::vector<float>(width * height * channels_of(format)));
}

void Image::write(std::span<const float> channels) {
    if (channels.size() != width_ * height_ * channels_of(format_))
        throw std::invalid_argument("an image has one number for each channel of each texel");
    const internal::Functions& gl = handle_.device().context().use();
    gl.BindTexture(GL_TEXTURE_2D, handle_.name());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    const bool whole = format_ == Format::r32ui;
    const GLenum one = whole ? GL_RED_INTEGER : GL_RED;
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_),
                     channels_of(format_) == 1 ? one : GL_RGBA, whole ? GL_UNSIGNED_INT : GL_FLOAT,
                     channels.data());
    handle_.device().context().check("writing an image");
}

std::vector<float> Image::read() const {
    const internal::Functions& gl = handle_.device().context().use();
    std::vector<float> texels(width_ * height_ * 4);
    GLuint framebuffer = 0;
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, handle_.name(), 0);
    gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl.ReadPixels(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_), GL_RGBA, GL_FLOAT,
                  texels.data());
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl.DeleteFramebuffers(1, &framebuffer);
    handle_.device().context().check("reading an image");
    return texels;
}

WordTexture::WordTexture(const Device& device, std::span<const Word> words)
    : handle_(device, Handle::Kind::texture) {
    if (words.size() > most_words(device.info()))
        throw std::invalid_argument("more words than a texture of this device holds");
    const std::size_t height = std::max<std::size_t>((words.size() + row - 1) / row, 1);
    std::vector<Word> texels(words.begin(), words.end());
    texels.resize(row * height);
    const internal::Context& context = device.context();
    const internal::Functions& gl = context.use();
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, handle_.name());
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32UI, static_cast<GLsizei>(row), static_cast<GLsizei>(height), 0,
                  GL_RED_INTEGER, GL_UNSIGNED_INT, texels.data());
    context.check("a texture");
}

}  // namespace gloam::gl
