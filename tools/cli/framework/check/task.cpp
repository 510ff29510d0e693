// SPDX-License-Identifier: MIT
#include "cli/framework/check/task.hpp"

namespace gloam::cli {

template <class Io>
void members(Io& io, Greeting& greeting) {
    report::each(io, "devices", greeting.devices, "error", greeting.error);
}

std::string to_line(const CheckTask& task) {
    return report::line_of(task);
}

CheckTask task_from(std::string_view line) {
    return report::from_line<CheckTask>(line);
}

std::string to_line(const Greeting& greeting) {
    return report::line_of(greeting);
}

Greeting greeting_from(std::string_view line) {
    return report::from_line<Greeting>(line);
}

}  // namespace gloam::cli
