// SPDX-License-Identifier: MIT
#include "backend/gl/kernel.hpp"

#include <fmt/format.h>
#include <stdexcept>
#include <string>

#include "backend/gl/program.hpp"

namespace gloam::backend::gl {
namespace {

Program program_of(const Device& device, const backend::KernelProgram& kernel) {
    const DeviceInfo& info = device.info();
    const bool compute = has_compute(info.id.version);
    const std::size_t buffers = backend::KernelBinding::first_image + kernel.images.size();
    if (compute && buffers > info.max_storage_blocks) {
        throw std::invalid_argument(fmt::format("{}: needs {} storage buffers, {} has {}", kernel.name,
                                                buffers, info.name, info.max_storage_blocks));
    }
    return {device,
            compute ? Program::Stage::compute : Program::Stage::fragment,
            {"kernel of " + kernel.name, kernel.text}};
}

class ComputeKernel : public backend::Kernel {
  public:
    ComputeKernel(const Device& device, const backend::KernelProgram& program)
        : device_(device),
          program_(program_of(device, program)),
          images_(program.images),
          widest_(program.widest()) {}

    // What fits into one row of work groups and one buffer.
    [[nodiscard]] std::size_t most_inputs() const override {
        constexpr std::size_t most_groups = 65'535;  // that every version has
        const std::size_t words = device_.info().max_buffer_bytes / sizeof(Word) - backend::guard_words;
        return std::min(words / widest_, most_groups * backend::kernel_group_size);
    }

    void run(std::size_t count, Word canary, backend::KernelMemory& memory) const override {
        const auto groups =
            static_cast<Word>((count + backend::kernel_group_size - 1) / backend::kernel_group_size);
        const backend::KernelRun run{.count = static_cast<Word>(count),
                                     .row_length = groups * backend::kernel_group_size,
                                     .canary = canary};
        const Buffer uniforms(device_, std::vector<Word>{run.count, run.row_length, run.canary, 0});
        const Buffer faults(device_, {}, sizeof memory.faults / sizeof(Word));
        const Buffer inputs(device_, memory.inputs);
        const Buffer outputs(device_, memory.outputs);
        std::vector<Buffer> images;
        std::vector<SampledTexture> textures;
        for (std::size_t i = 0; i < memory.images.size(); ++i) {
            const std::span<const Word> words = memory.images[i];
            images.emplace_back(device_, images_[i].sampled ? words.first(1) : words);
            if (!images_[i].sampled) continue;
            textures.emplace_back(device_, words);
            textures.back().bind(static_cast<std::uint32_t>(backend::KernelBinding::first_image + i));
        }
        Dispatch work{.program = program_,
                      .storage = {{backend::KernelBinding::inputs, inputs},
                                  {backend::KernelBinding::outputs, outputs},
                                  {backend::KernelBinding::faults, faults}},
                      .uniforms = {{kernel_run_binding, uniforms}},
                      .groups = {groups, 1, 1}};
        for (std::uint32_t i = 0; i < images.size(); ++i)
            work.storage.emplace(backend::KernelBinding::first_image + i, images[i]);
        dispatch(device_, work);

        memory.outputs = outputs.read();
        const std::vector<Word> fault = faults.read();
        memory.faults = {fault[0], fault[1], fault[2], fault[3], fault[4]};
    }

  private:
    const Device& device_;
    Program program_;
    std::vector<backend::KernelImage> images_;
    std::size_t widest_;
};

class FragmentKernel : public backend::Kernel {
  public:
    FragmentKernel(const Device& device, const backend::KernelProgram& program)
        : device_(device),
          program_(program_of(device, program)),
          input_words_(program.input_words),
          output_words_(program.output_words),
          row_(kernel_row(program.output_words, program.images.size())) {}

    // What fits into one texture and one target.
    [[nodiscard]] std::size_t most_inputs() const override {
        return std::min(WordTexture::most_words(device_.info()) / std::max<std::size_t>(input_words_, 1),
                        kernel_target_width * device_.info().max_image_size);
    }

    void run(std::size_t count, Word canary, backend::KernelMemory& memory) const override {
        const WordTexture inputs(device_, memory.inputs);
        std::vector<WordTexture> images;
        for (const std::vector<Word>& words : memory.images) images.emplace_back(device_, words);
        Draw work{
            .program = program_,
            .textures = {{"gloam_kernel_inputs", &inputs}},
            .uniforms = {{"gloam_kernel_count", static_cast<Word>(count)}, {"gloam_kernel_canary", canary}},
            .width = kernel_target_width,
            .height = (count + kernel_target_width - 1) / kernel_target_width,
            .targets = kernel_targets(row_)};
        for (std::size_t i = 0; i < images.size(); ++i)
            work.textures.emplace_back(fmt::format("gloam_kernel_image{}", i), &images[i]);
        const std::vector<Word> rows = rows_of(work, count);
        for (std::size_t i = 0; i < count; ++i) {
            const Word* const row = &rows[i * row_];
            std::copy_n(row, output_words_ + 1, &memory.outputs[i * (output_words_ + 1)]);
            if (!images.empty()) add_faults(row + output_words_ + 1, i, memory.faults);
        }
    }

  private:
    static void add_faults(const Word* fault, std::size_t input, backend::KernelFaults& all) {
        if (fault[0] > 0 && all.count == 0) all = {0, fault[1], fault[2], fault[3], static_cast<Word>(input)};
        all.count += fault[0];
    }

    // The rows of all inputs, from as many passes as their words need.
    [[nodiscard]] std::vector<Word> rows_of(const Draw& work, std::size_t count) const {
        std::vector<Word> rows(count * row_);
        for (std::size_t pass = 0, at = 0; at < row_; ++pass) {
            Draw one = work;
            one.uniforms.emplace_back("gloam_kernel_pass", static_cast<Word>(pass));
            for (const std::vector<Word>& target : draw(device_, one)) {
                for (std::size_t k = 0; k < kernel_target_words && at < row_; ++k, ++at)
                    for (std::size_t i = 0; i < count; ++i)
                        rows[i * row_ + at] = target[i * kernel_target_words + k];
            }
        }
        return rows;
    }

    const Device& device_;
    Program program_;
    std::size_t input_words_;
    std::size_t output_words_;
    std::size_t row_;
};

}  // namespace

std::unique_ptr<backend::Kernel> Device::make_kernel(const backend::KernelProgram& program) const {
    if (has_compute(info().id.version)) return std::make_unique<ComputeKernel>(*this, program);
    return std::make_unique<FragmentKernel>(*this, program);
}

}  // namespace gloam::backend::gl
