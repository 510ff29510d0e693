// SPDX-License-Identifier: MIT
#include "gl/dispatch.hpp"

#include "gl/internal/context.hpp"
#include "gl/internal/image_format.hpp"

namespace gloam::gl {
namespace {

void require_compute(const Device& device) {
    if (!has_compute(device.info().name.version))
        throw CallFailed(to_string(device.info().name.version) + " has no compute shaders");
}

}  // namespace

void dispatch(const Device& device, const Dispatch& work) {
    const internal::Context& context = device.context();
    const internal::Functions& gl = context.use();
    require_compute(device);
    gl.UseProgram(work.program.handle());
    for (std::size_t i = 0; i < work.storage.size(); ++i)
        gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(i), work.storage[i].get().handle());
    gl.BindBufferBase(GL_UNIFORM_BUFFER, work.uniform_binding, work.uniforms.handle());
    gl.DispatchCompute(work.groups, 1, 1);
    gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    gl.Finish();
    context.check("a compute shader");
}

void dispatch(const Device& device, const ImageDispatch& work) {
    const internal::Context& context = device.context();
    const internal::Functions& gl = context.use();
    require_compute(device);
    gl.UseProgram(work.program.handle());
    for (const auto& [binding, image] : work.images) {
        gl.BindImageTexture(binding, image.get().handle(), 0, GL_FALSE, 0, GL_READ_WRITE,
                            internal::format_of(image.get().format()));
        gl.ActiveTexture(GL_TEXTURE0 + binding);
        gl.BindTexture(GL_TEXTURE_2D, image.get().handle());
    }
    gl.ActiveTexture(GL_TEXTURE0);
    for (const auto& [binding, buffer] : work.storage)
        gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer.get().handle());
    for (const auto& [binding, buffer] : work.uniforms)
        gl.BindBufferBase(GL_UNIFORM_BUFFER, binding, buffer.get().handle());
    gl.DispatchCompute(work.groups[0], work.groups[1], work.groups[2]);
    gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
    gl.Finish();
    context.check("a compute shader over images");
}

}  // namespace gloam::gl
