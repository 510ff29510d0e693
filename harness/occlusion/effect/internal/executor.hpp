// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "backend/vulkan/resources.hpp"
#include "effect/internal/steps.hpp"
#include "effect/internal/values.hpp"
#include "effect/plan.hpp"
#include "effect/settings.hpp"
#include "module/reflection.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// The images and buffers that passes name.
class Resources {
  public:
    // The device must outlive this object.
    explicit Resources(const backend::vulkan::Device& device);

    // Makes the images and buffers of a plan that are missing or have another size or format, and writes the
    // contents of its buffers.
    void provide(const Plan& plan);

    // Fills what a first frame expects: zeros in the images of the history, contents in all buffers.
    void restart(const Plan& plan);

    // Swaps the images of each pair.
    void exchange(std::span<const std::array<std::string, 2>> pairs);

    // Make an image or a buffer, or make it anew if its size or format is another.
    backend::vulkan::Image& image(const std::string& name, backend::Extent extent,
                                  backend::vulkan::Format format, std::uint32_t levels = 1);
    backend::vulkan::Buffer& buffer(const std::string& name, std::size_t bytes);

    // Each throws std::logic_error if there is none of this name.
    [[nodiscard]] backend::vulkan::Image& image(const std::string& name);
    [[nodiscard]] const backend::vulkan::Image& image(const std::string& name) const;
    [[nodiscard]] backend::vulkan::Buffer& buffer(const std::string& name);
    [[nodiscard]] const backend::vulkan::Buffer& buffer(const std::string& name) const;
    [[nodiscard]] bool has_buffer(const std::string& name) const { return buffers_.contains(name); }

    // What a pass binds for a name, or for IMAGE/LEVEL: nothing_image is an image of one texel in the format
    // that the pass declares. Throws std::logic_error for a name that there is not.
    [[nodiscard]] backend::vulkan::Resource at(const std::string& name, const std::string& format) const;

  private:
    const backend::vulkan::Device* device_;
    std::map<std::string, backend::vulkan::Image> images_;
    std::map<std::string, backend::vulkan::Buffer> buffers_;
    std::map<std::string, backend::vulkan::Image> nothing_;  // by format
};

// The interface of the module of a source.
using InterfaceOf = std::function<module::ModuleInterface(const PassSource&)>;

// A pass whose constants, of both kinds, have the values of their names.
[[nodiscard]] PlannedPass planned_pass(std::string name, PassSource source,
                                       std::vector<std::string> resources, const Values& values,
                                       const InterfaceOf& interface_of, std::array<std::uint32_t, 3> groups);

// A pass with a struct of push constants.
template <class Parameters>
[[nodiscard]] PlannedPass single_pass(std::string name, PassSource source, std::vector<std::string> resources,
                                      const Parameters& parameters, std::array<std::uint32_t, 3> groups) {
    const auto bytes = bytes_of(parameters);
    return {.name = std::move(name),
            .source = std::move(source),
            .resources = std::move(resources),
            .parameters = {bytes.begin(), bytes.end()},
            .groups = groups};
}

// Compiles the passes of plans and binds their resources. Each pass is compiled once.
class Executor {
  public:
    // The device must outlive this object.
    Executor(const backend::vulkan::Device& device, scene::PassLibrary library);

    // The passes, ready to run. They are valid until the resources change, as long as `passes` and this
    // object live. Throws std::runtime_error when a shader does not compile.
    [[nodiscard]] std::vector<Step> steps(std::span<const PlannedPass> passes, const Resources& resources);

    // Of the module of a source, which is compiled once.
    [[nodiscard]] const module::ModuleInterface& interface_of(const PassSource& source);

    // Runs a pass once. Throws like steps() and backend::vulkan::Commands::submit().
    void run(const PlannedPass& pass, const Resources& resources);
    void run(std::string name, PassSource source, std::vector<std::string> bound, const Values& values,
             std::array<std::uint32_t, 3> groups, const Resources& resources);

  private:
    struct Module {
        module::Spirv spirv;
        module::ModuleInterface interface;
    };
    [[nodiscard]] const Module& module(const PassSource& source);

    struct Compiled {
        backend::vulkan::ComputePipeline pipeline;
        std::vector<std::string> formats;  // of the image of each binding
    };
    [[nodiscard]] const Compiled& compiled(const PlannedPass& pass, const Resources& resources);

    const backend::vulkan::Device* device_;
    scene::PassLibrary library_;
    std::map<std::string, Module> modules_;     // by all that the source says but constants
    std::map<std::string, Compiled> compiled_;  // by all that it says
};

// What frames need of a view, and how they get it. The functions named require... throw
// std::invalid_argument that names the setting or the image.

// The guard band that the settings ask for.
void require_guard(const scene::GBuffer& view, const Settings& settings);

// At least as many depth layers as the settings ask for.
void require_layers(const scene::GBuffer& view, const Settings& settings);

// A camera whose axis is in the middle of its image.
void require_centred(const scene::GBuffer& view);

// Uploads a view to the images depth, normal, previous_position and layers, those that it has. Missing images
// are made; std::invalid_argument for one that has not the view's size. stores: depth and normals as the
// engine stores them, if it does; otherwise linear depth and normals of view space.
void upload(const scene::GBuffer& view, bool stores, Resources& resources);

// Uploads linear depth and normals of view space. Missing normals are reconstructed from depth.
void take_linear(const scene::GBuffer& view, Resources& resources, Executor& executor);

}  // namespace gloam::effect
