// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "cli/pack/effect.hpp"
#include "effect/settings.hpp"

namespace gloam::cli {
namespace {

using effect::PlannedImage;
using effect::Turn;

std::string dispatch_of(const effect::PlannedPass& pass) {
    if (pass.list) return fmt::format("indirect: `tile_lists` at {}", *pass.list);
    if (pass.pixels[0] == 0)
        return fmt::format("{} x {} x {} groups", pass.groups[0], pass.groups[1], pass.groups[2]);
    return fmt::format("ceil(width / {}) x ceil(height / {}) groups", pass.pixels[0], pass.pixels[1]);
}

const char* turn_of(Turn turn) {
    if (turn == Turn::once) return "once, before the first frame";
    return turn == Turn::moved ? "where the view is not that of the frame before" : "in each frame";
}

std::string size_of(const PackedEffect& effect, const PlannedImage& image) {
    if (image.divisor == 1) return "the view";
    if (image.divisor > 1) return fmt::format("the view / {}, rounded up", image.divisor);
    const std::string fixed = fmt::format("{} x {}", image.extent.width, image.extent.height);
    if (image.name != "prepared") return fixed;
    return fmt::format("{} for a view of {} x {}", fixed, effect.options.view.width,
                       effect.options.view.height);
}

std::string value_of(const shader::SpecializationConstant& constant) {
    if (constant.type == "bool") return constant.bits != 0 ? "true" : "false";
    if (constant.type == "int") return std::to_string(static_cast<std::int32_t>(constant.bits));
    if (constant.type == "float") return fmt::format("{}", std::bit_cast<float>(constant.bits));
    return std::to_string(constant.bits);
}

class PageWriter {
  public:
    explicit PageWriter(const PackedEffect& effect) : effect_(effect) {}

    std::string run() {
        head();
        settings();
        order();
        images();
        bindings();
        barriers();
        constants();
        compile();
        return std::move(text_);
    }

  private:
    template <class... Parts>
    void put(fmt::format_string<Parts...> format, Parts&&... parts) {
        text_ += fmt::format(format, std::forward<Parts>(parts)...);
    }

    void head() {
        put("# Ambient occlusion: preset {}, method {}\n\n", effect_.preset, effect_.settings.method);
        put("Written by `gloam pack --effect` of gloam {}. Each pass is one GLSL {} file without includes. "
            "`gloam_effect.h` holds the layouts of push constants and buffers, the preset's values and the "
            "tables below for C and C++; `effect.json` holds the same for other languages. All of it was "
            "read "
            "from the compiled passes.\n\n",
            effect_.version, effect_.language == shader::Language::vulkan450 ? "4.50" : "ES");
        if (effect_.language == shader::Language::vulkan450) return;
        text_ +=
            "In OpenGL ES, specialization constants are constants of the passes, and push constants are the "
            "uniform block at binding 0, with the same offsets. Images that are written are image units, "
            "images "
            "that are read are texture units, and buffers are storage blocks; each kind has its own binding "
            "numbers. A device may have only four image units: give `layout(binding = N)` of a written image "
            "another number there. Between passes, instead of the barriers below: "
            "`glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | "
            "GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT)`.\n\n";
    }

    void settings() {
        put("## Settings\n\nSet as specialization constants in the passes and as values in `gloam_effect.h`. "
            "Lengths are for a "
            "radius of {} world units.\n\n| setting | value |\n| --- | --- |\n",
            effect_.settings.radius);
        for (const effect::Setting& setting : effect::setting_table())
            put("| {} | {} |\n", setting.name, effect::text_of(setting.get(effect_.settings)));
    }

    void order() {
        text_ +=
            "\n## Order of calls\n\n1. Before the first frame, and after a cut or a change of size: clear "
            "the images that are "
            "kept to zeros, fill the buffers.\n2. Each frame: write the engine's images.\n3. Fill the "
            "buffers that are refilled.\n";
        int number = 4;
        for (const PackedPass& pass : effect_.passes)
            put("{}. `{}`: {}; {}.\n", number++, pass.file, turn_of(pass.plan.turn), dispatch_of(pass.plan));
        for (const auto& [a, b] : effect_.plan.exchanged)
            put("{}. Exchange `{}` and `{}`.\n", number++, a, b);
        const auto moved = [](const PackedPass& pass) { return pass.plan.turn == Turn::moved; };
        if (std::ranges::any_of(effect_.passes, moved)) {
            text_ +=
                "\nIn a frame without `reproject.comp` bind `history_before` where the tables say "
                "`history_reprojected`. "
                "In the first frame it may run or not: it moves zeros.\n";
        }
        const effect::Plan& plan = effect_.plan;
        put("\nThe result is {}: occlusion, 1 where blocked, 0 at the background.\n",
            channel_of(plan.result, plan.result_unit));
    }

    static std::string channel_of(const std::string& image, float unit) {
        const std::string channel = fmt::format("the first channel of `{}`", image);
        return unit == 1.0F ? channel : fmt::format("{} times {}", channel, unit);
    }

