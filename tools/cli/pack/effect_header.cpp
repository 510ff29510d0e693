// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <set>
#include <stdexcept>

#include "cli/pack/effect.hpp"

namespace gloam::cli {
namespace {

using effect::PlannedBuffer;
using effect::PlannedImage;
using shader::LaidOut;

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

// The C type of a member's components.
std::string c_type(const std::string& type) {
    if (type == "float") return "float";
    if (type == "int") return "int32_t";
    if (type == "uint" || type == "bool") return "uint32_t";
    return "gloam_" + type;
}

std::string c_number(const std::string& type, std::span<const std::byte> bytes) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, bytes.data(), sizeof bits);
    if (type == "int") return std::to_string(std::bit_cast<std::int32_t>(bits));
    if (type != "float") return fmt::format("{}u", bits);
    const float value = std::bit_cast<float>(bits);
    if (std::isinf(value)) return value > 0.0F ? "INFINITY" : "-INFINITY";
    std::string text = fmt::format("{}", value);
    return text + (text.find_first_of(".e") == std::string::npos ? ".0f" : "f");
}

std::size_t components_of(const LaidOut& member) {
    return member.size / 4;
}

// "float p00_p11[2]"; includes padding between columns and elements.
std::string declaration_of(const LaidOut& member) {
    const std::size_t count = components_of(member);
    std::string text = c_type(member.type) + " " + member.name;
    if (member.members.empty() && count > 1) text += fmt::format("[{}]", count);
    if (!member.members.empty() && !member.sizes.empty()) text += fmt::format("[{}]", member.sizes.front());
    return text;
}

std::string value_of(const LaidOut& member, std::span<const std::byte> bytes, std::size_t base) {
    if (!member.members.empty()) {
        std::string text;
        for (const LaidOut& inner : member.members)
            text += (text.empty() ? "" : ", ") + value_of(inner, bytes, base + member.offset);
        return "{" + text + "}";
    }
    const std::size_t count = components_of(member);
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
        text += (i > 0 ? ", " : "") + c_number(member.type, bytes.subspan(base + member.offset + 4 * i, 4));
    return count > 1 ? "{" + text + "}" : text;
}

class HeaderWriter {
  public:
    explicit HeaderWriter(const PackedEffect& effect) : effect_(effect) {}

    std::string run() {
        beginning();
        for (const PackedPass& pass : effect_.passes) buffer_structures(pass);
        for (const PackedPass& pass : effect_.passes) constants(pass);
        buffer_contents();
        enumerations();
        put("/* Pixels of the view along each side of a tile. */\nenum {{ GLOAM_TILE = {} }};\n\n",
            effect_.plan.tile);
        text_ += half_view_text(effect_);
        images();
        buffers();
        passes();
        text_ += "#endif\n";
        return std::move(text_);
    }

  private:
    template <class... Parts>
    void put(fmt::format_string<Parts...> format, Parts&&... parts) {
        text_ += fmt::format(format, std::forward<Parts>(parts)...);
    }

    void beginning() {
        put("/* SPDX-License-Identifier: MIT\n"
            " * Ambient occlusion of gloam {}, preset {}, method {}, for a radius of {} world units: what "
            "its passes\n"
            " * are given. README.md beside this says how a frame runs. */\n",
            effect_.version, effect_.preset, effect_.settings.method, effect_.settings.radius);
        text_ +=
            "#ifndef GLOAM_EFFECT_H\n#define GLOAM_EFFECT_H\n\n"
            "#include <math.h>\n#include <stddef.h>\n#include <stdint.h>\n#include <vulkan/vulkan_core.h>\n\n"
            "#ifdef __cplusplus\n#define GLOAM_CHECK(condition) static_assert(condition, #condition)\n"
            "#else\n#define GLOAM_CHECK(condition) _Static_assert(condition, #condition)\n#endif\n\n";
    }

