// SPDX-License-Identifier: MIT
#include "cli/pack/effect_command.hpp"

#include <stdexcept>

#include "cli/environment.hpp"
#include "cli/pack/effect.hpp"
#include "cli/render.hpp"
#include "cli/render_settings.hpp"
#include "cli/view_size.hpp"
#include "report/output_folder.hpp"

namespace gloam::cli {

void pack_effect(const EffectPackOptions& options) {
    if (options.out.empty()) throw std::invalid_argument("--effect: give --out, the folder to write");
    const RenderOptions as_rendered{
        .method = options.method, .preset = options.preset, .radius = options.radius, .set = options.set};
    const effect::Settings settings = settings_for(as_rendered, {});
    const effect::PlanOptions plan{.view = parse_size(options.size),
                                   .moving_objects = options.moving_objects,
                                   .orthographic = options.orthographic,
                                   .tiles = options.tiles,
                                   .normals = !options.reconstruct_normals,
                                   .encoding = scene::encoding_named(options.depth, options.normals)};
    const auto language = shader::language_from(options.version);
    if (!language || shader::usual_stage(*language) != shader::Stage::compute)
        throw std::invalid_argument("--effect --version " + options.version +
                                    ": expected 450, 310es or 320es");
    report::OutputFolder folder(options.out);
    PackedEffect effect = packed_effect(settings, plan, scene::PassLibrary(glsl_directory()), *language);
    effect.preset = options.preset;
    effect.version = GLOAM_VERSION;
    effect.target = options.target;
    for (const PackedPass& pass : effect.passes) {
        folder.write(pass.file, pass.text);
        if (options.target)
            folder.write(pass.plan.name + shader::suffix(*options.target),
                         shader::translated({.name = pass.file, .text = pass.text}, *options.target));
    }
    folder.write("gloam_effect.h", effect_header(effect));
    folder.write("effect.json", effect_json(effect));
    folder.write("README.md", effect_page(effect));
    folder.keep();
}

}  // namespace gloam::cli