    void images() {
        text_ +=
            "\n## Images and buffers\n\nAll images are in the layout `VK_IMAGE_LAYOUT_GENERAL` while passes "
            "run.\n\n"
            "| image | format | size | usage | what |\n| --- | --- | --- | --- | --- |\n";
        for (const PlannedImage& image : effect_.plan.images) {
            const char* origin = image.origin == PlannedImage::Origin::engine    ? "the engine's: "
                                 : image.origin == PlannedImage::Origin::history ? "kept: "
                                                                                 : "";
            put("| `{}` | {} | {} | {} | {}{} |\n", image.name, vulkan_format(image.format),
                size_of(effect_, image), fmt::join(vulkan_usage(effect_, image), ", "), origin,
                image.meaning);
        }
        if (effect_.plan.buffers.empty()) return;
        text_ += "\n| buffer | bytes | filled | what |\n| --- | --- | --- | --- |\n";
        for (const effect::PlannedBuffer& buffer : effect_.plan.buffers) {
            const std::string bytes =
                buffer.bytes_a_tile == 0
                    ? std::to_string(buffer.bytes)
                    : fmt::format("{} + {} for each {} x {} pixels of the view", buffer.contents.size(),
                                  buffer.bytes_a_tile, effect_.plan.tile, effect_.plan.tile);
            put("| `{}` | {} | {} | {} |\n", buffer.name, bytes,
                buffer.refilled ? "before each frame" : "once", buffer.meaning);
        }
    }

    void bindings() {
        text_ +=
            "\n## Bindings\n\nAll in descriptor set 0.\n\n| pass | binding | type | resource | in the shader "
            "| access |\n"
            "| --- | --- | --- | --- | --- | --- |\n";
        for (const PackedPass& pass : effect_.passes) {
            for (const shader::Binding& binding : pass.interface.bindings) {
                const char* access = binding.reads && binding.writes ? "read, write"
                                     : binding.writes                ? "write"
                                                                     : "read";
                put("| `{}` | {} | {} | `{}` | `{}`{} | {} |\n", pass.file, binding.number,
                    to_string(binding.type), resource_at(pass, binding), binding.name,
                    binding.format.empty() ? "" : ", " + binding.format, access);
            }
        }
    }

    void barriers() {
        text_ +=
            "\n## Barriers\n\nBefore the first pass: the engine's writes to its images, made visible to "
            "`VK_ACCESS_SHADER_READ_BIT` in `VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT`. Between passes, from "
            "that stage to that stage:\n\n"
            "| before | resource | after | access |\n| --- | --- | --- | --- |\n";
        for (std::size_t i = 0; i < effect_.passes.size(); ++i) {
            for (const Hazard& hazard : hazards_before(effect_, i))
                put("| `{}` | `{}` | `{}` | {} |\n", effect_.passes[i].file, hazard.resource, hazard.after,
                    hazard.written ? "shader write to shader read and write"
                                   : "execution only: read before it is written");
            if (effect_.passes[i].plan.list)
                put("| `{}` | `tile_lists` | the pass that writes it | shader write to "
                    "`VK_ACCESS_INDIRECT_COMMAND_READ_BIT` in `VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT` |\n",
                    effect_.passes[i].file);
        }
        text_ +=
            "\nFrom one frame to the next the images that are exchanged need the same: shader write to "
            "shader read and write.\n";
    }

    void constants() {
        text_ +=
            "\n## Push constants of the view\n\nAll other members have the preset's values in "
            "`gloam_effect.h`.\n\n"
            "| pass | member | what |\n| --- | --- | --- |\n";
        for (const PackedPass& pass : effect_.passes) {
            if (!pass.interface.push_constants) continue;
            for (const shader::LaidOut& member : pass.interface.push_constants->members)
                if (is_of_view(pass, member))
                    put("| `{}` | `{}` | {} |\n", pass.file, member.name,
                        comment_of(pass.text, pass.interface.push_constants->name, member.name));
        }
        half_view();
        text_ +=
            "\n## Specialization constants\n\nThe passes have these values already.\n\n| pass | id | name | "
            "value |\n"
            "| --- | --- | --- | --- |\n";
        for (const PackedPass& pass : effect_.passes)
            for (const shader::SpecializationConstant& constant : pass.interface.constants)
                put("| `{}` | {} | `{}` | {} |\n", pass.file, constant.id, constant.name, value_of(constant));
    }

    void half_view() {
        if (effect_.settings.resolution == effect::Resolution::full) return;
        text_ += "\nThe constants of";
        std::string separator = " ";
        for (const PackedPass& pass : effect_.passes) {
            if (pass.plan.divisor == 1 || pass.plan.turn == Turn::once) continue;
            put("{}`{}`", std::exchange(separator, ", "), pass.file);
        }
        text_ +=
            " are those of the half-size view: `gloam_half_view` in `gloam_effect.h` computes them from the "
            "view's. All other passes take the view's.\n";
    }

    void compile() {
        if (effect_.language != shader::Language::vulkan450) return;
        const std::string& name = effect_.passes.back().plan.name;
        put("\n## Compile\n\n    glslangValidator -V --target-env vulkan1.2 {0}.comp -o {0}.spv\n"
            "    spirv-opt -O --loop-invariant-code-motion --redundancy-elimination "
            "--eliminate-dead-code-aggressive {0}.spv -o {0}.spv\n\n"
            "The second line is what `gloam render` does as well; drivers of GPUs do without it.\n",
            name);
        if (effect_.target) translation(*effect_.target);
    }

    void translation(shader::Target target) {
        const bool hlsl = target == shader::Target::hlsl;
        put("\n## {}\n\nEach pass is there a second time, as `{}{}`. The numbers of its {} are those of the "
            "bindings above, and the push constants are {}. Their layouts in `gloam_effect.h` hold there, "
            "too.\n",
            hlsl ? "HLSL" : "Metal", effect_.passes.back().plan.name, shader::suffix(target),
            hlsl ? "registers" : "indices",
            hlsl ? "the constant buffer after the last uniform buffer" : "the buffer after the last binding");
    }

    const PackedEffect& effect_;
    std::string text_;
};

}  // namespace

std::string effect_page(const PackedEffect& effect) {
    return PageWriter(effect).run();
}

}  // namespace gloam::cli
