// SPDX-License-Identifier: MIT
// The room of a build without the headers of EGL and OpenGL ES: it has no devices.
#include "backend/gl/device.hpp"
#include "backend/gl/program.hpp"

namespace gloam::gl {

namespace internal {
struct Context {};
}  // namespace internal

namespace {

[[noreturn]] void refuse() {
    throw Unavailable(
        "OpenGL devices are not available: gloam was built without the headers of EGL and OpenGL ES "
        "(libegl-dev, libgles-dev)");
}

}  // namespace

Device::Device(const std::string& /*name*/) {
    refuse();
}

Device::~Device() = default;

std::vector<DeviceInfo> list_devices(const std::string& /*executor*/) {
    refuse();
}

Program::Program(const Device& device, Stage /*stage*/, const ShaderText& /*shader*/) : device_(&device) {
    refuse();
}

Program::~Program() = default;
Program::Program(Program&&) noexcept = default;

Buffer::Buffer(const Device& device, std::size_t /*words*/) : device_(&device) {
    refuse();
}

Buffer::~Buffer() = default;
Buffer::Buffer(Buffer&&) noexcept = default;

void Buffer::write(std::size_t /*first*/, std::span<const Word> /*words*/) {
    refuse();
}

std::vector<Word> Buffer::read() const {
    refuse();
}

SampledTexture::SampledTexture(const Device& device, std::span<const Word> /*words*/) : device_(&device) {
    refuse();
}

SampledTexture::~SampledTexture() = default;
SampledTexture::SampledTexture(SampledTexture&&) noexcept = default;

void SampledTexture::bind(std::uint32_t /*unit*/) const {
    refuse();
}

WordTexture::WordTexture(const Device& device, std::span<const Word> /*words*/) : device_(&device) {
    refuse();
}

WordTexture::~WordTexture() = default;
WordTexture::WordTexture(WordTexture&&) noexcept = default;

Image::Image(const Device& device, Format format, std::size_t width, std::size_t height)
    : device_(&device), format_(format), width_(width), height_(height) {
    refuse();
}

Image::~Image() = default;
Image::Image(Image&&) noexcept = default;

void Image::write(std::span<const float> /*channels*/) {
    refuse();
}

std::vector<float> Image::read() const {
    refuse();
}

void dispatch(const Device& /*device*/, const Dispatch& /*work*/) {
    refuse();
}

void dispatch(const Device& /*device*/, const ImageDispatch& /*work*/) {
    refuse();
}

std::vector<std::vector<Word>> draw(const Device& /*device*/, const Draw& /*work*/) {
    refuse();
}

}  // namespace gloam::gl
