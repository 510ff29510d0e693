// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gloam::base {

// The reason why a check has no result, or an unreliable one.
enum class Reason {
    none,           // it ran to its end
    crash,          // the process that ran it exited or was ended by a signal
    hang,           // the time limit passed
    device_lost,    // the device was lost
    out_of_memory,  // of the host or of the device
    error,          // any other error, for example a shader that does not compile
    fault,          // the shader accessed a pixel outside an image
    race,           // two invocations of a group use one word, no barrier orders them, and one writes
    divergent,      // not all invocations of a group reach a barrier
    unsupported,    // the function is no text of the device's version of GLSL: not judged
    unchanged       // the variant's steps left the module as it was: not judged
};
inline constexpr std::array<std::string_view, 11> reason_names{
    "",         "crash", "hang", "device lost",       "out of memory",
    "error",    "fault", "race", "divergent barrier", "unsupported",
    "unchanged"};
[[nodiscard]] constexpr std::string_view name_of(Reason reason) {
    return reason_names.at(static_cast<std::size_t>(reason));
}

// Whether a check for this reason says nothing for or against the device.
[[nodiscard]] constexpr bool is_no_verdict(Reason reason) {
    return reason == Reason::unsupported || reason == Reason::unchanged;
}

// An error that says why there is no result, so that nobody has to know its type.
class Failure : public std::runtime_error {
  public:
    explicit Failure(const std::string& message, Reason why = Reason::error)
        : std::runtime_error(message), reason(why) {}
    Reason reason;
};

[[nodiscard]] inline Reason reason_of(const std::exception& error) {
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return Reason::out_of_memory;
    const auto* failure = dynamic_cast<const Failure*>(&error);
    return failure == nullptr ? Reason::error : failure->reason;
}

}  // namespace gloam::base
