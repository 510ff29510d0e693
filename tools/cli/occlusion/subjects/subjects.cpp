// SPDX-License-Identifier: MIT
// What `gloam check` takes: equations, the study's passes, and the frame of each own preset.
#include <fmt/format.h>

#include <array>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "catalogue/catalogue.hpp"
#include "cli/environment.hpp"
#include "cli/occlusion/names.hpp"
#include "cli/occlusion/subjects/study_definitions.hpp"
#include "effect/methods.hpp"
#include "effect/planned_run.hpp"
#include "judge/run.hpp"
#include "module/include.hpp"
#include "numeric/numbers.hpp"
#include "pass/pass.hpp"
#include "scene/draw.hpp"
#include "scene/scene.hpp"

namespace gloam::cli {
namespace {

using namespace study;
using pass::Pass;
using pass::PassInputs;
using pass::PassResult;

// Judges an image that a pass wrote, pixel by pixel: the question's inputs are pixels. wanted: appends what
// one shall hold. promised: whether it is judged by the budget; none: each is.
judge::Answer judged(const subject::Lab& lab, judge::Question question, const subject::Image& image,
                     const std::string& scenario,
                     const std::function<void(ivec2, std::vector<double>&)>& wanted,
                     const std::function<bool(ivec2)>& promised = {}) {
    const auto pixel_of = [](std::span<const subject::Word> words) {
        return subject::take_words<ivec2>(words);
    };
    question.reference = [&](const auto&, auto words, std::vector<double>& outputs) {
        outputs.clear();
        wanted(pixel_of(words), outputs);
    };
    if (promised) question.promised = [&](auto words) { return promised(pixel_of(words)); };
    subject::Domain::Inputs inputs{.width = 2};
    for (int i = 0; i < image.size.x * image.size.y; ++i) {
        std::vector<subject::Word> words;
        subject::append_words(ivec2(i % image.size.x, i / image.size.x), words);
        inputs.add(words);
    }
    return judge::judge(question, {.edges = false, .nan = lab.keeps_nan()}, inputs, image.words, {},
                        scenario);
}

const Case cases[] = {
    {.name = "as printed"},
    {.name = "moving by confidence", .moving = true, .taps = 1, .invalidation = 2, .filter = "geometry"},
    {.name = "moving by clamp", .orthographic = true, .moving = true, .invalidation = 1, .filter_cap = 1.5F},
    {.name = "smoothed",
     .taps = 0,
     .smoothing = 0.25F,
     .rejects = true,
     .lattice = true,
     .filter = "bilateral"},
    {.name = "fewer",
     .least_radius = 4.0F,
     .radius_cap = 5.0F,
     .samples_distance = 400.0F,
     .samples_radius = 6.0F,
     .samples_least = 9,
     .filter = "sao"},
    {.name = "none far away",
     .moving = true,
     .invalidation = 1,
     .bias_depth = 0.04F,
     .samples_distance = 5.0F,
     .samples_least = 0,
     .border = {2, 1}}};

// Told what an image of a pass shall hold.
using Judge = std::function<void(const subject::Image& image, const std::function<Wanted(ivec2)>& wanted)>;

// The passes of both frames, as far as one of them needs the others. It is judged.
class Frames {
  public:
    Frames(const subject::Lab& lab, const Case& one, std::string judged, const Judge& judge)
        : lab_(lab), one_(one), judged_(std::move(judged)), judge_with_(judge) {}

