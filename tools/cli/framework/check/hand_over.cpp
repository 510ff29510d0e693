// SPDX-License-Identifier: MIT
#include "cli/framework/check/hand_over.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>

#include "backend/sampled.hpp"
#include "base/text.hpp"
#include "judge/answer.hpp"
#include "judge/reproduction.hpp"
#include "module/spirv.hpp"
#include "numeric/numbers.hpp"
#include "record/failures.hpp"
#include "subject/lab.hpp"

namespace gloam::cli {
namespace {

std::string output_comment(const check::Reproduction& all, std::size_t i) {
    if (!all.failure) return "not judged";
    const check::Word word = all.failure->got[i];
    const std::string got = shader::is_float(all.outputs[i]) ? check::text_of(all.outputs[i], word)
                                                             : fmt::format("0x{:08x}", word);
    return fmt::format("here it was {}; the reference gives {}", got, numeric::to_text(all.failure->want[i]));
}

// A sampled image with its texels as the device has them.
std::vector<check::Word> encoded(const std::vector<check::Word>& image) {
    std::vector<check::Word> result(image.begin(), image.begin() + backend::sampled_header_words);
    const std::vector<check::Word> texels = backend::stored_texels(image);
    result.insert(result.end(), texels.begin(), texels.end());
    return result;
}

record::KernelReplay replay_of(const check::Reproduction& all, const check::Question& question,
                               const CheckTask& task, const backend::DeviceInfo& device,
                               const std::string& how) {
    record::KernelReplay replay{
        .assembly = all.assembly, .inputs = all.inputs, .specialized = all.specialized};
    replay.comments = {fmt::format("{}: {} of {}, variant {}", task.equation, question.function,
                                   question.file, task.variant),
                       fmt::format("Found on: {} ({})", device.name, device.driver),
                       fmt::format("Input: {}", check::describe_inputs(question.signature, all.inputs)),
                       "Run it with: " + how};
    if (device.name != check::interpreter_name) replay.device = device.name;
    if (!all.scenario.empty()) replay.comments.push_back("Images: " + all.scenario);
    for (const check::Reproduction::ImageBuffer& image : all.images)
        replay.images.push_back({.name = image.name,
                                 .words = image.bound ? encoded(image.words) : image.words,
                                 .sampled = image.bound});
    for (std::size_t i = 0; i < all.outputs.size(); ++i) {
        replay.outputs.push_back({.is_float = all.outputs[i] == shader::Scalar::float_,
                                  .found = all.failure ? all.failure->got[i] : 0,
                                  .comment = output_comment(all, i)});
    }
    replay.outcomes = all.outcomes;
    return replay;
}

// The module that failed, then the one before the steps, if it is another.
std::vector<record::ReplayedModule> modules_of(const check::Reproduction& all) {
    std::vector<record::ReplayedModule> modules{
        {all.before.empty() ? "the module" : "after the steps", all.spirv}};
    if (!all.before.empty() && all.before != all.spirv) modules.push_back({"before the steps", all.before});
    return modules;
}

check::Reproduction reproduction_of(const check::Lab& lab, const check::Question& question,
                                    const HandOverRequest& request, const check::RunOptions& options) {
    if (!request.ran) return check::reproduce(lab, question, options);
    if (request.worst) return check::reproduce(lab, question, options, *request.worst);
    return check::reproduce_fault(lab, question, options);
}

}  // namespace

HandOverRequest request_for(const CheckTask& task, const check::Answer& row) {
    HandOverRequest request{.task = task, .ran = row.ran(), .worst = std::nullopt};
    if (row.outside() > 0) request.worst = row.worst;
    return request;
}

HandOver make_hand_over(const check::Lab& lab, const check::Question& question,
                        const HandOverRequest& request, const check::RunOptions& options) {
    const check::Reproduction all = reproduction_of(lab, question, request, options);
    const backend::DeviceInfo& device = lab.info();
    const auto replay = [&](const std::string& how) {
        return replay_of(all, question, request.task, device, how);
    };
    HandOver hand_over;
    if (!all.opengl.empty()) {
        hand_over.glsl = all.opengl;
    } else {
        hand_over = {.glsl = all.glsl, .assembly = all.assembly, .spirv = all.spirv};
        // They run compute shaders and ask for no features.
        if (all.team.kind != backend::Team::Kind::quad && !shader::has_float16(all.spirv)) {
            // The script has no images; the program has those of single samplers, not of layers.
            const bool has_images = std::ranges::any_of(all.images, &check::Reproduction::ImageBuffer::bound);
            const bool has_layers = std::ranges::any_of(
                all.images, [](const auto& image) { return image.bound && image.words.empty(); });
            if (!has_images) hand_over.amber = record::to_amber(replay("amber -v 1.2 -t spv1.5 repro.amber"));
            if (!has_layers)
                hand_over.c_program = record::to_c_program(
                    replay("cc repro.c -o repro -lvulkan -lm && ./repro"), modules_of(all));
        }
        hand_over.steps = all.steps;
        hand_over.before = all.before;
    }
    hand_over.rules = all.rules;
    hand_over.smallest = all.failure;
    return hand_over;
}

namespace {

std::string_view bytes_of(const std::vector<std::uint32_t>& words) {
    const auto bytes = std::as_bytes(std::span(words));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

FailureFolders::FailureFolders(std::filesystem::path folder) {
    if (!folder.empty()) folder_.emplace(std::move(folder));
}

std::filesystem::path FailureFolders::write(const record::DeviceSummary& device, const check::Answer& row,
                                            const HandOver& hand_over, const record::RunAgain& again) {
    const std::string name = record::slug(row.equation) + "-" + record::slug(row.variant);
    record::OutputFolder out(folder_->path() / record::slug(record::name_of(device)) / name);
    const std::string note =
        hand_over.error.empty() ? "" : "The shader and a reproduction could not be made: " + hand_over.error;
    record::RunAgain how = again;
    how.amber = !hand_over.amber.empty();
    how.program = !hand_over.c_program.empty();
    how.steps = hand_over.steps;
    how.rules = hand_over.rules;
    out.write("report.txt", record::failure_text(device, row, hand_over.smallest, note, how));
    if (hand_over.error.empty() && hand_over.spirv.empty()) {  // of OpenGL
        out.write("shader.glsl", hand_over.glsl);
    } else if (hand_over.error.empty()) {
        out.write("shader.comp", hand_over.glsl);
        out.write("shader.spvasm", hand_over.assembly);
        out.write("shader.spv", bytes_of(hand_over.spirv));
        if (!hand_over.amber.empty()) out.write("repro.amber", hand_over.amber);
        if (!hand_over.c_program.empty()) out.write("repro.c", hand_over.c_program);
        if (!hand_over.before.empty()) out.write("before.spv", bytes_of(hand_over.before));
    }
    out.keep();
    folder_->keep();
    return out.path();
}

}  // namespace gloam::cli
