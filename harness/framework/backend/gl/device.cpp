// SPDX-License-Identifier: MIT
#include "backend/gl/device.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>
#include <mutex>

#include "backend/gl/internal/context.hpp"
#include "backend/shader_cache.hpp"

namespace gloam::backend::gl::internal {
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

// An environment variable with another value, until the object dies.
class Variable {
  public:
    Variable(const char* name, const std::string& value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        ::setenv(name, value.c_str(), 1);
    }
    ~Variable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* name_;
    std::optional<std::string> before_;
};

EGLDisplay platform_display(const Egl& egl) {
    const char* extensions = egl.QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    const std::string all = fmt::format(" {} ", extensions == nullptr ? "" : extensions);
    if (all.find(" EGL_MESA_platform_surfaceless ") == std::string::npos)
        throw Unavailable("OpenGL devices are not available: EGL has no EGL_MESA_platform_surfaceless");
    void* const usual = EGL_DEFAULT_DISPLAY;
    const EGLDisplay display = egl.GetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, usual, nullptr);
    if (display == EGL_NO_DISPLAY)
        throw Unavailable("OpenGL devices are not available: EGL opens no display without a window");
    return display;
}

void initialize(const Egl& egl, EGLDisplay display, const std::string& executor) {
    std::optional<Variable> software;
    std::optional<Variable> driver;
    if (executor != "system") {
        software.emplace("LIBGL_ALWAYS_SOFTWARE", "1");
        driver.emplace("GALLIUM_DRIVER", executor);
    }
    backend::spare_a_full_disk();
    if (egl.Initialize(display, nullptr, nullptr) == EGL_FALSE) {
        throw Unavailable(fmt::format(
            "OpenGL devices are not available: eglInitialize gives 0x{:x} (libegl-mesa0, libgl1-mesa-dri)",
            egl.GetError()));
    }
}

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

// `whose`: for a message.
template <class Function>
void load(const Egl& egl, Function& function, const char* name, const std::string& whose) {
    function = reinterpret_cast<Function>(egl.GetProcAddress(name));
    if (function == nullptr) throw Unavailable(fmt::format("{} has no {}", whose, name));
}

Functions functions_of(const Egl& egl, const Version& version) {
    Functions functions;
#define GLOAM_GL_LOAD(name) load(egl, functions.name, "gl" #name, "the driver of OpenGL");
    GLOAM_GL_FUNCTIONS(GLOAM_GL_LOAD)
    if (has_compute(version)) {
        GLOAM_GL_COMPUTE_FUNCTIONS(GLOAM_GL_LOAD)
    }
#undef GLOAM_GL_LOAD
    return functions;
}

}  // namespace

Egl::Egl() : library_(open_library()) {
    const std::string whose = fmt::format("OpenGL devices are not available: {}", library_name);
    GetProcAddress = reinterpret_cast<decltype(GetProcAddress)>(::dlsym(library_.get(), "eglGetProcAddress"));
    if (GetProcAddress == nullptr) throw Unavailable(whose + " is no EGL library");
#define GLOAM_EGL_LOAD(name) load(*this, name, "egl" #name, whose);
    GLOAM_EGL_FUNCTIONS(GLOAM_EGL_LOAD)
#undef GLOAM_EGL_LOAD
    load(*this, GetPlatformDisplayEXT, "eglGetPlatformDisplayEXT", whose);
}

std::shared_ptr<Display> Display::open(const std::string& executor) {
    // EGL itself has one such display for the process.
    static std::mutex mutex;
    static std::weak_ptr<Display> current;
    const std::scoped_lock lock(mutex);
    std::shared_ptr<Display> display = current.lock();
    if (display && display->executor() != executor) {
        throw Unavailable(
            fmt::format("the display of this process runs {}: close its devices before one of {}",
                        display->executor(), executor));
    }
    if (!display) current = display = std::make_shared<Display>(executor);
    return display;
}

Display::Display(const std::string& executor) : handle_(platform_display(egl_)), executor_(executor) {
    initialize(egl_, handle_, executor);
}

Display::~Display() {
    egl_.Terminate(handle_);
}

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
        throw backend::Error(fmt::format(
            "a context of OpenGL cannot be used here: eglMakeCurrent gives 0x{:x}", egl.GetError()));
    }
    return functions;
}

void Context::check(const std::string& what) const {
    const GLenum error = functions.GetError();
    if (error == GL_NO_ERROR) return;
    if (error == GL_OUT_OF_MEMORY) throw backend::OutOfMemory(what + ": OpenGL has not enough memory");
    throw backend::Error(fmt::format("{}: OpenGL error 0x{:04x}", what, error));
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

}  // namespace gloam::backend::gl::internal

namespace gloam::backend::gl {
namespace {

using internal::Context;

DeviceName required_name(const std::string& text) {
    const auto name = device_name_from(text);
    if (name) return *name;
    throw std::invalid_argument(fmt::format(
        "no OpenGL device \"{}\": expected gl: or es:, then system, llvmpipe or softpipe, then a version: "
        "gl:llvmpipe-4.5, es:system-3.1",
        text));
}

std::uint32_t limit(const internal::Context& context, GLenum what) {
    return static_cast<std::uint32_t>(std::max(context.integer(what), 0));
}

DeviceInfo describe(const internal::Context& context, const DeviceName& name) {
    DeviceInfo info;
    info.id = name;
    info.name = to_string(name);
    info.type = name.version.api == Api::gl ? "opengl" : "opengl es";
    info.renderer = context.text(GL_RENDERER);
    info.driver = context.text(GL_VENDOR) + " " + info.renderer + ", " + context.text(GL_VERSION);
    info.api_version = to_string(name.version);
    info.glsl = glsl_of(name.version);
    info.max_image_size = limit(context, GL_MAX_TEXTURE_SIZE);
    if (has_compute(name.version)) {
        GLint64 bytes = 0;
        context.functions.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
        info.max_buffer_bytes = static_cast<std::uint64_t>(std::max<GLint64>(bytes, 0));
        info.max_storage_blocks = limit(context, GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS);
    }
    return info;
}

bool runs(const DeviceInfo& info, const std::string& executor) {
    return info.renderer.find(executor) != std::string::npos;
}

}  // namespace

Device::Device(const std::string& name)
    : context_(base::make_hidden<internal::Context>(required_name(name))) {
    const DeviceName wanted = required_name(name);
    info_ = describe(*context_, wanted);
    if (wanted.executor != "system" && !runs(info_, wanted.executor)) {
        throw Unavailable(fmt::format("{}: OpenGL is executed by \"{}\", not by {}", name, info_.renderer,
                                      wanted.executor));
    }
    context_->check("opening " + name);
}

std::vector<DeviceInfo> list_devices(const std::string& executor) {
    std::vector<DeviceInfo> devices;
    for (const Version& version : versions()) {
        try {
            devices.push_back(Device(to_string(DeviceName{executor, version})).info());
        } catch (const VersionRefused&) {
            continue;
        }
    }
    const auto is_other = [&](const DeviceInfo& info) {
        return std::ranges::any_of(executors(), [&](const auto& other) { return runs(info, other); });
    };
    if (executor == "system") std::erase_if(devices, is_other);
    return devices;
}

}  // namespace gloam::backend::gl
