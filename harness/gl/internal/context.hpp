// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "gl/device_name.hpp"
#include "gl/internal/display.hpp"
#include "gl/internal/functions.hpp"

namespace gloam::gl::internal {

// A context and the functions of its version.
struct Context {
    // Throws Unavailable, VersionRefused.
    explicit Context(const DeviceName& name);
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    // Other devices of this thread may be current: to be called before OpenGL is. Throws CallFailed.
    const Functions& use() const;

    // Throws OutOfMemory, CallFailed when a call since the last check failed. `what`: was done meanwhile.
    void check(const std::string& what) const;

    [[nodiscard]] std::string text(GLenum what) const;
    [[nodiscard]] GLint integer(GLenum what) const;

    std::shared_ptr<Display> display;
    EGLContext handle = EGL_NO_CONTEXT;
    Functions functions;
    GLuint vertex_array = 0;  // draws need one in the core profile
};

}  // namespace gloam::gl::internal
