// SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl32.h>
#include <memory>
#include <string>

#include "backend/gl/device.hpp"

namespace gloam::backend::gl::internal {

// The EGL library of this machine, opened at run time. Throws Unavailable.
class Egl {
  public:
    Egl();

    decltype(&::eglGetProcAddress) GetProcAddress = nullptr;
    // clang-format off
#define GLOAM_EGL_FUNCTIONS(X)                                                              \
    X(QueryString) X(Initialize) X(Terminate) X(BindAPI) X(CreateContext) X(DestroyContext) \
    X(MakeCurrent) X(GetCurrentContext) X(GetError)
// clang-format on
#define GLOAM_EGL_MEMBER(name) decltype(&::egl##name) name = nullptr;
    GLOAM_EGL_FUNCTIONS(GLOAM_EGL_MEMBER)
#undef GLOAM_EGL_MEMBER
    PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplayEXT = nullptr;

  private:
    std::shared_ptr<void> library_;
};

// An EGL display without a window. EGL has one for a process; it is closed with its last owner.
class Display {
  public:
    // The display that runs this executor. Throws Unavailable, also while the process has one of another
    // executor open.
    [[nodiscard]] static std::shared_ptr<Display> open(const std::string& executor);

    explicit Display(const std::string& executor);
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    [[nodiscard]] const Egl& egl() const { return egl_; }
    [[nodiscard]] EGLDisplay handle() const { return handle_; }
    [[nodiscard]] const std::string& executor() const { return executor_; }

  private:
    Egl egl_;
    EGLDisplay handle_ = EGL_NO_DISPLAY;
    std::string executor_;
};

}  // namespace gloam::backend::gl::internal

// The functions of OpenGL that this room calls. The versions of OpenGL and OpenGL ES that it opens all have
// those of the first list, with the same signatures; those of the second come with compute shaders.
// clang-format off
#define GLOAM_GL_FUNCTIONS(X)                                                                             \
    X(ActiveTexture) X(AttachShader) X(BindBuffer) X(BindBufferBase) X(BindFramebuffer) X(BindTexture)    \
    X(BindVertexArray) X(BufferData) X(CheckFramebufferStatus) X(CompileShader)          \
    X(CreateProgram) X(CreateShader) X(DeleteBuffers) X(DeleteFramebuffers) X(DeleteProgram)              \
    X(DeleteShader) X(DeleteTextures) X(DeleteVertexArrays) X(Disable) X(DrawArrays) X(DrawBuffers) X(Enable) \
    X(Finish) X(FramebufferTexture2D) X(GenBuffers) X(GenFramebuffers) X(GenTextures)                     \
    X(GenVertexArrays) X(GetError) X(GetInteger64v) X(GetIntegerv) X(GetProgramInfoLog) X(GetProgramiv)   \
    X(GetShaderInfoLog) X(GetShaderiv) X(GetString) X(GetUniformLocation) X(LinkProgram)                  \
    X(MapBufferRange) X(PixelStorei) X(ReadBuffer) X(ReadPixels) X(ShaderSource) X(TexImage2D)            \
    X(TexParameteri) X(TexSubImage2D) X(Uniform1i) X(Uniform1ui) X(UnmapBuffer) X(UseProgram) X(Viewport)
#define GLOAM_GL_COMPUTE_FUNCTIONS(X)                                                                    \
    X(BindImageTexture) X(DispatchCompute) X(MemoryBarrier) X(TexStorage2D) X(TexStorage3D) X(TexSubImage3D)
// clang-format on

namespace gloam::backend::gl::internal {

struct Functions {
#define GLOAM_GL_MEMBER(name) decltype(&::gl##name) name = nullptr;
    GLOAM_GL_FUNCTIONS(GLOAM_GL_MEMBER)
    GLOAM_GL_COMPUTE_FUNCTIONS(GLOAM_GL_MEMBER)
#undef GLOAM_GL_MEMBER
};

// A context and the functions of its version.
struct Context {
    // Throws Unavailable.
    explicit Context(const DeviceName& name);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    // Other devices of this thread may be current: to be called before OpenGL is. Throws backend::Error.
    const Functions& use() const;

    // Throws backend::Error when a call since the last check failed. `what`: was done meanwhile.
    void check(const std::string& what) const;

    [[nodiscard]] std::string text(GLenum what) const;
    [[nodiscard]] GLint integer(GLenum what) const;

    std::shared_ptr<Display> display;
    EGLContext handle = EGL_NO_CONTEXT;
    Functions functions;
    GLuint vertex_array = 0;  // draws need one in the core profile
};

}  // namespace gloam::backend::gl::internal
