// SPDX-License-Identifier: MIT
#include "gl/internal/context.hpp"

#include <fmt/format.h>

#include <vector>

#include "gl/errors.hpp"

namespace gloam::gl::internal {
namespace {

EGLContext create(const Display& display, const DeviceName& name) {
    const Egl& egl = display.egl();
    const bool es = name.version.api == Api::es;
    egl.BindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
    std::vector<EGLint> wanted{EGL_CONTEXT_MAJOR_VERSION, name.version.major, EGL_CONTEXT_MINOR_VERSION,
                               name.version.minor};
    if (!es) {
        wanted.push_back(EGL_CONTEXT_OPENGL_PROFILE_MASK);
        wanted.push_back(EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT);
    }
    wanted.push_back(EGL_NONE);
    const EGLContext context =
        egl.CreateContext(display.handle(), EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted.data());
    if (context == EGL_NO_CONTEXT) {
        throw VersionRefused(fmt::format("{}: the driver makes no context of {} (EGL error 0x{:x})",
                                         to_string(name), to_string(name.version), egl.GetError()));
    }
    return context;
}

template <class Function>
void load(const Egl& egl, Function& function, const char* name) {
    function = reinterpret_cast<Function>(egl.GetProcAddress(name));
    if (function == nullptr) throw Unavailable(fmt::format("the driver of OpenGL has no {}", name));
}

Functions functions_of(const Egl& egl, const Version& version) {
    Functions functions;
#define GLOAM_GL_LOAD(name) load(egl, functions.name, "gl" #name);
    GLOAM_GL_FUNCTIONS(GLOAM_GL_LOAD)
    if (has_compute(version)) {
        GLOAM_GL_COMPUTE_FUNCTIONS(GLOAM_GL_LOAD)
    }
#undef GLOAM_GL_LOAD
    return functions;
}

}  // namespace

Context::Context(const DeviceName& name)
    : display(Display::open(name.executor)), handle(create(*display, name)) {
    try {
        functions = functions_of(display->egl(), name.version);
        use().GenVertexArrays(1, &vertex_array);
    } catch (...) {
        display->egl().DestroyContext(display->handle(), handle);
        throw;
    }
}

Context::~Context() {
    const Egl& egl = display->egl();
    if (egl.GetCurrentContext() == handle)
        egl.MakeCurrent(display->handle(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl.DestroyContext(display->handle(), handle);
}

const Functions& Context::use() const {
    const Egl& egl = display->egl();
    if (egl.GetCurrentContext() != handle &&
        egl.MakeCurrent(display->handle(), EGL_NO_SURFACE, EGL_NO_SURFACE, handle) == EGL_FALSE) {
        throw CallFailed(fmt::format("a context of OpenGL cannot be used here: eglMakeCurrent gives 0x{:x}",
                                     egl.GetError()));
    }
    return functions;
}

void Context::check(const std::string& what) const {
    const GLenum error = functions.GetError();
    if (error == GL_NO_ERROR) return;
    if (error == GL_OUT_OF_MEMORY) throw OutOfMemory(what + ": OpenGL has not enough memory");
    throw CallFailed(fmt::format("{}: OpenGL error 0x{:04x}", what, error));
}

std::string Context::text(GLenum what) const {
    const GLubyte* text = functions.GetString(what);
    return text == nullptr ? "" : reinterpret_cast<const char*>(text);
}

GLint Context::integer(GLenum what) const {
    GLint value = 0;
    functions.GetIntegerv(what, &value);
    return value;
}

}  // namespace gloam::gl::internal
