// SPDX-License-Identifier: MIT
#include "gl/internal/display.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <mutex>
#include <optional>
#include <string_view>

#include "gl/errors.hpp"

namespace gloam::gl::internal {
namespace {

// An environment variable with another value, until the object dies.
class Variable {
  public:
    Variable(const char* name, const std::string& value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        ::setenv(name, value.c_str(), 1);
    }
    ~Variable() {
        if (before_) {
            ::setenv(name_, before_->c_str(), 1);
        } else {
            ::unsetenv(name_);
        }
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* name_;
    std::optional<std::string> before_;
};

bool has_word(std::string_view list, std::string_view word) {
    for (std::size_t at = list.find(word); at != std::string_view::npos; at = list.find(word, at + 1)) {
        const bool begins = at == 0 || list[at - 1] == ' ';
        const std::size_t end = at + word.size();
        if (begins && (end == list.size() || list[end] == ' ')) return true;
    }
    return false;
}

EGLDisplay platform_display(const Egl& egl) {
    const char* extensions = egl.QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (!has_word(extensions == nullptr ? "" : extensions, "EGL_MESA_platform_surfaceless"))
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
    if (egl.Initialize(display, nullptr, nullptr) == EGL_FALSE) {
        throw Unavailable(fmt::format(
            "OpenGL devices are not available: eglInitialize gives 0x{:x} (libegl-mesa0, libgl1-mesa-dri)",
            egl.GetError()));
    }
}

}  // namespace

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

}  // namespace gloam::gl::internal
