// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace gloam::gl {

// What went wrong with OpenGL, in one line.
class Error : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// There is no EGL library, no display without a window, or no such software renderer.
class Unavailable : public Error {
    using Error::Error;
};

// The driver makes no context of the version that was asked for.
class VersionRefused : public Error {
    using Error::Error;
};

// The driver rejected a shader: "NAME: line 12: its message [the text of that line]".
class CompileFailed : public Error {
    using Error::Error;
};

// The driver rejected a program whose shaders it had compiled.
class LinkFailed : public Error {
    using Error::Error;
};

// The driver has not enough memory.
class OutOfMemory : public Error {
    using Error::Error;
};

// Any other error that a call set.
class CallFailed : public Error {
    using Error::Error;
};

}  // namespace gloam::gl
