// SPDX-License-Identifier: MIT
#include "gl/buffer.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "gl/internal/context.hpp"

namespace gloam::gl {
namespace {

// Every version has this target, and nothing else uses it.
constexpr GLenum target = GL_COPY_WRITE_BUFFER;

}  // namespace

Buffer::Buffer(const Device& device, std::size_t words)
    : device_(&device), words_(std::max<std::size_t>(words, 1)) {
    const internal::Context& context = device.context();
    const internal::Functions& gl = context.use();
    const std::vector<Word> zeros(words_);
    gl.GenBuffers(1, &handle_);
    gl.BindBuffer(target, handle_);
    gl.BufferData(target, static_cast<GLsizeiptr>(words_ * sizeof(Word)), zeros.data(), GL_DYNAMIC_COPY);
    try {
        context.check("a buffer");
    } catch (...) {
        gl.DeleteBuffers(1, &handle_);
        throw;
    }
}

Buffer::~Buffer() {
    if (handle_ != 0) device_->context().use().DeleteBuffers(1, &handle_);
}

Buffer::Buffer(Buffer&& other) noexcept
    : device_(other.device_), words_(other.words_), handle_(std::exchange(other.handle_, 0U)) {}

void Buffer::write(std::size_t first, std::span<const Word> words) {
    if (first > words_ || words.size() > words_ - first)
        throw std::invalid_argument("words behind the end of a buffer");
    const internal::Functions& gl = device_->context().use();
    gl.BindBuffer(target, handle_);
    gl.BufferSubData(target, static_cast<GLintptr>(first * sizeof(Word)),
                     static_cast<GLsizeiptr>(words.size_bytes()), words.data());
    device_->context().check("writing a buffer");
}

std::vector<Word> Buffer::read() const {
    const internal::Functions& gl = device_->context().use();
    gl.BindBuffer(target, handle_);
    const auto bytes = static_cast<GLsizeiptr>(words_ * sizeof(Word));
    const void* const mapped = gl.MapBufferRange(target, 0, bytes, GL_MAP_READ_BIT);
    device_->context().check("reading a buffer");
    if (mapped == nullptr) throw CallFailed("reading a buffer: OpenGL maps no memory");
    const auto* const words = static_cast<const Word*>(mapped);
    std::vector<Word> copy(words, words + words_);
    gl.UnmapBuffer(target);
    return copy;
}

}  // namespace gloam::gl
