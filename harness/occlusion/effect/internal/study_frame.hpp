// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "effect/internal/executor.hpp"
#include "effect/plan.hpp"

namespace gloam::effect {

// The one description of the study's frame: a table of its passes, and what they read and write.

// A plan without passes: the images and buffers of all frames with these settings and views of this size.
[[nodiscard]] Plan planned_resources(const Moment& moment);

// The passes of one frame, in their order: pass_table() evaluated. resources: those that exist; a pass gets
// nothing_image in the place of others. The table names what a resource is to the frame:
// `depth`, for example, is the depth that the passes read, and `history` the one that the samples enter. Both
// sets of parameters are those of this frame. interface_of: of the module of a source; its push constants and
// specialization constants are set by their names. Throws std::logic_error for a name without a value.
[[nodiscard]] std::vector<PlannedPass> planned_passes(Moment moment, const Plan& resources,
                                                      const InterfaceOf& interface_of);

// A view in the place of the engine's.
[[nodiscard]] View view_of(const PlanOptions& options);

// A pass. Resources are named by what they are to the frame: see planned_passes().
struct PassRow {
    const char* name;
    std::function<std::size_t(const Moment&)> when;  // how many times it runs; Moment::step counts them
    std::function<PassSource(const Moment&)> source;
    std::vector<const char*> resources;  // at binding 0, 1, ...
    std::vector<std::pair<const char*, std::function<double(const Moment&)>>> own = {};  // values, by name
    std::function<std::array<std::uint32_t, 3>(const Moment&)> groups = {};
    std::function<std::string(const Moment&)> own_name = {};  // in the place of `name`
};

// The passes of a frame in their order.
[[nodiscard]] const std::vector<PassRow>& pass_table();

}  // namespace gloam::effect