    // A structure with its memory layout, with explicit padding and static assertions.
    void structure(const std::string& name, const std::vector<LaidOut>& members, std::size_t size,
                   const std::string& text, const std::string& block, const PackedPass* pass) {
        put("typedef struct {} {{\n", name);
        std::size_t end = 0;
        int gaps = 0;
        for (const LaidOut& member : members) {
            if (member.offset > end) put("    uint8_t padding{}[{}];\n", gaps++, member.offset - end);
            const std::string comment = comment_of(text, block, member.name);
            const std::string whose = pass && is_of_view(*pass, member) ? "the view's: " : "";
            put("    {};{}\n", declaration_of(member),
                comment.empty() && whose.empty() ? "" : "  /* " + whose + comment + " */");
            end = member.offset + member.size;
        }
        put("}} {};\n", name);
        for (const LaidOut& member : members)
            put("GLOAM_CHECK(offsetof({}, {}) == {});\n", name, member.name, member.offset);
        put("GLOAM_CHECK(sizeof({}) == {});\n\n", name, std::max(size, end));
    }

    // The structures in buffers, each once.
    void buffer_structures(const PackedPass& pass) {
        for (const shader::Binding& binding : pass.interface.bindings) {
            if (!binding.block || is_nothing(resource_at(pass, binding))) continue;
            for (const LaidOut& member : binding.block->members) {
                const bool known = member.members.empty() || !structures_.insert(member.type).second;
                if (known) continue;
                put("/* In the buffer {} */\n", resource_at(pass, binding));
                const std::size_t size = member.sizes.empty() ? member.size : member.stride;
                structure("gloam_" + member.type, member.members, size, pass.text, member.type, nullptr);
            }
        }
    }

    void constants(const PackedPass& pass) {
        if (!pass.interface.push_constants) return;
        const shader::BlockLayout& block = *pass.interface.push_constants;
        const std::string name = "gloam_" + pass.plan.name + "_constants";
        put("/* Push constants of {} */\n", pass.file);
        structure(name, block.members, pass.plan.parameters.size(), pass.text, block.name, &pass);
        put("/* The preset's; 0 where they are the view's */\n");
        preset(pass, name, "preset", pass.plan.parameters);
        if (!alternates(pass)) return;
        put("/* In every second frame */\n");
        preset(pass, name, "odd_preset", pass.plan.odd_parameters);
    }

    static bool alternates(const PackedPass& pass) {
        return pass.plan.parameters != pass.plan.odd_parameters;
    }

    void preset(const PackedPass& pass, const std::string& type, const char* name,
                const std::vector<std::byte>& parameters) {
        put("static const {} gloam_{}_{} = {{\n", type, pass.plan.name, name);
        const std::vector<std::byte> zeros(parameters.size());
        for (const LaidOut& member : pass.interface.push_constants->members)
            put("    {},  /* {} */\n", value_of(member, is_of_view(pass, member) ? zeros : parameters, 0),
                member.name);
        put("}};\n\n");
    }

    void buffer_contents() {
        for (const PlannedBuffer& buffer : effect_.plan.buffers) {
            if (buffer.contents.empty()) continue;
            put("/* What the buffer {} begins with: {} */\nstatic const uint32_t gloam_{}_contents[{}] = {{",
                buffer.name, buffer.meaning, buffer.name, buffer.contents.size() / 4);
            for (std::size_t i = 0; i + 4 <= buffer.contents.size(); i += 4) {
                std::uint32_t word = 0;
                std::memcpy(&word, &buffer.contents[i], sizeof word);
                put("{}0x{:08x}u", i == 0 ? "" : ", ", word);
            }
            put("}};\n\n");
        }
    }

    template <class Each>
    void enumeration(const char* name, const std::vector<Each>& all) {
        put("enum {{");
        for (const Each& each : all)
            put("{} GLOAM_{}_{}", &each == all.data() ? "" : ",", name, upper(each.name));
        put(", GLOAM_{}S }};\n", name);
    }

    void enumerations() {
        enumeration("IMAGE", effect_.plan.images);
        enumeration("BUFFER", effect_.plan.buffers);
        text_ +=
            "enum { GLOAM_ONCE, GLOAM_MOVED, GLOAM_ALWAYS };\n"
            "enum { GLOAM_ENGINE, GLOAM_KEPT, GLOAM_WRITTEN_ONCE, GLOAM_FRAME };\n\n";
    }

