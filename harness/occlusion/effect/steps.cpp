// SPDX-License-Identifier: MIT
#include "effect/internal/steps.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "backend/vulkan/commands.hpp"

namespace gloam::effect {
namespace {

// For an even number of values the mean of the middle two; NaN for no value.
double median(std::vector<double> values) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::ranges::sort(values);
    const std::size_t upper = values.size() / 2;
    return values.size() % 2 == 1 ? values[upper] : 0.5 * (values[upper - 1] + values[upper]);
}

std::uint64_t bytes_of(const gpu::Image& image) {
    return std::uint64_t{image.extent().width} * image.extent().height * gpu::texel_bytes(image.format());
}

void record(gpu::Commands& commands, const Step& pass) {
    if (pass.groups_from != nullptr)
        commands.dispatch(*pass.pipeline, pass.resources, *pass.groups_from, pass.groups_at, pass.parameters);
    else
        commands.dispatch(*pass.pipeline, pass.resources, pass.groups, pass.parameters);
}

void run_watched(const gpu::Device& device, const Step& pass, const PassWatcher& watcher) {
    watcher(pass, false);
    gpu::Commands commands(device);
    record(commands, pass);
    commands.submit();
    watcher(pass, true);
}

// A GPU that waits between short frames lowers its clock, and each of their passes counts its start: so many
// frames as take 10 ms, at most 32. times: of each pass, in ms, in the first frame.
int frames_at_once(const std::vector<std::vector<double>>& times) {
    double frame = 0.0;
    for (const auto& of_pass : times) frame += of_pass.empty() ? 0.0 : of_pass.front();
    return static_cast<int>(std::clamp(10.0 / std::max(1e-3, frame), 1.0, 32.0));
}

// Appends the time of each pass in each of so many frames, which are submitted at once.
void time_frames(const gpu::Device& device, std::span<const Step> passes, int frames,
                 std::vector<std::vector<double>>& times) {
    gpu::Commands commands(device);
    for (int frame = 0; frame < frames; ++frame) {
        commands.timestamp();
        for (const Step& pass : passes) {
            record(commands, pass);
            commands.timestamp();
        }
    }
    commands.submit();
    const std::vector<double> readings = commands.times_ms();
    for (std::size_t i = 0; i < readings.size(); i += passes.size() + 1)
        for (std::size_t p = 0; p < passes.size(); ++p)
            times[p].push_back(readings[i + p + 1] - readings[i + p]);
}

}  // namespace

std::vector<PassTime> run(const gpu::Device& device, std::span<const Step> passes, int repeat,
                          const PassWatcher& watcher) {
    std::vector<std::vector<double>> times(passes.size());
    int batch = 1;
    for (int i = 0; i < repeat; i += batch) {
        if (i == 1 && !watcher) batch = frames_at_once(times);
        if (watcher) {
            for (const Step& pass : passes) run_watched(device, pass, watcher);
            continue;
        }
        time_frames(device, passes, std::min(batch, repeat - i), times);
    }
    std::vector<PassTime> medians;
    for (std::size_t p = 0; p < passes.size(); ++p) medians.push_back({passes[p].name, median(times[p])});
    return medians;
}

std::vector<float> channel(std::span<const float> texels, std::size_t which) {
    std::vector<float> values(texels.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = texels[4 * i + which];
    return values;
}

std::vector<float> texels_of(std::span<const glm::vec3> vectors) {
    std::vector<float> texels;
    texels.reserve(4 * vectors.size());
    for (const glm::vec3& v : vectors) texels.insert(texels.end(), {v.x, v.y, v.z, 0.0F});
    return texels;
}

std::uint64_t memory_of(std::span<const Step> passes) {
    std::map<const void*, std::uint64_t> bytes;
    for (const Step& pass : passes) {
        for (const gpu::Resource& resource : pass.resources) {
            if (const auto* buffer = std::get_if<std::reference_wrapper<const gpu::Buffer>>(&resource)) {
                bytes[&buffer->get()] = buffer->get().size();
            } else {
                const auto* level = std::get_if<gpu::ImageLevel>(&resource);
                const auto* linear = std::get_if<gpu::LinearImage>(&resource);
                const gpu::Image& image = level ? level->image
                                          : linear
                                              ? linear->image
                                              : std::get<std::reference_wrapper<const gpu::Image>>(resource);
                bytes[&image] = bytes_of(image);
            }
        }
    }
    std::uint64_t sum = 0;
    for (const auto& [resource, size] : bytes) sum += size;
    return sum;
}

}  // namespace gloam::effect
