// SPDX-License-Identifier: MIT
#include "gl/dispatch.hpp"

#include "gl/internal/context.hpp"

namespace gloam::gl {

void dispatch(const Device& device, const Dispatch& work) {
    const internal::Context& context = device.context();
    const internal::Functions& gl = context.use();
    if (!has_compute(device.info().name.version))
        throw CallFailed(to_string(device.info().name.version) + " has no compute shaders");
    gl.UseProgram(work.program.handle());
    for (std::size_t i = 0; i < work.storage.size(); ++i)
        gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(i), work.storage[i].get().handle());
    gl.BindBufferBase(GL_UNIFORM_BUFFER, work.uniform_binding, work.uniforms.handle());
    gl.DispatchCompute(work.groups, 1, 1);
    gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    gl.Finish();
    context.check("a compute shader");
}

}  // namespace gloam::gl
