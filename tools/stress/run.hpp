// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "check/lab.hpp"
#include "effect/methods.hpp"
#include "scene/pass_library.hpp"
#include "stress/row.hpp"

namespace gloam::stress {

// How much a run does: brief is for tests (seconds), full takes minutes.
enum class Extent { brief, full };

// What a run works with. The lab's include roots hold the shader library, tools/stress/shaders and the folder
// of effect::MethodFunctions.
struct Context {
    const check::Lab& lab;
    const scene::PassLibrary& passes;
    Extent extent = Extent::full;
    std::uint64_t seed = 1;
    std::uint64_t frames = 1'000'000;  // of the long runs
    std::vector<std::string>
        equations;  // whose worst inputs are searched: IDs or functions, shell globs; none: all
    std::vector<std::string> methods;  // whose passes and gathers are tried; none: all
    std::function<void(const std::string&)> progress = [](const std::string&) {};  // told what is done now
};

// Those that the context names. Throws like effect::method_named().
[[nodiscard]] std::vector<effect::MethodInfo> methods_of(const Context& context);

// One way to stress the library. `go` throws what the gpu, check and effect rooms throw.
struct Run {
    std::string name;         // one word, "long-run"
    std::string description;  // one line
    Rows (*go)(const Context&) = nullptr;
};

// All runs in the order they are made. Another way to stress the library is another line in run.cpp.
[[nodiscard]] std::vector<Run> all_runs();

// The run of that name, or all of them for an empty one. Throws std::invalid_argument that lists the names.
[[nodiscard]] std::vector<Run> select_runs(const std::string& name);

}  // namespace gloam::stress
