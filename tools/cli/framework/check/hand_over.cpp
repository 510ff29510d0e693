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
#include "record/failures.hpp"
#include "subject/lab.hpp"

namespace gloam::cli {
namespace {

// The lines at the top of a program that repeats it.
std::vector<std::string> comments_of(const check::Reproduction& all, const check::Question& question,
                                     const CheckTask& task, const backend::DeviceInfo& device,
                                     const std::string& how) {
    std::vector<std::string> comments{
        fmt::format("{}: {} of {}, variant {}", task.equation, question.function, question.file,
                    task.variant),
        fmt::format("Found on: {} ({})", device.name, device.driver),
        fmt::format("Input: {}", check::describe_inputs(question.signature, all.inputs)),
        "Run it with: " + how};
    if (!all.scenario.empty()) comments.push_back("Images: " + all.scenario);
    return comments;
}

// With sampled images whose texels are as the device has them.
check::Reproduction encoded(check::Reproduction all) {
    for (check::Reproduction::ImageBuffer& image : all.images) {
        if (!image.bound) continue;
        const std::vector<check::Word> texels = backend::stored_texels(image.words);
        image.words.resize(backend::sampled_header_words);
        image.words.insert(image.words.end(), texels.begin(), texels.end());
    }
    return all;
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
    const auto comments = [&](const std::string& how) {
        return comments_of(all, question, request.task, device, how);
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
            if (!has_images)
                hand_over.amber = record::to_amber(all, comments("amber -v 1.2 -t spv1.5 repro.amber"));
            if (!has_layers)
                hand_over.c_program = record::to_c_program(
                    encoded(all), comments("cc repro.c -o repro -lvulkan -lm && ./repro"),
                    device.name == check::interpreter_name ? "" : device.name);
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