    void run() {
        const glm::mat4 moved =
            glm::rotate(glm::translate(glm::mat4(1.0F), {0.21F, 0.05F, -0.33F}), 0.06F, {0.3F, 1, 0.1F});
        const float scale = one_.orthographic ? 0.25F : 1.0F;
        const View before =
            seen({scale * glm::vec2(1.2F, -1.6F), size, one_.orthographic}, glm::mat4(1.0F), dvec3(0.0));
        const View now = seen({scale * glm::vec2(1.15F, -1.5F), size, one_.orthographic}, moved,
                              one_.moving ? dvec3(0.2, 0.1, 0.3) : dvec3(0.0));
        const subject::Image history = occlusion_of(before, nullptr);
        const subject::Image reprojected_history =
            run("reproject", now, "depth_image", now.depth, "previous_position_image", now.positions,
                "previous_history", history, "moving_objects", one_.moving, "taps", one_.taps,
                "previous_orthographic", one_.orthographic, "previous_from_current", now.first_from_view,
                "previous_p00_p11", glm::vec2(before.camera.p00_p11), "depth_tolerance", 0.02F)
                .image("history");
        judge("reproject", reprojected_history,
              [&](ivec2 pixel) { return reprojected(one_, now, before, history, pixel); });
        if (judged_ == "reproject") return;
        const subject::Image after = occlusion_of(now, &reprojected_history);
        if (judged_ == "spatial_filter")
            (void)smoothed(now, after, smoothed(now, after, now.depth, false), true);
        if (judged_ != "remap") return;
        PassInputs inputs{{"size", size}};
        give(inputs, "depth_image", now.depth, "source_image", after, "remap_a", 0.1F, "remap_b", 0.9F,
             "remap_c", 1.5F);
        judge("remap", pass("remap").run(inputs).image("mapped_image"), [&](ivec2 pixel) -> Wanted {
            const double own = after.at<dvec4>(pixel).x;
            const double mapped =
                1.0 - std::pow(std::max(double{0.9F} * (1.0 - own + double{0.1F}), 0.0), 1.5);
            return {dvec4(std::isinf(now.depth.at<double>(pixel)) ? own : std::max(mapped, 0.0))};
        });
    }

  private:
    void judge(const std::string& name, const subject::Image& image,
               const std::function<Wanted(ivec2)>& wanted) {
        if (name == judged_) judge_with_(image, wanted);
    }

    // With the filter of the case.
    [[nodiscard]] pass::Pass pass(const std::string& name) const {
        const std::filesystem::path path =
            module::resolve_include("passes/study/" + name + ".comp", {}, lab_.options().include_roots);
        std::string text = module::read_text(path);
        const std::string usual = "filters/convergence";
        if (const std::size_t at = text.find(usual); at != std::string::npos)
            text.replace(at, usual.size(), "passes/study/filters/" + one_.filter);
        return {lab_, name, lab_.cache().compile({path.string(), text}, lab_.compile_options())};
    }

    // The values of a pass by their names, and those of the camera.
    template <class... Values>
    [[nodiscard]] pass::PassResult run(const std::string& name, const View& view,
                                       const Values&... values) const {
        PassInputs inputs{{"size", size}};
        give(inputs, "p00_p11", glm::vec2(view.camera.p00_p11), "orthographic", view.camera.orthographic,
             values...);
        return pass(name).run(inputs);
    }
    template <class Value, class... Rest>
    static void give(PassInputs& inputs, const char* name, const Value& value, const Rest&... rest) {
        inputs.insert_or_assign(name, value);
        if constexpr (sizeof...(Rest) > 0) give(inputs, rest...);
    }

    // The history of a view; before: that of the frame before, at its pixels.
    [[nodiscard]] subject::Image occlusion_of(const View& view, const subject::Image* before) {
        const effect::MethodValues method{.range = range};
        const pass::PassResult result =
            run("ambient_occlusion", view, "depth_image", view.depth, "normal_image", view.normal,
                "layer_image", view.normal, "prepared_image", view.normal, "history_before",
                before == nullptr ? view.normal : *before, "previous_position_image", view.positions,
                "method_values", method, "keeps_history", before != nullptr, "watches_objects",
                before != nullptr && one_.invalidation > 0, "table_size", table_size, "reject_taps",
                one_.rejects, "on_lattice", one_.lattice, "samples_asked", 16U, "samples_converged", 8U,
                "border", one_.border, "radius", radius, "bias", bias, "c_spatial", c_spatial, "weight_max",
                weight_max, "c_rot", 0.5F, "least_radius", one_.least_radius, "shade_border", 0U,
                "invalidation", one_.invalidation, "change_tolerance", change_tolerance, "weight_small", 5.0F,
                "confidence_factor", confidence_factor, "samples_distance", one_.samples_distance,
                "samples_radius", one_.samples_radius, "samples_least", one_.samples_least, "radius_cap",
                one_.radius_cap, "smoothing", one_.smoothing, "bias_depth", one_.bias_depth);
        const subject::Image& after = result.image("history_after");
        judge("ambient_occlusion", after, [&](ivec2 pixel) { return blended(one_, view, before, pixel); });
        return after;
    }

