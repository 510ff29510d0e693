// SPDX-License-Identifier: MIT
#include "effect/internal/passes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "effect/methods.hpp"
#include "effect/settings.hpp"

namespace gloam::effect {
namespace {

std::string filter_include(const Settings& settings) {
    return "filters/" + std::get<std::string>(setting_named("filter").get(settings)) + ".glsl";
}

// Preprocessor definitions of a pass that reads or writes the prepared image.
std::vector<std::string> defines_for(const Moment& moment) {
    if (moment.preparation && moment.preparation->format == backend::vulkan::Format::r32f)
        return {"GLOAM_PREPARED r32f"};
    return {};
}

}  // namespace

void define_output(OutputFormat output, std::vector<std::string>& defines) {
    if (output != OutputFormat::r32f)
        defines.emplace_back(output == OutputFormat::r8 ? "GLOAM_OUTPUT r8" : "GLOAM_OUTPUT r16f");
}

backend::vulkan::Format format_of(OutputFormat output) {
    if (output == OutputFormat::r32f) return backend::vulkan::Format::r32f;
    return output == OutputFormat::r8 ? backend::vulkan::Format::r8 : backend::vulkan::Format::r16f;
}

std::optional<Preparation> preparation_of(const Settings& settings, backend::Extent view) {
    const MethodInfo& method = method_named(settings.method);
    if (method.prepare == nullptr) return std::nullopt;
    return method.prepare(settings, view);
}

void Moment::look(const View& now, const View& last) {
    view = now;
    before = last;
    preparation = preparation_of(settings, view.extent);
}

PassSource occlusion_source(const Moment& moment) {
    const MethodInfo& method = method_named(moment.settings.method);
    PassSource source{.file = "study/ambient_occlusion.comp", .defines = defines_for(moment)};
    source.defines.push_back("METHOD(position, normal, camera, kernel, values) " + call_of(method));
    source.replaced = {{file_of(methods().front()), file_of(method)}};  // in the place of that which it names
    return source;
}

PassSource filter_source(const Settings& settings) {
    return {.file = "study/spatial_filter.comp",
            .replaced = {{filter_include({}), filter_include(settings)}}};
}

PassSource remap_source(const Settings& settings, bool from_history) {
    PassSource source{.file = "study/remap.comp"};
    if (!from_history) source.defines.emplace_back("GLOAM_SOURCE r32f");
    define_output(settings.output, source.defines);
    return source;
}

PassSource preparation_source(const Moment& moment, const std::string& file) {
    return {.file = "study/preparation/" + file, .defines = defines_for(moment)};
}

std::array<std::uint32_t, 3> groups_for(backend::Extent extent) {
    const auto groups = [](std::uint32_t side) { return (side + 7) / 8; };
    return {groups(extent.width), groups(extent.height), 1};
}

}  // namespace gloam::effect