    void images() {
        text_ +=
            "/* The images. divisor: sides of the view divided by it, rounded up; 0: width x height.\n"
            " * origin: written by the engine each frame; kept from frame to frame (zeros at first); written "
            "by the passes once,\n"
            " * or in each frame. */\n"
            "typedef struct gloam_image_info {\n    const char* name;\n    VkFormat format;\n    "
            "VkImageUsageFlags usage;\n"
            "    uint32_t divisor, width, height, origin;\n} gloam_image_info;\n"
            "static const gloam_image_info gloam_images[GLOAM_IMAGES] = {\n";
        for (const PlannedImage& image : effect_.plan.images) {
            put("    {{\"{}\", {}, {}, {}u, {}u, {}u, {}}},\n", image.name, vulkan_format(image.format),
                fmt::join(vulkan_usage(effect_, image), " | "), image.divisor, image.extent.width,
                image.extent.height,
                image.origin == PlannedImage::Origin::once ? "GLOAM_WRITTEN_ONCE"
                                                           : "GLOAM_" + upper(to_string(image.origin)));
        }
        text_ += "};\n\n";
    }

    void buffers() {
        text_ +=
            "/* The buffers: bytes + bytes_a_tile for each tile of the view; contents at their "
            "beginning, else\n"
            " * zeros: before the first frame, and before each where refilled is 1. */\n"
            "typedef struct gloam_buffer_info {\n    const char* name;\n    uint32_t bytes, bytes_a_tile;\n"
            "    const void* contents;\n    uint32_t contents_bytes, refilled;\n} gloam_buffer_info;\n"
            "static const gloam_buffer_info gloam_buffers[GLOAM_BUFFERS] = {\n";
        for (const PlannedBuffer& buffer : effect_.plan.buffers) {
            const auto tiles =
                buffer.bytes_a_tile == 0 ? 0 : (buffer.bytes - buffer.contents.size()) / buffer.bytes_a_tile;
            put("    {{\"{}\", {}u, {}u, {}, {}u, {}u}},\n", buffer.name,
                buffer.bytes - tiles * buffer.bytes_a_tile, buffer.bytes_a_tile,
                buffer.contents.empty() ? "NULL" : "gloam_" + buffer.name + "_contents",
                buffer.contents.size(), buffer.refilled ? 1 : 0);
        }
        text_ += "};\n\n";
    }

    void passes() {
        for (const PackedPass& pass : effect_.passes) {
            bindings(pass);
            members(pass);
        }
        text_ +=
            "/* The passes of a frame, in their order. A group takes pixels[0] x pixels[1] of the view; "
            "where they are 0 the\n"
            " * groups are given, or, where list_buffer is not -1, an indirect dispatch at list_offset of "
            "that buffer.\n"
            " * divisor: 2 where the view's push constants are those of the half-size view. */\n"
            "typedef struct gloam_pass_info {\n    const char* name;\n    uint32_t turn;\n"
            "    const gloam_binding* bindings;\n    uint32_t binding_count;\n    const gloam_member* "
            "members;\n"
            "    uint32_t member_count;\n    const void* preset;\n    const void* odd_preset;\n    uint32_t "
            "preset_bytes;\n"
            "    uint32_t pixels[2], groups[3];\n    int32_t list_buffer;\n    uint32_t list_offset, "
            "divisor;\n} "
            "gloam_pass_info;\n"
            "static const gloam_pass_info gloam_passes[] = {\n";
        for (const PackedPass& pass : effect_.passes) row(pass);
        put("}};\nenum {{ GLOAM_PASSES = {} }};\n\n", effect_.passes.size());
        ending();
    }

