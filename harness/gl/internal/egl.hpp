// SPDX-License-Identifier: MIT
#pragma once

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <memory>

namespace gloam::gl::internal {

// The EGL library of this machine, opened at run time. Throws Unavailable.
class Egl {
  public:
    Egl();

    decltype(&::eglGetProcAddress) GetProcAddress = nullptr;
    decltype(&::eglQueryString) QueryString = nullptr;
    decltype(&::eglInitialize) Initialize = nullptr;
    decltype(&::eglTerminate) Terminate = nullptr;
    decltype(&::eglBindAPI) BindAPI = nullptr;
    decltype(&::eglCreateContext) CreateContext = nullptr;
    decltype(&::eglDestroyContext) DestroyContext = nullptr;
    decltype(&::eglMakeCurrent) MakeCurrent = nullptr;
    decltype(&::eglGetCurrentContext) GetCurrentContext = nullptr;
    decltype(&::eglGetError) GetError = nullptr;
    PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplayEXT = nullptr;

  private:
    template <class Function>
    void load(Function& function, const char* name);

    std::shared_ptr<void> library_;
};

}  // namespace gloam::gl::internal
