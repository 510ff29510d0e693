// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "effect/methods.hpp"
#include "scene/pass_library.hpp"
#include "subject/lab.hpp"

namespace gloam::catalogue {
struct Entry;
}

namespace gloam::stress {

// One measured number of a stress run, and the largest value that the documentation allows it.
struct Row {
    std::string run;                // the run that measured it, "long-run"
    std::string varied;             // what was varied: "k 32, w_max 500"
    std::string quantity;           // what was measured, with its unit: "farthest from the exact mean"
    double measured = 0.0;          // NaN only where the quantity does not exist
    std::optional<double> bound{};  // nothing: measured for the documentation only, promised nowhere

    // Written so that NaN breaks a bound.
    [[nodiscard]] bool passed() const { return !bound || measured <= *bound; }
};

using Rows = std::vector<Row>;

inline void append(Rows& rows, const Rows& more) {
    rows.insert(rows.end(), more.begin(), more.end());
}

// The larger of two errors; NaN where one is.
inline double worse(double a, double b) {
    return a >= b || std::isnan(a) ? a : b;
}

// What a run works with. The lab's include roots hold the shader library, tools/stress/shaders and the folder
// of effect::MethodFunctions.
struct Context {
    const check::Lab& lab;
    const scene::PassLibrary& passes;
    bool brief = false;  // seconds, for tests; otherwise it takes minutes
    std::uint64_t seed = 1;
    std::uint64_t frames = 1'000'000;  // of the long runs
    // Whose worst inputs are searched: IDs or functions, shell globs; none: all.
    std::vector<std::string> equations{};
    // Told what is done now, and of rows before the run ends, in their order.
    std::function<void(const std::string&)> progress = [](const std::string&) {};
    std::function<void(const Row&)> found = [](const Row&) {};
    std::vector<effect::MethodInfo> methods = effect::methods();  // whose passes and gathers are tried
};

// For every equation of the catalogue, the worst input that a guided search finds (audit/worst.hpp), as a
// fraction of what its documentation states, beside the worst of its random inputs alone. The search is made
// of the default variant: inputs that break a budget are rows that fail.
[[nodiscard]] Rows worst_inputs(const Context& context);

// The same for one of them.
[[nodiscard]] Rows worst_inputs(const Context& context, const catalogue::Entry& entry);

// The history carried over Context::frames frames on the device, as a pass does it, for constant,
// alternating, jumping, noisy and rare contributions, beside the mean in double: the farthest from it, and
// the average over time (bias), at most E (w_max + k) / k with the error E of gloam_blend; weight and index,
// exact.
[[nodiscard]] Rows long_run(const Context& context);

// A scene and its moving camera at 1e2 to 1e7 units from the origin: previous positions, reprojection,
// TSSAO-8 and frames of the effect, with what is centred on the eye and with what is not; and depths in
// halves.
[[nodiscard]] Rows far_away(const Context& context);

constexpr const char* poison_name = "poison";

// Depth and normals that go into the passes of methods.
[[nodiscard]] Rows poisoned_passes(const Context& context);

// Fetches of methods: none may be outside, whatever the images hold.
[[nodiscard]] Rows poisoned_gathers(const Context& context);

// History texels and contributions.
[[nodiscard]] Rows poisoned_history(const Context& context);

// NaN, infinities, negative, subnormal and huge values in depth, normals, history and contributions, one
// texel at a time and everywhere. Occlusion stays in [0, 1]; pixels beyond the footprint stay as they were;
// a poisoned history counts as none. Nothing is fetched outside an image. All the same without
// robustBufferAccess.
[[nodiscard]] Rows poison(const Context& context);

// One way to stress the library. `go` throws what the backend, check and effect rooms throw.
struct Run {
    std::string name;  // one word, "long-run"
    Rows (*go)(const Context&) = nullptr;
};

// All runs in the order they are made. Another way to stress the library is another line here.
inline const std::vector<Run> all_runs{
    {"worst-inputs", worst_inputs}, {"long-run", long_run}, {"far", far_away}, {poison_name, poison}};

// The run of that name, or all of them for an empty one. Throws std::invalid_argument that lists the names.
[[nodiscard]] std::vector<Run> select_runs(const std::string& name);

// Column titles, and one line for each row: run, what was varied, what was measured, the number, its bound
// and the verdict. Rows without a bound have no verdict.
[[nodiscard]] std::string table_header();
[[nodiscard]] std::string table_line(const Row& row);

// {"gloam", "device": {"name", "driver"}, "versions", "rows": [{"run", "varied", "quantity", "measured",
// "bound", "passed"}]}. bound is null where nothing is promised. Infinite numbers are the strings "inf" and
// "-inf", NaN is "nan".
[[nodiscard]] std::string to_json(const gpu::DeviceInfo& device, const Rows& rows,
                                  const std::string& versions);

}  // namespace gloam::stress
