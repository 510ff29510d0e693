// SPDX-License-Identifier: MIT
#include "effect/internal/steps.hpp"

#include <algorithm>
#include <map>

#include "backend/vulkan/commands.hpp"
#include "numeric/numbers.hpp"

namespace gloam::effect {
namespace {

std::uint64_t bytes_of(const backend::vulkan::Image& image) {
    return std::uint64_t{image.extent().width} * image.extent().height *
           backend::vulkan::texel_bytes(image.format());
}

void record(backend::vulkan::Commands& commands, const Step& pass) {
    if (pass.groups_from != nullptr)
        commands.dispatch(*pass.pipeline, pass.resources, *pass.groups_from, pass.groups_at, pass.parameters);
    else
        commands.dispatch(*pass.pipeline, pass.resources, pass.groups, pass.parameters);
}

void run_watched(const backend::vulkan::Device& device, const Step& pass, const PassWatcher& watcher) {
    watcher(pass, false);
    backend::vulkan::Commands commands(device);
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

}  // namespace

std::vector<PassTime> run(const backend::vulkan::Device& device, std::span<const Step> passes, int repeat,
                          const PassWatcher& watcher) {
    std::vector<std::vector<double>> times(passes.size());
    int batch = 1;  // frames that are submitted at once
    for (int i = 0; i < repeat; i += batch) {
        if (watcher) {
            for (const Step& pass : passes) run_watched(device, pass, watcher);
            continue;
        }
        if (i == 1) batch = frames_at_once(times);
        backend::vulkan::Commands commands(device);
        for (int frame = i; frame < std::min(i + batch, repeat); ++frame) {
            commands.timestamp();
            for (const Step& pass : passes) {
                record(commands, pass);
                commands.timestamp();
            }
        }
        commands.submit();
        const std::vector<double> readings = commands.times_ms();
        for (std::size_t r = 0; r < readings.size(); r += passes.size() + 1)
            for (std::size_t p = 0; p < passes.size(); ++p)
                times[p].push_back(readings[r + p + 1] - readings[r + p]);
    }
    std::vector<PassTime> medians;
    for (std::size_t p = 0; p < passes.size(); ++p)
        medians.push_back({passes[p].name, numeric::spread_of(times[p]).median});
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
        for (const backend::vulkan::Resource& resource : pass.resources) {
            if (const auto* buffer =
                    std::get_if<std::reference_wrapper<const backend::vulkan::Buffer>>(&resource)) {
                bytes[&buffer->get()] = buffer->get().size();
            } else {
                const auto* level = std::get_if<backend::vulkan::ImageLevel>(&resource);
                const auto* linear = std::get_if<backend::vulkan::LinearImage>(&resource);
                const backend::vulkan::Image& image =
                    level    ? level->image
                    : linear ? linear->image
                             : std::get<std::reference_wrapper<const backend::vulkan::Image>>(resource);
                bytes[&image] = bytes_of(image);
            }
        }
    }
    std::uint64_t sum = 0;
    for (const auto& [resource, size] : bytes) sum += size;
    return sum;
}

}  // namespace gloam::effect
