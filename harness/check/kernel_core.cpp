// SPDX-License-Identifier: MIT
#include "check/kernel_core.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "gpu/buffer.hpp"
#include "gpu/commands.hpp"

namespace gloam::check {
namespace {

// What the memory behind the outputs holds before the dispatch and must hold after it.
constexpr Word guard_pattern = 0xdeadbeefU;
constexpr std::size_t guard_words = 64;
constexpr std::size_t fault_words = sizeof(KernelFaults) / sizeof(Word);

gpu::ComputePipeline make_pipeline(const gpu::Device& device, const shader::Spirv& spirv, std::size_t images,
                                   std::vector<gpu::SpecializationConstant> constants) {
    const gpu::ComputeProgram program{
        .spirv = spirv,
        .bindings = std::vector(KernelBinding::first_image + images, gpu::BindingKind::storage_buffer),
        .push_constant_bytes = sizeof(KernelRun),
        .constants = std::move(constants)};
    return {device, program};
}

gpu::Buffer make_buffer(const gpu::Device& device, std::size_t words) {
    return {device, std::max<std::size_t>(words, 1) * sizeof(Word)};
}

gpu::Buffer upload_image(const gpu::Device& device, const Image& image) {
    gpu::Buffer buffer = make_buffer(device, image_header_words + image.words.size());
    const std::span<Word> words = buffer.as<Word>();
    words[0] = static_cast<Word>(image.size.x);
    words[1] = static_cast<Word>(image.size.y);
    words[2] = image.border == Border::clamp ? 1U : 0U;
    std::ranges::copy(image.words, words.subspan(image_header_words).begin());
    return buffer;
}

const Image& find_image(const ImageSet& images, const ImagePrototype& prototype, const std::string& kernel) {
    const auto found = images.find(prototype.name);
    if (found == images.end()) {
        throw std::invalid_argument(
            fmt::format("{}: no image serves the prototype {}", kernel, prototype.name));
    }
    const Image& image = found->second;
    const std::size_t pixels =
        static_cast<std::size_t>(image.size.x) * static_cast<std::size_t>(image.size.y);
    if (!(image.element == prototype.element)) {
        throw std::invalid_argument(fmt::format("{}: the image of {} has {} pixels, the prototype {}", kernel,
                                                prototype.name, shader::to_glsl(image.element),
                                                shader::to_glsl(prototype.element)));
    }
    if (image.size.x < 1 || image.size.y < 1 ||
        image.words.size() != pixels * scalars_of(image.element).size()) {
        throw std::invalid_argument(
            fmt::format("{}: the image of {} is {} x {} with {} words, which disagree", kernel,
                        prototype.name, image.size.x, image.size.y, image.words.size()));
    }
    return image;
}

Word new_canary() {
    std::random_device entropy;
    return entropy();
}

}  // namespace

std::string to_text(const ImageFault& fault) {
    return fmt::format("{}: pixel ({}, {}) is outside the {} x {} image ({} times, at input {})", fault.image,
                       fault.pixel.x, fault.pixel.y, fault.size.x, fault.size.y, fault.count, fault.input);
}

struct KernelCore::Batch {
    std::span<const Word> inputs;
    std::size_t count;
    std::size_t first;  // position of its first input in the whole run
    const std::vector<gpu::Buffer>& images;
    const ImageSet& image_set;
    Result& result;
};

KernelCore::KernelCore(const gpu::Device& device, const shader::Spirv& spirv, std::string name,
                       std::size_t input_words, std::size_t output_words, std::vector<ImagePrototype> images,
                       std::vector<gpu::SpecializationConstant> constants)
    : device_(&device),
      pipeline_(make_pipeline(device, spirv, images.size(), std::move(constants))),
      name_(std::move(name)),
      input_words_(input_words),
      output_words_(output_words),
      images_(std::move(images)) {}

KernelCore::Result KernelCore::run(std::span<const Word> inputs, std::size_t count,
                                   const ImageSet& images) const {
    if (inputs.size() != count * input_words_) {
        throw std::invalid_argument(fmt::format("{}: {} inputs of {} words need {} words, got {}", name_,
                                                count, input_words_, count * input_words_, inputs.size()));
    }
    Result result;
    result.outputs.reserve(count * output_words_);
    std::vector<gpu::Buffer> buffers;
    for (const ImagePrototype& prototype : images_) {
        buffers.push_back(upload_image(*device_, find_image(images, prototype, name_)));
    }
    const std::size_t widest = std::max(input_words_, output_words_ + 1);
    const std::size_t most = device_->info().max_buffer_bytes / sizeof(Word) / widest - guard_words;
    for (std::size_t first = 0; first < count; first += most) {
        const std::size_t batch = std::min(most, count - first);
        Batch work{inputs.subspan(first * input_words_, batch * input_words_),
                   batch,
                   first,
                   buffers,
                   images,
                   result};
        run_batch(work);
    }
    for (std::size_t i = 0; i < images_.size(); ++i) {
        if (!images_[i].stores) continue;
        Image stored = images.at(images_[i].name);
        const auto words = buffers[i].as<Word>().subspan(image_header_words);
        stored.words.assign(words.begin(), words.end());
        result.stored.emplace(images_[i].name, std::move(stored));
    }
    return result;
}

void KernelCore::run_batch(Batch& batch) const {
    const std::size_t row = output_words_ + 1;
    gpu::Buffer inputs = make_buffer(*device_, batch.inputs.size());
    gpu::Buffer outputs = make_buffer(*device_, batch.count * row + guard_words);
    gpu::Buffer fault_buffer = make_buffer(*device_, fault_words);
    std::ranges::copy(batch.inputs, inputs.as<Word>().begin());
    std::ranges::fill(outputs.as<Word>().subspan(batch.count * row), guard_pattern);
    std::ranges::fill(fault_buffer.as<Word>(), 0U);

    const std::size_t groups = (batch.count + kernel_group_size - 1) / kernel_group_size;
    const std::size_t columns = std::min<std::size_t>(groups, device_->info().max_group_count[0]);
    const std::size_t rows = (groups + columns - 1) / columns;
    const KernelRun run{.count = static_cast<Word>(batch.count),
                        .row_length = static_cast<Word>(columns * kernel_group_size),
                        .canary = new_canary()};
    std::vector<gpu::Resource> resources{std::cref(inputs), std::cref(outputs), std::cref(fault_buffer)};
    for (const gpu::Buffer& image : batch.images) resources.emplace_back(std::cref(image));
    gpu::Commands commands(*device_);
    commands.dispatch(pipeline_, resources, {static_cast<Word>(columns), static_cast<Word>(rows), 1},
                      std::as_bytes(std::span(&run, 1)));
    commands.submit();

    collect_outputs(batch, run, outputs.as<Word>());
    collect_fault(batch, fault_buffer.as<Word>());
}

// Takes the outputs of every input, once its canary and the guard behind them are found in order.
void KernelCore::collect_outputs(Batch& batch, const KernelRun& run, std::span<const Word> words) const {
    const std::size_t row = output_words_ + 1;
    std::vector<Word>& outputs = batch.result.outputs;
    const std::size_t first = outputs.size();
    outputs.resize(first + batch.count * output_words_);
    for (std::size_t i = 0; i < batch.count; ++i) {
        const auto values = words.subspan(i * row, output_words_);
        const Word canary = words[i * row + output_words_];
        const Word expected = run.canary ^ static_cast<Word>(i);
        if (canary != expected) {
            throw KernelError(
                fmt::format("{}: the kernel did not finish for input {} of {}: expected the canary 0x{:08x}, "
                            "found 0x{:08x}",
                            name_, batch.first + i, batch.first + batch.count, expected, canary));
        }
        std::ranges::copy(values, outputs.begin() + static_cast<std::ptrdiff_t>(first + i * output_words_));
    }
    const auto guard = words.subspan(batch.count * row);
    if (std::ranges::any_of(guard, [](Word word) { return word != guard_pattern; })) {
        throw KernelError(fmt::format("{}: the kernel wrote outside its outputs, behind input {}", name_,
                                      batch.first + batch.count - 1));
    }
}

void KernelCore::collect_fault(Batch& batch, std::span<const Word> words) const {
    const KernelFaults faults{words[0], words[1], words[2], words[3], words[4]};
    if (faults.count == 0) return;
    const ImagePrototype& image = images_.at(faults.image);
    const std::size_t earlier = batch.result.fault ? batch.result.fault->count : 0;
    batch.result.fault = ImageFault{.image = image.name,
                                    .pixel = {static_cast<int>(faults.x), static_cast<int>(faults.y)},
                                    .size = batch.image_set.at(image.name).size,
                                    .count = earlier + faults.count,
                                    .input = batch.first + faults.input};
}

}  // namespace gloam::check
