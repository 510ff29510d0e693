// SPDX-License-Identifier: MIT
#include "check/internal/gl_kernel.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "base/text.hpp"
#include "check/internal/kernel_rows.hpp"
#include "check/interpreted_kernel.hpp"
#include "shader/pack.hpp"
#include "shader/spirv.hpp"

namespace gloam::check::internal {
namespace {

// What the memory behind the outputs holds before the dispatch and must hold after it.
constexpr Word guard_pattern = 0xdeadbeefU;
constexpr std::size_t guard_words = 64;
constexpr std::size_t fault_words = sizeof(KernelFaults) / sizeof(Word);
constexpr std::size_t most_groups = 65'535;  // that every version has

gl::Program make_program(const gl::Device& device, const KernelModule& module, const std::string& name) {
    const bool compute = gl::has_compute(device.info().name.version);
    const std::size_t buffers = KernelBinding::first_image + module.images.size();
    if (compute && buffers > device.info().max_storage_blocks) {
        throw std::invalid_argument(fmt::format("{}: needs {} storage buffers, {} has {}", name, buffers,
                                                to_string(device.info().name),
                                                device.info().max_storage_blocks));
    }
    return {device,
            compute ? gl::Program::Stage::compute : gl::Program::Stage::fragment,
            {"kernel of " + name, module.glsl}};
}

void require_guard(std::span<const Word> guard, const std::string& name, std::size_t last) {
    if (std::ranges::all_of(guard, [](Word word) { return word == guard_pattern; })) return;
    throw KernelError(fmt::format("{}: the kernel wrote outside its outputs, behind input {}", name, last));
}

gl::Buffer filled(const gl::Device& device, std::span<const Word> words) {
    gl::Buffer buffer(device, words.size());
    buffer.write(0, words);
    return buffer;
}

// The text and what it includes as one text of the version.
std::string packed(const gl::Version& version, const KernelSource& source, const std::string& text,
                   const std::vector<std::filesystem::path>& include_roots) {
    const shader::Language language = language_of(version);
    try {
        return shader::pack({shader::Source{.name = "kernel of " + source.function.name, .text = text}},
                            {.language = language}, include_roots);
    } catch (const shader::CompileError& error) {  // it has been compiled as GLSL 450
        throw Unsupported(fmt::format("{} is no GLSL {}: {}", source.function.name, to_string(language),
                                      base::one_line(error.what())));
    }
}

}  // namespace

shader::Language language_of(const gl::Version& version) {
    if (version.api == gl::Api::gl)
        return gl::has_compute(version) ? shader::Language::vulkan450 : shader::Language::gl330;
    if (!gl::has_compute(version)) return shader::Language::es300;
    return version.minor >= 2 ? shader::Language::es320 : shader::Language::es310;
}

std::string gl_kernel_code(const gl::Version& version, const KernelSource& source,
                           const std::vector<std::filesystem::path>& include_roots) {
    const std::string text = gl::has_compute(version) ? gl_compute_text(source) : gl_fragment_text(source);
    return packed(version, source, text, include_roots);
}

std::string gl_replay_code(const gl::Version& version, const KernelSource& source, const GlReplay& replay,
                           const std::vector<std::filesystem::path>& include_roots) {
    return packed(version, source, gl_replay_text(source, replay), include_roots);
}

// Some of a run's inputs.
struct GlKernel::Part {
    std::span<const Word> inputs;
    std::size_t count;
    std::size_t first;  // position of its first input in the whole run
    const ImageSet& images;
    KernelCore::Result& result;
};

GlKernel::GlKernel(const gl::Device& device, std::shared_ptr<const KernelModule> module, std::string name)
    : device_(device),
      module_(std::move(module)),
      name_(std::move(name)),
      program_(make_program(device, *module_, name_)) {}

// In one part: what fits into one row of work groups and one buffer, or into one texture and one target.
std::size_t GlKernel::most_inputs() const {
    const gl::DeviceInfo& info = device_.info();
    const std::size_t widest = std::max(module_->input_words, module_->output_words + 1);
    if (gl::has_compute(info.name.version)) {
        const std::size_t words = info.max_storage_bytes / sizeof(Word) - guard_words;
        return std::min(words / widest, most_groups * kernel_group_size);
    }
    return std::min(gl::WordTexture::most_words(info) / std::max<std::size_t>(module_->input_words, 1),
                    gl_target_width * info.max_texture_size);
}

KernelCore::Result GlKernel::run(std::span<const Word> inputs, std::size_t count,
                                 const ImageSet& images) const {
    KernelCore::Result result;
    if (module_->judged_by_rules) result.modules = {module_};
    result.outputs.reserve(count * module_->output_words);
    std::vector<std::vector<Word>> words = image_words(module_->images, images, name_);
    const std::size_t most = most_inputs();
    for (std::size_t first = 0; first < count; first += most) {
        const std::size_t some = std::min(most, count - first);
        const Part part{inputs.subspan(first * module_->input_words, some * module_->input_words), some,
                        first, images, result};
        if (gl::has_compute(device_.info().name.version)) {
            run_compute(part, words);
        } else {
            run_fragments(part, words);
        }
    }
    for (std::size_t i = 0; i < words.size(); ++i) add_stored(module_->images[i], words[i], images, result);
    return result;
}

void GlKernel::run_compute(const Part& part, std::vector<std::vector<Word>>& images) const {
    const std::size_t row = module_->output_words + 1;
    const auto groups = static_cast<Word>((part.count + kernel_group_size - 1) / kernel_group_size);
    const KernelRun run{.count = static_cast<Word>(part.count),
                        .row_length = groups * kernel_group_size,
                        .canary = new_canary()};
    const gl::Buffer uniforms = filled(device_, std::vector<Word>{run.count, run.row_length, run.canary, 0});
    const gl::Buffer inputs = filled(device_, part.inputs);
    gl::Buffer outputs(device_, part.count * row + guard_words);
    outputs.write(part.count * row, std::vector<Word>(guard_words, guard_pattern));
    const gl::Buffer faults(device_, fault_words);
    std::vector<gl::Buffer> image_buffers;
    for (const std::vector<Word>& words : images) image_buffers.push_back(filled(device_, words));
    gl::Dispatch work{.program = program_,
                      .storage = {inputs, outputs, faults},
                      .uniforms = uniforms,
                      .uniform_binding = gl_run_binding,
                      .groups = groups};
    for (const gl::Buffer& image : image_buffers) work.storage.emplace_back(image);
    gl::dispatch(device_, work);

    const std::vector<Word> words = outputs.read();
    const KernelRows rows{words, row, part.count, part.first, run.canary};
    add_outputs(rows, *module_, name_, part.result);
    require_guard(std::span(words).subspan(part.count * row), name_, part.first + part.count - 1);
    const std::vector<Word> fault = faults.read();
    add_faults({fault[0], fault[1], fault[2], fault[3], fault[4]}, part.first + fault[4], *module_,
               part.images, part.result);
    for (std::size_t i = 0; i < images.size(); ++i)
        if (module_->images[i].stores) images[i] = image_buffers[i].read();
}

void GlKernel::run_fragments(const Part& part, const std::vector<std::vector<Word>>& images) const {
    const gl::WordTexture inputs(device_, part.inputs);
    std::vector<gl::WordTexture> image_textures;
    for (const std::vector<Word>& words : images) image_textures.emplace_back(device_, words);
    const Word canary = new_canary();
    gl::Draw work{
        .program = program_,
        .textures = {{"gloam_kernel_inputs", &inputs}},
        .uniforms = {{"gloam_kernel_count", static_cast<Word>(part.count)}, {"gloam_kernel_canary", canary}},
        .width = gl_target_width,
        .height = (part.count + gl_target_width - 1) / gl_target_width};
    for (std::size_t i = 0; i < image_textures.size(); ++i)
        work.textures.emplace_back(fmt::format("gloam_kernel_image{}", i), &image_textures[i]);
    const std::vector<Word> words = rows_of(work, part.count);

    const std::size_t row = gl_fragment_row(module_->output_words, images.size());
    const KernelRows rows{words, row, part.count, part.first, canary};
    add_outputs(rows, *module_, name_, part.result);
    for (std::size_t i = 0; !images.empty() && i < part.count; ++i) {
        const Word* const fault = &words[i * row + module_->output_words + 1];
        add_faults({fault[0], fault[1], fault[2], fault[3], 0}, part.first + i, *module_, part.images,
                   part.result);
    }
}

// The rows of all inputs, from as many passes as their words need.
std::vector<Word> GlKernel::rows_of(const gl::Draw& work, std::size_t count) const {
    const std::size_t row = gl_fragment_row(module_->output_words, module_->images.size());
    const std::size_t targets = std::min((row + gl_target_words - 1) / gl_target_words, gl_most_targets);
    std::vector<Word> rows(count * row);
    for (std::size_t pass = 0, at = 0; at < row; ++pass) {
        gl::Draw one = work;
        one.targets = targets;
        one.uniforms.emplace_back("gloam_kernel_pass", static_cast<Word>(pass));
        for (const std::vector<Word>& target : gl::draw(device_, one)) {
            for (std::size_t k = 0; k < gl_target_words && at < row; ++k, ++at)
                for (std::size_t i = 0; i < count; ++i) rows[i * row + at] = target[i * gl_target_words + k];
        }
    }
    return rows;
}

namespace {

// Of SPIR-V: OpExtInst, and the numbers of its set GLSL.std.450 from Sin to Atan2, and of two for matrices.
constexpr std::uint32_t extended = 12;
constexpr std::uint32_t sine = 13;
constexpr std::uint32_t arc_tangent_of_two = 25;
constexpr std::uint32_t determinant = 33;
constexpr std::uint32_t inverse = 34;

}  // namespace

bool has_precision_rules(shader::Language language) {
    return language == shader::Language::vulkan450 || language == shader::Language::es320;
}

bool calls_undefined_precision(const shader::Spirv& module) {
    const auto all = shader::instructions(module);
    return std::ranges::any_of(all, [](const shader::Instruction& instruction) {
        if (instruction.opcode != extended) return false;
        const std::uint32_t function = instruction.word(4);
        return (function >= sine && function <= arc_tangent_of_two) || function == determinant ||
               function == inverse;
    });
}

}  // namespace gloam::check::internal