    [[nodiscard]] subject::Image smoothed(const View& view, const subject::Image& history,
                                          const subject::Image& along_x, bool along_y) {
        const pass::PassResult result =
            run("spatial_filter", view, "history_image", history, "normal_image", view.normal,
                "along_x_image", along_x, "along_y", along_y, "filter_half_width", half_width, "sigma_pixels",
                sigma_pixels, "filter_depth", filter_depth, "c_adaptive", c_adaptive, "weight_max",
                weight_max, "filter_cap", one_.filter_cap);
        const ivec2 axis(along_y ? 0 : 1, along_y ? 1 : 0);
        const subject::Image& source = along_y ? along_x : history;
        judge("spatial_filter", result.image("filtered_image"), [&](ivec2 pixel) -> Wanted {
            return {dvec4(filtered(one_, view, history, source, pixel, axis))};
        });
        return result.image("filtered_image");
    }

    const subject::Lab& lab_;
    const Case& one_;
    std::string judged_;
    const Judge& judge_with_;
};

// Whether a pixel is another than it shall be where a decision lies within rounding.
bool is_tied(const subject::Image& image, ivec2 pixel, const Wanted& wanted) {
    if (!wanted.tied) return false;
    const dvec4 got = image.element.rows == 1 ? dvec4(image.at<double>(pixel)) : image.at<dvec4>(pixel);
    for (int c = 0; c < image.element.rows; ++c)
        if (numeric::absolute_error(got[c], wanted.value[c]) > 1e-6 * std::max(1.0, wanted.value[c]))
            return true;
    return false;
}

// The answer to the question of a pass of that name.
judge::Answer answered(const subject::Lab& lab, const judge::Question& question, const std::string& pass) {
    judge::Answer answer = judge::empty_answer(question, judge::Criterion::budget);
    for (const Case& one : cases) {
        if (pass == "remap" && &one != cases) break;  // it has no other
        Frames(lab, one, pass, [&](const subject::Image& image, const std::function<Wanted(ivec2)>& wanted) {
            constexpr int most_ties = 3;
            int ties = 0;
            for (int i = 0; i < size.x * size.y; ++i)
                ties += is_tied(image, {i % size.x, i / size.x}, wanted({i % size.x, i / size.x})) ? 1 : 0;
            answer.merge(judged(
                lab, question, image, one.name,
                [&](ivec2 pixel, std::vector<double>& numbers) {
                    const dvec4 value = wanted(pixel).value;
                    numbers.assign(&value[0], &value[0] + image.element.rows);
                },
                [&](ivec2 pixel) { return ties > most_ties || !is_tied(image, pixel, wanted(pixel)); }));
        }).run();
    }
    answer.variant = lab.options().variant.name;
    if (answer.failed()) answer.story = describe(question.signature, answer);
    return answer;
}

// The study's passes ("PASS-reproject"), each run as it is on two frames of a moving camera, with several
// settings. Every pixel is judged by what the paper's equations give in double for the same images; where a
// decision of theirs lies within rounding, nothing is promised.
std::vector<judge::Question> study_passes() {
    std::vector<judge::Question> questions;
    for (const std::string pass : {"reproject", "ambient_occlusion", "spatial_filter", "remap"}) {
        std::string name = pass;
        std::ranges::replace(name, '_', '-');
        const bool history = pass == "reproject" || pass == "ambient_occlusion";
        judge::Question question{.name = "PASS-" + name,
                                 .file = "passes/study/" + pass + ".comp",
                                 .function = "main",
                                 .signature = history ? subject::SignatureOf<glm::vec4(ivec2)>::describe()
                                                      : subject::SignatureOf<float(ivec2)>::describe(),
                                 .budget = {.ulp = 8, .absolute = 1e-6}};
        question.answers = [question, pass](const subject::Lab& lab) {
            return answered(lab, question, pass);
        };
        questions.push_back(std::move(question));
    }
    return questions;
}

// By the meaning of its texels: of 32 bits the codes of depth, occlusion and weight, and what moved.
subject::Image by_meaning(const subject::Image& image) {
    if (image.element.scalar == module::Scalar::float_) return image;
    return subject::make_image<glm::vec4>(image.size, [&](glm::ivec2 pixel) {
        const auto code = image.at<std::uint32_t>(pixel);
        return glm::vec4(code & 0xFFFFU, code >> 16U & 0xFFU, code >> 25U, 2U * (code >> 24U & 1U));
    });
}

// A pass may round what it writes to 16 bits up or down, and an occlusion or a weight to a code.
judge::Budget budget_of(const std::string& image, const subject::Image& texels) {
    if (texels.element.scalar != module::Scalar::float_) return {.absolute = 1.0};
    return image == "levels" ? judge::Budget{.ulp = 8192} : judge::Budget{.absolute = 1e-5};
}

// An image of the device beside that of the interpreter.
void judge(const subject::Lab& lab, judge::Question question, const std::string& name,
           const std::string& scenario, const subject::Image& written, const subject::Image& expected,
           judge::Answer& answer) {
    const subject::Image got = by_meaning(written);
    const subject::Image want = by_meaning(expected);
    question.budget = budget_of(name, expected);
    question.signature.result = got.element;
    const judge::Answer part =
        judged(lab, question, got, scenario, [&](glm::ivec2 pixel, std::vector<double>& numbers) {
            if (want.element.rows == 1) return numbers.push_back(want.at<double>(pixel));
            subject::append_numbers(want.at<glm::dvec4>(pixel), numbers);
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
judge::Answer frame_answer(const subject::Lab& lab, const judge::Question& question,
                           effect::Settings settings) {
    settings.output = effect::OutputFormat::r32f;
    settings.history = false;
    const scene::GBuffer view = small_view();
    const scene::PassLibrary passes(glsl_directory(), cache_directory());
    const subject::Lab interpreter({.device = std::string(subject::interpreter_name)});
    effect::Plan plan = effect::plan_of(settings, {.view = view.extent}, passes);
    effect::PlanMemory memory(plan, view);
    judge::Answer answer = judge::empty_answer(question, judge::Criterion::budget);
    for (const effect::PlannedPass& pass : std::vector(plan.passes)) {
        plan.passes = {pass};
        const effect::PlanMemory before = memory;
        effect::PlanMemory expected = memory;
        effect::run(interpreter, plan, passes, expected);
        effect::run(lab, plan, passes, memory);
        for (const auto& [name, levels] : expected.images)
            for (std::size_t level = 0; level < levels.size(); ++level) {
                const std::vector<subject::Word>& was = before.images.at(name)[level].words;
                const subject::Image& written = memory.images.at(name)[level];
                if (levels[level].words != was || written.words != was)  // the pass writes it
                    judge(lab, question, name, fmt::format("{}: {}/{}", pass.name, name, level), written,
                          levels[level], answer);
            }
    }
    answer.variant = lab.options().variant.name;
    return answer;
}

std::vector<judge::Question> passes() {
    std::vector<judge::Question> all = study_passes();
    for (const effect::Preset& preset : effect::presets()) {
        if (preset.published) continue;
        judge::Question question{.name = "PASS-frame-" + preset.name,
                                 .file = "passes/frame",
                                 .function = "main",
                                 .signature = subject::SignatureOf<glm::vec4(glm::ivec2)>::describe(),
                                 .budget = {.absolute = 1e-5}};
        question.answers = [question, settings = preset.settings](const subject::Lab& lab) {
            return frame_answer(lab, question, settings);
        };
        all.push_back(std::move(question));
    }
    return all;
}

}  // namespace

std::vector<judge::Question> subjects_named(const std::vector<std::string>& names) {
    std::vector<judge::Question> found = passes();
    const auto fits = [](const judge::Question& pass, const std::string& name) {
        return catalogue::matches_glob(pass.name, name);
    };
    std::vector<std::string> others;
    for (const std::string& name : names) {
        const bool known = std::ranges::any_of(found, [&](const auto& pass) { return fits(pass, name); });
        if (!known || !catalogue::matches_glob(name, "PASS-*")) others.push_back(name);
    }
    std::erase_if(found, [&](const judge::Question& pass) {
        return !names.empty() &&
               std::ranges::none_of(names, [&](const std::string& name) { return fits(pass, name); });
    });
    if (!names.empty() && others.empty()) return found;
    std::vector<judge::Question> all = equations_named(others);
    std::ranges::move(found, std::back_inserter(all));
    return all;
}

}  // namespace gloam::cli
