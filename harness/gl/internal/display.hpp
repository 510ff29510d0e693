// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "gl/internal/egl.hpp"

namespace gloam::gl::internal {

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

}  // namespace gloam::gl::internal
