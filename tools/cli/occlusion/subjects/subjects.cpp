// SPDX-License-Identifier: MIT
// What `gloam check` takes: equations, the study's passes, and the frame of each own preset.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "catalogue/catalogue.hpp"
#include "cli/environment.hpp"
#include "cli/occlusion/names.hpp"
#include "cli/occlusion/subjects/passes.hpp"
#include "effect/methods.hpp"
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

// An image of the device beside that of the interpreter.
void judge(const check::Lab& lab, check::Question question, const std::string& name,
           const std::string& scenario, const Image& written, const Image& expected, check::Answer& answer) {
    const Image got = by_meaning(written);
    const Image want = by_meaning(expected);
    question.budget = budget_of(name, expected);
    question.signature.result = got.element;
    const check::Answer part =
        judged(lab, question, got, scenario, [&](glm::ivec2 pixel, std::vector<double>& numbers) {
            if (want.element.rows == 1) return numbers.push_back(want.at<double>(pixel));
            check::append_numbers(want.at<glm::dvec4>(pixel), numbers);
        });
    answer.merge(part);
    if (part.failed()) answer.story += describe(question.signature, part);
}

// Whole groups of all passes, so that no store is outside an image; with what is no depth.
scene::GBuffer small_view() {
    scene::GBuffer view = scene::draw(scene::make_scene("columns"), {32, 16}, {});
    constexpr std::array no_depths{NAN, INFINITY, -INFINITY, 0.0F, -1.0F, 1e30F};
    for (std::size_t i = 0; i < view.depth.size(); i += 7) view.depth[i] = no_depths.at(i % no_depths.size());
    return view;
}

// Every pass on the device, and on the interpreter with what the device has written before.
check::Answer frame_answer(const check::Lab& lab, const check::Question& question,
                           effect::Settings settings) {
    settings.output = effect::OutputFormat::r32f;
    settings.history = false;
    const scene::GBuffer view = small_view();
    const scene::PassLibrary passes(glsl_directory(), cache_directory());
    const check::Lab interpreter({.device = std::string(check::interpreter_name)});
    effect::Plan plan = effect::plan_of(settings, {.view = view.extent}, passes);
    effect::PlanMemory memory(plan, view);
    check::Answer answer = check::empty_answer(question, check::Verdict::budget);
    for (const effect::PlannedPass& pass : std::vector(plan.passes)) {
        plan.passes = {pass};
        const effect::PlanMemory before = memory;
        effect::PlanMemory expected = memory;
        effect::run(interpreter, plan, passes, expected);
        effect::run(lab, plan, passes, memory);
        for (const auto& [name, levels] : expected.images)
            for (std::size_t level = 0; level < levels.size(); ++level) {
                const std::vector<check::Word>& was = before.images.at(name)[level].words;
                const Image& written = memory.images.at(name)[level];
                if (levels[level].words != was || written.words != was)  // the pass writes it
                    judge(lab, question, name, fmt::format("{}: {}/{}", pass.name, name, level), written,
                          levels[level], answer);
            }
    }
    answer.variant = lab.options().variant.name;
    return answer;
}

std::vector<check::Question> passes() {
    std::vector<check::Question> all = study_passes();
    for (const effect::Preset& preset : effect::presets()) {
        if (preset.published) continue;
        check::Question question{.name = "PASS-frame-" + preset.name,
                                 .file = "passes/frame",
                                 .function = "main",
                                 .signature = check::SignatureOf<glm::vec4(glm::ivec2)>::describe(),
                                 .budget = {.absolute = 1e-5}};
        question.answers = [question, settings = preset.settings](const check::Lab& lab) {
            return frame_answer(lab, question, settings);
        };
        all.push_back(std::move(question));
    }
    return all;
}

}  // namespace

std::vector<check::Question> subjects_named(const std::vector<std::string>& names) {
    std::vector<check::Question> found = passes();
    const auto fits = [](const check::Question& pass, const std::string& name) {
        return catalogue::matches_glob(pass.name, name);
    };
    std::vector<std::string> others;
    for (const std::string& name : names) {
        const bool known = std::ranges::any_of(found, [&](const auto& pass) { return fits(pass, name); });
        if (!known || !catalogue::matches_glob(name, "PASS-*")) others.push_back(name);
    }
    std::erase_if(found, [&](const check::Question& pass) {
        return !names.empty() &&
               std::ranges::none_of(names, [&](const std::string& name) { return fits(pass, name); });
    });
    if (!names.empty() && others.empty()) return found;
    std::vector<check::Question> all = equations_named(others);
    std::ranges::move(found, std::back_inserter(all));
    return all;
}

}  // namespace gloam::cli