    void ending() {
        text_ += "/* Which two are exchanged after each frame. */\n";
        const auto is_image = [this](const std::string& name) {
            return std::ranges::find(effect_.plan.images, name, &PlannedImage::name) !=
                   effect_.plan.images.end();
        };
        for (const bool image : {true, false}) {
            std::string pairs;
            for (const auto& [a, b] : effect_.plan.exchanged)
                if (is_image(a) == image)
                    pairs += fmt::format("{{GLOAM_{0}_{1}, GLOAM_{0}_{2}}}, ", image ? "IMAGE" : "BUFFER",
                                         upper(a), upper(b));
            put("static const int gloam_exchanged_{}[][2] = {{{}{{-1, -1}}}};\n",
                image ? "images" : "buffers", pairs);
        }
        put("\n/* The result: occlusion in the first channel of this image, so much for each unit of it. */\n"
            "enum {{ GLOAM_RESULT = GLOAM_IMAGE_{} }};\nstatic const float gloam_result_unit = {};\n\n",
            upper(effect_.plan.result),
            c_number("float", std::as_bytes(std::span(&effect_.plan.result_unit, 1))));
    }

    void row(const PackedPass& pass) {
        const effect::PlannedPass& plan = pass.plan;
        const auto& constants = pass.interface.push_constants;
        const auto of_constants = [&](const std::string& name) {
            return constants ? fmt::format("gloam_{}_{}", plan.name, name) : std::string("NULL");
        };
        const std::string address = constants ? "&" : "";
        put("    {{\"{0}\", {1}, gloam_{0}_bindings, {2}u, ", plan.name, turn_name(plan.turn),
            pass.interface.bindings.size());
        put("{}, {}u, {}{}, {}{}, {}u, ", of_constants("members"), constants ? constants->members.size() : 0,
            address, of_constants("preset"), address,
            of_constants(alternates(pass) ? "odd_preset" : "preset"), plan.parameters.size());
        const bool fixed = plan.pixels[0] == 0;  // the groups do not depend on the view
        put("{{{}u, {}u}}, {{{}u, {}u, {}u}}, ", plan.pixels[0], plan.pixels[1], fixed ? plan.groups[0] : 0,
            fixed ? plan.groups[1] : 0, fixed ? plan.groups[2] : 0);
        put("{}, {}u, {}u}},\n", plan.list ? "GLOAM_BUFFER_TILE_LISTS" : "-1", plan.list.value_or(0),
            plan.divisor);
    }

    static const char* turn_name(effect::Turn turn) {
        if (turn == effect::Turn::once) return "GLOAM_ONCE";
        return turn == effect::Turn::moved ? "GLOAM_MOVED" : "GLOAM_ALWAYS";
    }

    // The bindings of descriptor set 0.
    void bindings(const PackedPass& pass) {
        if (std::exchange(tables_declared_, true) == false) {
            text_ +=
                "/* A binding of descriptor set 0: an image, or a buffer; the other is -1. */\n"
                "typedef struct gloam_binding {\n    uint32_t number;\n    VkDescriptorType type;\n    int "
                "image, buffer;\n"
                "} gloam_binding;\n\n"
                "/* A member of a pass's push constants. of_view: to be set for each view or frame. */\n"
                "typedef struct gloam_member {\n    const char* name;\n    uint32_t offset, bytes, "
                "of_view;\n} gloam_member;\n\n";
        }
        put("static const gloam_binding gloam_{}_bindings[] = {{\n", pass.plan.name);
        for (const shader::Binding& binding : pass.interface.bindings) {
            const std::string& name = resource_at(pass, binding);
            const std::string index = binding.block ? fmt::format("-1, GLOAM_BUFFER_{}", upper(name))
                                                    : fmt::format("GLOAM_IMAGE_{}, -1", upper(name));
            put("    {{{}u, {}, {}}},  /* {} */\n", binding.number, vulkan_descriptor(binding.type), index,
                binding.name);
        }
        put("}};\n");
    }

    void members(const PackedPass& pass) {
        if (!pass.interface.push_constants) return;
        put("static const gloam_member gloam_{}_members[] = {{\n", pass.plan.name);
        for (const LaidOut& member : pass.interface.push_constants->members)
            put("    {{\"{}\", {}u, {}u, {}u}},\n", member.name, member.offset, member.size,
                is_of_view(pass, member) ? 1 : 0);
        put("}};\n\n");
    }

    const PackedEffect& effect_;
    std::set<std::string> structures_;
    bool tables_declared_ = false;
    std::string text_;
};

}  // namespace

std::string effect_header(const PackedEffect& effect) {
    return HeaderWriter(effect).run();
}

}  // namespace gloam::cli
