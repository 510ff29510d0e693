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

Handle::Handle(const Device& device, Kind kind) : device_(&device), kind_(kind) {
    refuse();
}

Handle::~Handle() = default;

Program::Program(const Device& device, Stage /*stage*/, const ShaderText& /*shader*/)
    : handle_(device, Handle::Kind::program) {}

Buffer::Buffer(const Device& device, std::size_t words)
    : words_(words), handle_(device, Handle::Kind::buffer) {}

void Buffer::write(std::size_t /*first*/, std::span<const Word> /*words*/) {
    refuse();
}

std::vector<Word> Buffer::read() const {
    refuse();
}

SampledTexture::SampledTexture(const Device& device, std::span<const Word> /*words*/)
    : target_(0), handle_(device, Handle::Kind::texture) {}

void SampledTexture::bind(std::uint32_t /*unit*/) const {
    refuse();
}

WordTexture::WordTexture(const Device& device, std::span<const Word> /*words*/)
    : handle_(device, Handle::Kind::texture) {}

Image::Image(const Device& device, Format format, std::size_t width, std::size_t height,
             std::size_t /*levels*/)
    : format_(format), width_(width), height_(height), handle_(device, Handle::Kind::texture) {}

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
