// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "backend/sampled.hpp"
#include "cli/framework/check/worker.hpp"
#include "cli/framework/open_device.hpp"
#include "judge/answer.hpp"
#include "judge/reproduction.hpp"
#include "module/spirv.hpp"
#include "record/failures.hpp"
#include "subject/lab.hpp"

namespace gloam::cli {
namespace {

using record::FailureBundle;

// The lines at the top of a program that repeats it.
std::vector<std::string> comments_of(const judge::Reproduction& all, const judge::Question& question,
                                     const CheckTask& task, const backend::DeviceInfo& device,
                                     const std::string& how) {
    std::vector<std::string> comments{
        fmt::format("{}: {} of {}, variant {}", task.identity.equation, question.function, question.file,
                    task.identity.variant),
        fmt::format("Found on: {} ({})", device.name, device.driver),
        all.count > 1
            ? fmt::format("Inputs: {}, of which number {} fails beside the others", all.count, all.failing)
            : fmt::format("Input: {}", judge::describe_inputs(question.signature, all.inputs)),
        "Run it with: " + how};
    if (!all.scenario.empty()) comments.push_back("Images: " + all.scenario);
    return comments;
}

// With sampled images whose texels are as the device has them.
judge::Reproduction encoded(judge::Reproduction all) {
    for (judge::Reproduction::ImageBuffer& image : all.images) {
        if (!image.bound) continue;
        const std::vector<subject::Word> texels = backend::stored_texels(image.words);
        image.words.resize(backend::sampled_header_words);
        image.words.insert(image.words.end(), texels.begin(), texels.end());
    }
    return all;
}

std::string_view bytes_of(const std::vector<std::uint32_t>& words) {
    const auto bytes = std::as_bytes(std::span(words));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// What builds and runs the program on its device.
std::string program_command(const std::string& device, const std::string& manifest) {
    return fmt::format("cc repro.c -o repro -lvulkan -lm && {}./repro", loader_words(device, manifest));
}

}  // namespace

FailureBundle bundle_of(const subject::Lab& lab, const judge::Question& question, const CheckTask& task,
                        const judge::Answer& failed) {
    FailureBundle bundle{.reproduction = !failed.ran() ? judge::reproduce(lab, question, task.run)
                                         : failed.outside() > 0
                                             ? judge::reproduce(lab, question, task.run, failed.worst.value())
                                             : judge::reproduce_fault(lab, question, task.run)};
    const judge::Reproduction& all = bundle.reproduction;
    const backend::DeviceInfo& device = lab.info();
    // The script and the program run compute shaders on Vulkan, and ask for no features.
    if (!all.opengl.empty() || all.team.kind == backend::Team::Kind::quad || module::has_float16(all.spirv))
        return bundle;
    // The script has one input and no images; the program has those of single samplers, not of layers.
    const bool has_images = std::ranges::any_of(all.images, &judge::Reproduction::ImageBuffer::bound);
    const bool has_layers =
        std::ranges::any_of(all.images, [](const auto& image) { return image.bound && image.words.empty(); });
    if (!has_images && all.count == 1)
        bundle.amber = record::to_amber(
            all, comments_of(all, question, task, device, "amber -v 1.2 -t spv1.5 repro.amber"));
    if (!has_layers)
        bundle.c_program = record::to_c_program(
            encoded(all), comments_of(all, question, task, device, program_command(device.name, {})),
            device.name == subject::interpreter_name ? "" : device.name);
    return bundle;
}

void write_failure(record::OutputFolder& folder, const std::string& name, const record::DeviceSummary& device,
                   const judge::Answer& row, const FailureBundle& bundle, const std::string& command) {
    record::OutputFolder out(folder.path() / record::slug(name) /
                             (record::slug(row.equation) + "-" + record::slug(row.variant)));
    out.write("report.txt", record::failure_text(device, row, bundle, command, versions(),
                                                 program_command(device.name, device.manifest)));
    const judge::Reproduction& all = bundle.reproduction;
    const auto write = [&](const char* name, std::string_view bytes) {
        if (!bytes.empty()) out.write(name, bytes);
    };
    write("shader.glsl", all.opengl);
    if (all.opengl.empty()) {
        write("shader.comp", all.glsl);
        write("shader.spvasm", all.assembly);
        write("shader.spv", bytes_of(all.spirv));
        write("before.spv", bytes_of(all.before));
    }
    write("repro.amber", bundle.amber);
    write("repro.c", bundle.c_program);
    out.keep();
    folder.keep();
}

}  // namespace gloam::cli
