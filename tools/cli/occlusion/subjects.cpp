// SPDX-License-Identifier: MIT
// What `gloam check` takes: equations, the study's passes, and the frame of each own preset.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "catalogue/catalogue.hpp"
#include "catalogue/passes.hpp"
#include "cli/environment.hpp"
#include "cli/occlusion/names.hpp"
#include "effect/planned_run.hpp"
#include "judge/run.hpp"
#include "scene/draw.hpp"
#include "scene/scene.hpp"

namespace gloam::cli {
namespace {

using check::Image;

// By the meaning of its texels: of 32 bits the codes of depth, occlusion and weight, and what moved.
Image by_meaning(const Image& image) {
    if (image.element.scalar == shader::Scalar::float_) return image;
    return check::make_image<glm::vec4>(image.size, [&](glm::ivec2 pixel) {
        const auto code = image.at<std::uint32_t>(pixel);
        return glm::vec4(code & 0xFFFFU, code >> 16U & 0xFFU, code >> 25U, 2U * (code >> 24U & 1U));
    });
}

// A pass may round what it writes to 16 bits up or down, and an occlusion or a weight to a code.
check::Budget budget_of(const std::string& image, const Image& texels) {
    if (texels.element.scalar != shader::Scalar::float_) return {.absolute = 1.0};
    return image == "levels" ? check::Budget{.ulp = 8192} : check::Budget{.absolute = 1e-5};
}

// Every pass on the device, and on the interpreter with what the device has written before.
check::Answer frame_answer(const check::Lab& lab, const check::Question& question,
                           const effect::Preset& preset) {
    // Whole groups of all passes: no store is outside an image.
    scene::GBuffer view = scene::draw(scene::make_scene("columns"), {32, 16}, {});
    constexpr std::array no_depths{NAN, INFINITY, -INFINITY, 0.0F, -1.0F, 1e30F};
    for (std::size_t i = 0; i < view.depth.size(); i += 7) view.depth[i] = no_depths.at(i % no_depths.size());
    const scene::PassLibrary passes(glsl_directory(), cache_directory());
    const check::Lab interpreter({.device = std::string(check::interpreter_name)});
    effect::Settings settings = preset.settings;
    settings.output = effect::OutputFormat::r32f;
    settings.history = false;
    effect::Plan plan = effect::plan_of(settings, {.view = view.extent}, passes);
    effect::PlanMemory memory(plan, view);
    check::Answer answer = check::empty_answer(question, check::Verdict::budget);
    for (const effect::PlannedPass& pass : std::vector(plan.passes)) {
        plan.passes = {pass};
        const effect::PlanMemory before = memory;
        effect::PlanMemory wanted = memory;
        effect::run(interpreter, plan, passes, wanted);
        effect::run(lab, plan, passes, memory);
        for (const auto& [name, levels] : wanted.images)
            for (std::size_t level = 0; level < levels.size(); ++level) {
                const auto holds = [&, &name = name](const effect::PlanMemory& all) -> const Image& {
                    return all.images.at(name)[level];
                };
                if (levels[level].words == holds(before).words && holds(memory).words == holds(before).words)
                    continue;  // the pass does not write it
                const Image got = by_meaning(holds(memory));
                const Image want = by_meaning(levels[level]);
                check::Question of_image = question;
                of_image.budget = budget_of(name, levels[level]);
                of_image.signature.result = got.element;
                const auto wanted = [&](glm::ivec2 pixel, std::vector<double>& numbers) {
                    if (want.element.rows == 1) return numbers.push_back(want.at<double>(pixel));
                    check::append_numbers(want.at<glm::dvec4>(pixel), numbers);
                };
                const check::Answer part = catalogue::judged(
                    lab, of_image, got, fmt::format("{}: {}/{}", pass.name, name, level), wanted);
                answer.merge(part);
                if (part.failed()) answer.story += describe(of_image.signature, part);
            }
    }
    answer.variant = lab.options().variant.name;
    return answer;
}

std::vector<check::Question> passes() {
    std::vector<check::Question> all = catalogue::study_passes();
    for (const effect::Preset& preset : effect::presets()) {
        if (preset.published) continue;
        check::Question question{.name = "PASS-frame-" + preset.name,
                                 .file = "passes/frame",
                                 .function = "main",
                                 .signature = check::SignatureOf<glm::vec4(glm::ivec2)>::describe(),
                                 .budget = {.absolute = 1e-5}};
        question.answers = [question, preset](const check::Lab& lab) {
            return frame_answer(lab, question, preset);
        };
        all.push_back(std::move(question));
    }
    return all;
}

}  // namespace

std::vector<check::Question> subjects_named(const std::vector<std::string>& names) {
    std::vector<check::Question> all;
    std::vector<std::string> others;
    const std::vector<check::Question> known = passes();
    for (const std::string& name : names) {
        const std::size_t before = all.size();
        std::ranges::copy_if(known, std::back_inserter(all), [&](const check::Question& pass) {
            return catalogue::matches_glob(pass.name, name);
        });
        if (all.size() == before) others.push_back(name);
    }
    if (!names.empty() && others.empty()) return all;
    std::vector<check::Question> equations = equations_named(others);
    equations.insert(equations.end(), all.begin(), all.end());
    if (names.empty()) equations.insert(equations.end(), known.begin(), known.end());
    return equations;
}

}  // namespace gloam::cli
