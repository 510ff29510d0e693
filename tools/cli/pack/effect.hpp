// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "effect/methods.hpp"
#include "effect/plan.hpp"
#include "effect/settings.hpp"
#include "shader/pack.hpp"
#include "shader/reflection.hpp"

namespace gloam::cli {

// A pass of the effect as one text, and the interface of its module.
struct PackedPass {
    effect::PlannedPass plan;
    std::string file;  // of the text: NAME.comp
    std::string text;
    shader::ModuleInterface interface;
};

// The effect in the form in which it is written.
struct PackedEffect {
    std::string preset;
    std::string version;                                      // of gloam
    shader::Language language = shader::Language::vulkan450;  // of the passes
    std::optional<shader::Target> target;                     // each pass is there in this language, too
    effect::Settings settings;
    effect::PlanOptions options;
    effect::Plan plan;
    std::vector<PackedPass> passes;  // of the plan, in its order
};

// The passes of the settings' plan, packed and compiled, with the images and buffers of their bindings.
// Throws like plan_of() and shader::pack().
[[nodiscard]] PackedEffect packed_effect(const effect::Settings& settings, const effect::PlanOptions& options,
                                         const scene::PassLibrary& library,
                                         shader::Language language = shader::Language::vulkan450);

// The image or buffer at a binding of a pass. Throws std::logic_error if the plan does not have it.
[[nodiscard]] const std::string& resource_at(const PackedPass& pass, const shader::Binding& binding);

// Whether this resource is bound where the settings need none.
[[nodiscard]] bool is_nothing(const std::string& resource);

// Whether a member of the pass's push constants depends on the view or the frame.
[[nodiscard]] bool is_of_view(const PackedPass& pass, const shader::LaidOut& member);

// The comment behind a member's declaration in the text; empty if there is none.
[[nodiscard]] std::string comment_of(const std::string& text, const std::string& block,
                                     const std::string& member);

// A barrier that a pass needs, because earlier passes of the frame write or read its resources.
struct Hazard {
    std::string resource;
    std::string after;  // the last pass that wrote the resource, or that read it before this one writes it
    bool written = true;
};
[[nodiscard]] std::vector<Hazard> hazards_before(const PackedEffect& effect, std::size_t pass);

// Text of the header: the constants of the half-size view from those of the view. Empty for passes that run
// over images of the view's size.
[[nodiscard]] std::string half_view_text(const PackedEffect& effect);

// The files of the folder besides the passes.
[[nodiscard]] std::string effect_header(const PackedEffect& effect);  // gloam_effect.h
[[nodiscard]] std::string effect_json(const PackedEffect& effect);    // effect.json
[[nodiscard]] std::string effect_page(const PackedEffect& effect);    // README.md

struct EffectPackOptions {
    std::string preset = effect::default_preset;
    std::string method;            // empty: the preset's
    float radius = 1.0F;           // world units
    std::vector<std::string> set;  // NAME=VALUE
    std::string size = "1920x1080";
    bool moving_objects = false;
    bool motion_vectors = false;
    bool orthographic = false;
    bool reconstruct_normals = false;
    bool bent_normals = false;
    std::string depth = "linear";  // how the engine stores depth and normals: scene::encoding_named()
    std::string normals = "view";
    std::optional<shader::Target> target;  // a language for every pass, besides GLSL
    std::string version = "450";           // of the passes: or 310es, 320es
    std::filesystem::path out;
};

// Writes all passes of the effect, gloam_effect.h, effect.json and README.md into a folder, all or none.
// Throws std::invalid_argument for invalid options, std::runtime_error for a folder that cannot be written
// to.
void pack_effect(const EffectPackOptions& options);

// The format's name in Vulkan's headers.
[[nodiscard]] std::string vulkan_format(gpu::Format format);
[[nodiscard]] std::string vulkan_descriptor(shader::BindingType type);

// "engine", "kept", "once", "frame".
[[nodiscard]] std::string to_string(effect::PlannedImage::Origin origin);

// The uses of an image, from the bindings of the passes: VK_IMAGE_USAGE_STORAGE_BIT and others.
[[nodiscard]] std::vector<std::string> vulkan_usage(const PackedEffect& effect,
                                                    const effect::PlannedImage& image);

// The packed text with gloam's version at its head: behind #version, which must be the first line.
[[nodiscard]] std::string with_version(std::string text);

// A Markdown table: for each file its lines of code as packed, without blank ones and comments, and behind
// them those of all together, each function once. Without files: those of glsl/gloam/methods, and the passes
// of each method's effect. Throws like shader::pack().
[[nodiscard]] std::string line_table(const std::filesystem::path& glsl,
                                     const std::vector<std::string>& files);

}  // namespace gloam::cli
