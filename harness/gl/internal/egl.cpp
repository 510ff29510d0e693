// SPDX-License-Identifier: MIT
#include "gl/internal/egl.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <string>

#include "gl/errors.hpp"

namespace gloam::gl::internal {
namespace {

constexpr const char* library_name = "libEGL.so.1";

// Drivers keep threads and memory of their own in the library: it stays where it is until the process ends.
std::shared_ptr<void> open_library() {
    void* library = ::dlopen(library_name, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (library == nullptr) {
        const char* reason = ::dlerror();
        throw Unavailable(fmt::format("OpenGL devices are not available: {} (libegl1)",
                                      reason == nullptr ? "no libEGL.so.1" : reason));
    }
    return {library, [](void* handle) { ::dlclose(handle); }};
}

}  // namespace

template <class Function>
void Egl::load(Function& function, const char* name) {
    function = reinterpret_cast<Function>(GetProcAddress(name));
    if (function == nullptr)
        throw Unavailable(fmt::format("OpenGL devices are not available: {} has no {}", library_name, name));
}

Egl::Egl() : library_(open_library()) {
    GetProcAddress = reinterpret_cast<decltype(GetProcAddress)>(::dlsym(library_.get(), "eglGetProcAddress"));
    if (GetProcAddress == nullptr)
        throw Unavailable(
            fmt::format("OpenGL devices are not available: {} is no EGL library", library_name));
    load(QueryString, "eglQueryString");
    load(Initialize, "eglInitialize");
    load(Terminate, "eglTerminate");
    load(BindAPI, "eglBindAPI");
    load(CreateContext, "eglCreateContext");
    load(DestroyContext, "eglDestroyContext");
    load(MakeCurrent, "eglMakeCurrent");
    load(GetCurrentContext, "eglGetCurrentContext");
    load(GetError, "eglGetError");
    load(GetPlatformDisplayEXT, "eglGetPlatformDisplayEXT");
}

}  // namespace gloam::gl::internal
