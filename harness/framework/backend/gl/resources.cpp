// SPDX-License-Identifier: MIT
#include "backend/gl/resources.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

#include "backend/gl/internal/context.hpp"
#include "backend/sampled.hpp"

namespace gloam::backend::gl {
namespace {

// Every version has this target, and nothing else uses it.
constexpr GLenum target = GL_COPY_WRITE_BUFFER;

struct ImageFormat {
    std::string_view name;
    GLenum internal;
    std::size_t channels;
    bool integers;
    bool es;  // OpenGL ES has such images, and takes texels of 32 bits a channel
};

constexpr std::array image_formats{
    ImageFormat{"r32f", GL_R32F, 1, false, true},
    ImageFormat{"rgba32f", GL_RGBA32F, 4, false, true},
    ImageFormat{"rgba16f", GL_RGBA16F, 4, false, true},
    ImageFormat{"r32ui", GL_R32UI, 1, true, true},
    ImageFormat{"rgba32ui", GL_RGBA32UI, 4, true, true},
    ImageFormat{"r16f", GL_R16F, 1, false, false},
    ImageFormat{"r8", GL_R8, 1, false, false},
    ImageFormat{"rg32f", GL_RG32F, 2, false, false},
    ImageFormat{"rg16f", GL_RG16F, 2, false, false},
    ImageFormat{"rgba8", GL_RGBA8, 4, false, false},
    ImageFormat{"rg32ui", GL_RG32UI, 2, true, false},
    ImageFormat{"r16ui", GL_R16UI, 1, true, false},
    ImageFormat{"rg16ui", GL_RG16UI, 2, true, false},
    ImageFormat{"rgba16ui", GL_RGBA16UI, 4, true, false},
    ImageFormat{"rgb10_a2", GL_RGB10_A2, 4, false, false},
};

const ImageFormat& format_named(const Device& device, const std::string& name) {
    const Version& version = device.info().id.version;
    const auto found = std::ranges::find(image_formats, name, &ImageFormat::name);
    if (found == image_formats.end() || (version.api == Api::es && !found->es))
        throw backend::Unsupported(to_string(version) + " has no images of format " + name);
    return *found;
}

}  // namespace

Handle::Handle(const Device& device, Kind kind) : device_(&device), kind_(kind) {
    const internal::Functions& gl = device.context().use();
    if (kind == Kind::program) name_ = gl.CreateProgram();
    if (kind == Kind::buffer) gl.GenBuffers(1, &name_);
    if (kind == Kind::texture) gl.GenTextures(1, &name_);
    if (kind == Kind::framebuffer) gl.GenFramebuffers(1, &name_);
}

Handle::~Handle() {
    if (name_ == 0) return;
    const internal::Functions& gl = device_->context().use();
    if (kind_ == Kind::program) gl.DeleteProgram(name_);
    if (kind_ == Kind::buffer) gl.DeleteBuffers(1, &name_);
    if (kind_ == Kind::texture) gl.DeleteTextures(1, &name_);
    if (kind_ == Kind::framebuffer) gl.DeleteFramebuffers(1, &name_);
}

Buffer::Buffer(const Device& device, std::span<const Word> words, std::size_t size)
    : words_(std::max({words.size(), size, std::size_t{1}})), handle_(device, Handle::Kind::buffer) {
    const internal::Context& context = device.context();
    const internal::Functions& gl = context.use();
    std::vector<Word> contents(words.begin(), words.end());
    contents.resize(words_);
    gl.BindBuffer(target, handle_.name());
    gl.BufferData(target, static_cast<GLsizeiptr>(words_ * sizeof(Word)), contents.data(), GL_DYNAMIC_COPY);
    context.check("a buffer");
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

Image::Image(const Device& device, const std::string& format, std::size_t width, std::size_t height,
             std::span<const Word> texels)
    : width_(width), height_(height), handle_(device, Handle::Kind::texture) {
    constexpr std::array<GLenum, 4> floats{GL_RED, GL_RG, GL_RGBA, GL_RGBA};
    constexpr std::array<GLenum, 4> whole{GL_RED_INTEGER, GL_RG_INTEGER, GL_RGBA_INTEGER, GL_RGBA_INTEGER};
    const ImageFormat& known = format_named(device, format);
    format_ = known.internal;
    integers_ = known.integers;
    std::vector<Word> kept;
    for (std::size_t w = 0; w < texels.size(); ++w)
        if (w % backend::texel_words < known.channels) kept.push_back(texels[w]);
    const internal::Context& context = device.context();
    const internal::Functions& gl = context.use();
    gl.BindTexture(GL_TEXTURE_2D, handle_.name());
    gl.TexStorage2D(GL_TEXTURE_2D, 1, format_, static_cast<GLsizei>(width), static_cast<GLsizei>(height));
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, static_cast<GLsizei>(width), static_cast<GLsizei>(height),
                     (integers_ ? whole : floats).at(known.channels - 1),
                     integers_ ? GL_UNSIGNED_INT : GL_FLOAT, kept.data());
    context.check("an image");
}

std::vector<Word> Image::read() const {
    const internal::Functions& gl = handle_.device().context().use();
    std::vector<Word> texels(width_ * height_ * backend::texel_words);
    const Handle framebuffer(handle_.device(), Handle::Kind::framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, handle_.name(), 0);
    gl.ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl.ReadPixels(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_),
                  integers_ ? GL_RGBA_INTEGER : GL_RGBA, integers_ ? GL_UNSIGNED_INT : GL_FLOAT,
                  texels.data());
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

}  // namespace gloam::backend::gl
