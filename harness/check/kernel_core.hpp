// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "check/kernel_module.hpp"
#include "gl/device.hpp"
#include "gpu/compute.hpp"
#include "gpu/device.hpp"
#include "shader/compile.hpp"

namespace gloam::check {

namespace internal {
class GlKernel;
}

// An access outside an image behind one of the shader's prototypes.
struct ImageFault {
    std::string image;  // the prototype's name
    glm::ivec2 pixel{0};
    glm::ivec2 size{0};
    std::size_t count = 0;  // all accesses outside
    std::size_t input = 0;  // one input with such an access
};

// "gloam_fetch_depth: pixel (-1, 0) is outside the 3 x 3 image (5 times, at input 12)".
[[nodiscard]] std::string to_text(const ImageFault& fault);

// A dispatch whose outputs are unreliable: the kernel did not complete for every input, or memory behind its
// outputs changed.
class KernelError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// A compiled kernel without its C++ types: words in, words out.
class KernelCore {
  public:
    // `name`: for messages only.
    KernelCore(const gpu::Device& device, KernelModule module, std::string name);
    // For the interpreter: correctly rounded, without a device.
    KernelCore(KernelModule module, std::string name);
    // Its KernelModule::glsl run by an OpenGL device. Throws gl::Error.
    KernelCore(const gl::Device& device, KernelModule module, std::string name);

    struct Result {
        std::vector<Word> outputs;  // count x output_words
        ImageSet stored;            // images that the shader may have stored to
        std::optional<ImageFault> fault;
        KernelModules modules;  // the modules that produced the outputs; none where no rules hold for them
    };

    // Evaluates `count` inputs (count x input_words words) in one dispatch, or in as few as the device's
    // limits allow. Throws std::invalid_argument if a prototype has no image or one of another type;
    // KernelError, also for a module that the interpreter cannot run; gpu and gl errors.
    [[nodiscard]] Result run(std::span<const Word> inputs, std::size_t count,
                             const ImageSet& images = {}) const;

    [[nodiscard]] const KernelModule& module() const { return *module_; }
    [[nodiscard]] std::size_t input_words() const { return module_->input_words; }
    [[nodiscard]] std::size_t output_words() const { return module_->output_words; }

  private:
    struct Batch;
    void run_batch(Batch& batch) const;

    const gpu::Device* device_ = nullptr;  // none: the interpreter, or OpenGL
    std::shared_ptr<const KernelModule> module_;
    std::optional<gpu::ComputePipeline> pipeline_;
    std::shared_ptr<const internal::GlKernel> gl_;
    std::string name_;
};

}  // namespace gloam::check
