// SPDX-License-Identifier: MIT
#include "report/benchmark/page.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "report/benchmark/pareto.hpp"
#include "report/benchmark/tables.hpp"

namespace gloam::report {
namespace {

constexpr const char* benchmark_introduction = R"(# Time against error

Which method, with how many samples, takes how long and comes how near to the truth. `gloam bench --report FILE` wrote
this page. docs/measurements.md says how to measure on your device and how to query the results; other devices rank
methods otherwise.

)";

constexpr const char* explanation = R"(
- **Configurations** are METHOD/SAMPLES/MODE, or PRESET/SAMPLES/MODE. *Single* is one frame of the method with the
  settings of the preset `paper`, the filter included. *Temporal* is the settings of the preset `moving` over the
  frames of a moving camera. SAMPLES is what is asked for in each pixel and frame; *samples taken* is what the passes
  counted.
- **Time** is the device's, by its own clock, as a median. Configurations are visited in rounds, each once a round, so
  that drift falls on all alike. A **copy** is the time of a pass that reads one R32F texel and writes one for each
  pixel (`glsl/passes/copy.comp`). It is measured beside every frame: a frame's time is divided by the copies' of that
  moment. *Gather* is the pass that takes the samples.
- **Error** is the root mean square error against the traced truth: (G) of the geometry, (D) of the depth buffer.
  *Raw* is before the filter. It is the mean over the scored frames, the same frames for all. SSIM (structural
  similarity, 1 where two images are the same) is of the last of them, against (G). *Flicker* is the mean change from
  frame to frame at the same points.
- **Memory** is of all images and buffers that the passes are given, G-buffer included.
- **The front** (Pareto): nothing else is both as fast and as near to the truth. *Over all scenes*, times are
  geometric means, and errors are geometric means of the ratio to the least that any configuration has in the scene.
)";

constexpr const char* presets_introduction = R"(
## The presets

Measured as they are. `fast`, `balanced` and `reference` are points of the front of temporal runs: for a time, a
middle and an error. `paper` is the settings of Mattausch et al. 2010, and `moving` those with a shorter memory.

)";

std::string circumstances(const Benchmark& benchmark) {
    return fmt::format(
        "Measured on {} ({}), {} x {} pixels, {} rounds.\n"
        "A temporal run has {} frames; the last {} are scored. The truth takes {} rays a pixel.\n"
        "A copy takes {:.4f} ms (quartiles {:.4f} and {:.4f}).\n",
        benchmark.device, benchmark.driver, benchmark.width, benchmark.height, benchmark.repeat,
        benchmark.frames, benchmark.scored, benchmark.rays, benchmark.copy_ms.median, benchmark.copy_ms.low,
        benchmark.copy_ms.high);
}

std::string picture(const std::string& images, const std::string& name) {
    return fmt::format("![{}]({}/{}.svg)\n\n", name, images, name);
}

std::string framework_section(const Benchmark& benchmark) {
    if (benchmark.framework.empty()) return {};
    return "\n## The framework\n\nInputs uploaded, one dispatch, every canary checked, outputs downloaded. "
           "*Of a copy*: "
           "the rate as a fraction of that of a bare dispatch that copies the same bytes, in turn. The rest "
           "of what the framework costs is in docs/measurements.md.\n\n" +
           framework_table(benchmark);
}

}  // namespace

std::string to_benchmark_page(const Benchmark& benchmark, const std::string& images) {
    const std::vector<std::string> scenes = scenes_of(benchmark);
    std::string text = benchmark_introduction + circumstances(benchmark) + explanation;
    if (!overall_of(benchmark).empty()) {
        text += "\n## Over all scenes\n\n" + picture(images, "overall") + overall_table(benchmark);
    }
    const std::string presets = presets_table(benchmark);
    if (!presets.empty()) text += presets_introduction + presets;
    for (const std::string& scene : scenes) {
        text += fmt::format("\n## `{}`\n\n{}The front:\n\n{}\nEach method at its most exact:\n\n{}", scene,
                            picture(images, base::file_name_of(scene)), scene_front_table(benchmark, scene),
                            best_table(benchmark, scene));
    }
    return text + framework_section(benchmark);
}

}  // namespace gloam::report
