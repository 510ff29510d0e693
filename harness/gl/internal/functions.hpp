// SPDX-License-Identifier: MIT
#pragma once

#include <GLES3/gl32.h>

// The functions of OpenGL that this room calls. The versions of OpenGL and OpenGL ES that it opens all have
// those of the first list, with the same signatures; those of the second come with compute shaders.
// clang-format off
#define GLOAM_GL_FUNCTIONS(X)                                                                             \
    X(ActiveTexture) X(AttachShader) X(BindBuffer) X(BindBufferBase) X(BindFramebuffer) X(BindTexture)    \
    X(BindVertexArray) X(BufferData) X(BufferSubData) X(CheckFramebufferStatus) X(CompileShader)          \
    X(CreateProgram) X(CreateShader) X(DeleteBuffers) X(DeleteFramebuffers) X(DeleteProgram)              \
    X(DeleteShader) X(DeleteTextures) X(DeleteVertexArrays) X(Disable) X(DrawArrays) X(DrawBuffers)       \
    X(Finish) X(FramebufferTexture2D) X(GenBuffers) X(GenFramebuffers) X(GenTextures)                     \
    X(GenVertexArrays) X(GetError) X(GetInteger64v) X(GetIntegerv) X(GetProgramInfoLog) X(GetProgramiv)   \
    X(GetShaderInfoLog) X(GetShaderiv) X(GetString) X(GetUniformLocation) X(LinkProgram)                  \
    X(MapBufferRange) X(PixelStorei) X(ReadBuffer) X(ReadPixels) X(ShaderSource) X(TexImage2D)            \
    X(TexParameteri) X(TexSubImage2D) X(Uniform1i) X(Uniform1ui) X(UnmapBuffer) X(UseProgram) X(Viewport)
#define GLOAM_GL_COMPUTE_FUNCTIONS(X) X(BindImageTexture) X(DispatchCompute) X(MemoryBarrier) X(TexStorage2D)
// clang-format on

namespace gloam::gl::internal {

struct Functions {
#define GLOAM_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
    GLOAM_GL_FUNCTIONS(GLOAM_GL_MEMBER)
    GLOAM_GL_COMPUTE_FUNCTIONS(GLOAM_GL_MEMBER)
#undef GLOAM_GL_MEMBER
};

}  // namespace gloam::gl::internal
