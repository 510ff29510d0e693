// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>

#include "base/process.hpp"

namespace gloam::base {

// Of compilers of texts from elsewhere: far beyond the needs of any reasonable shader.
inline const ProcessLimits compiler_limits{.memory_bytes = std::uint64_t{3} << 30,
                                           .cpu = std::chrono::seconds(60),
                                           .patience = std::chrono::minutes(5)};

// Tries what a compiler is to do with a text in a copy of this process. Throws LimitError, "NAME: the
// compiler takes more than 60 s", if the copy does not survive it.
void try_compiler(const std::filesystem::path& name, const std::function<void()>& work);

// The result of the work, which is tried first.
template <class Work>
auto tried(const std::filesystem::path& name, const Work& work) {
    try_compiler(name, [&work] { (void)work(); });
    return work();
}

}  // namespace gloam::base
