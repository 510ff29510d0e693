// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "backend/backend.hpp"
#include "backend/vulkan/device.hpp"
#include "module/compile.hpp"
#include "module/texts.hpp"
#include "subject/kernel_code.hpp"
#include "subject/signature.hpp"

namespace gloam::subject {

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

// A compiled kernel without its C++ types: words in, words out.
class KernelCore {
  public:
    // The device must outlive the kernel. Throws like Backend::make_kernel().
    KernelCore(const backend::Backend& device, KernelModule module);

    struct Result {
        std::vector<Word> outputs;  // count x output_words
        std::optional<ImageFault> fault;
        KernelModules modules;  // the modules that produced the outputs; none where no rules hold for them
    };

    // Evaluates `count` inputs (count x input_words words) in one dispatch, or in as few as the device's
    // limits allow. Throws std::invalid_argument if a prototype has no image or one of another type;
    // backend::Error.
    [[nodiscard]] Result run(std::span<const Word> inputs, std::size_t count,
                             const ImageSet& images = {}) const;

    [[nodiscard]] const KernelModule& module() const { return *module_; }
    [[nodiscard]] std::size_t input_words() const { return module_->input_words; }
    [[nodiscard]] std::size_t output_words() const { return module_->output_words; }

  private:
    std::shared_ptr<const KernelModule> module_;
    std::shared_ptr<const backend::Kernel> kernel_;
};

// The device name of the interpreter: correctly rounded, and available on every machine.
inline constexpr std::string_view interpreter_name = "interpreter";

// float32 rounded to nearest even; NaN, infinity, -0 and subnormals preserved. Threads share the inputs of a
// kernel.
[[nodiscard]] std::shared_ptr<backend::Backend> interpreter_backend();

// What of a kernel the interpreter does not know, which judges every result; empty if it can be run.
[[nodiscard]] std::string why_not_run(KernelSource source, const module::SpirvCache& cache);

// The image that serves a prototype T f(ivec2). Empty for any other prototype.
[[nodiscard]] std::optional<ImagePrototype> image_prototype(const module::Function& function);

// Those that serve the functions of a file that have no body. Throws std::invalid_argument for one that no
// image can serve.
[[nodiscard]] std::vector<ImagePrototype> image_prototypes(const std::vector<module::Function>& functions,
                                                           const std::string& file);

// The samplers and images of an excerpt, then samplers that are parameters of the function.
[[nodiscard]] std::vector<ImagePrototype> images_of(const source::Excerpt& excerpt,
                                                    const module::Function& function);

// The text whose functions are those of a file, or of an excerpt of the file (source::Excerpt::text).
[[nodiscard]] source::Source probe_of(const std::string& file, const std::string& excerpt = {});

// A user's shader file, cut into its functions once. Labs that run them share it.
struct OwnFile {
    // `text`: what the file holds. `roots`: folders of its includes. `defines`: macros that hold before it
    // begins (source::excerpts()). Throws source::CompileError for what the preprocessor rejects.
    OwnFile(const std::filesystem::path& path, std::string contents, std::vector<std::filesystem::path> roots,
            const std::vector<std::string>& defines = {})
        : name(path.filename().string()),
          text(std::move(contents)),
          include_roots(std::move(roots)),
          excerpts(module::excerpts({path.string(), text}, include_roots, defines)) {}

    // Null: it defines no such function.
    [[nodiscard]] const source::Excerpt* find(const std::string& function) const {
        const auto found = std::ranges::find(excerpts.functions, function, &source::Excerpt::function);
        return found == excerpts.functions.end() ? nullptr : &*found;
    }

    std::string name;  // without its folder, as kernels and reports call it
    std::string text;
    std::vector<std::filesystem::path> include_roots;
    source::Excerpts excerpts;
};

struct LabOptions {
    std::string device;       // see backend::vulkan::DeviceOptions; or interpreter_name;
                              // or an OpenGL device (backend/gl/device.hpp)
    bool validation = false;  // Vulkan validation layers on; any message is an error
    std::vector<std::filesystem::path> include_roots;  // folders searched for GLSL files, in order
    std::filesystem::path cache_directory;             // of compiled shaders and pipelines; empty: no cache
    module::Variant variant;                           // how the shaders are compiled
    std::shared_ptr<const OwnFile> file = {};          // whose functions are compiled without the rest of it;
                                                       // include_roots are its own then
    std::chrono::milliseconds timeout{60'000};         // longest wait for one submission
};

// The cache of the shaders that a Lab with these options compiles.
[[nodiscard]] module::SpirvCache shader_cache(const LabOptions& options);

// Runs shader functions on one device, with the folders of their files and the caches.
class Lab {
  public:
    // Throws std::invalid_argument for a variant or validation that an OpenGL device does not have; the
    // errors of backend::vulkan::Device and backend::gl::Device.
    explicit Lab(LabOptions options);
    // Uses a device that others share; the device options in `options` are ignored.
    Lab(LabOptions options, std::shared_ptr<backend::Backend> device);

    // The function with this name and signature in `file`, ready to run. Each run supplies images for the
    // prototypes that the file declares. Throws std::invalid_argument if the file has no such function (with
    // a list of its functions) or its signature differs (with both signatures); std::runtime_error if there
    // is no such file; source::CompileError; backend::Error.
    [[nodiscard]] KernelCore kernel(const std::string& file, const std::string& function,
                                    const Signature& signature) const;

    // A kernel whose inputs are constants of the shader: literals or specialization constants, as the lab's
    // variant requires. It shows whether the compiler or the driver folds constants to the values that the
    // device calculates. It has no inputs; invocation i evaluates input i. Throws like kernel().
    [[nodiscard]] KernelCore constant_kernel(const KernelSource& source, std::span<const Word> inputs,
                                             std::size_t count) const;

    // What the kernel of a function is generated from. Throws like kernel().
    [[nodiscard]] KernelSource source(const std::string& file, const std::string& function,
                                      const Signature& signature) const;

    // Of the modules of its shaders.
    [[nodiscard]] const module::SpirvCache& cache() const { return cache_; }

    // The module of a kernel with these images, in the lab's variant. Throws source::CompileError;
    // std::invalid_argument if the function uses other bindings, because no resource is bound to them.
    [[nodiscard]] module::Spirv compile_kernel(const source::Source& text,
                                               const std::vector<ImagePrototype>& images,
                                               source::Stage stage = source::Stage::compute) const;

    // Throws std::runtime_error with the validation messages since the last call, if there are any.
    void require_silent_validation() const;

    // Whether its kernels declare that NaN, infinity and -0 keep their meaning, where the device has that. A
    // compiler leaves most of such a kernel as it is, so those that take steps declare it in `strict` alone.
    [[nodiscard]] bool keeps_nan() const {
        return info().float32.preserves_signed_zero_inf_nan &&
               (options_.variant.steps.empty() || options_.variant.strict);
    }

    // Takes the variant's steps with a kernel's module, and keeps the module before them and before the
    // variant's optimizer. `text`: what it was made from. Throws module::StepError; module::Unchanged.
    void take_steps(KernelModule& module, const source::Source& text) const;

    // A kernel for this module on this lab's device.
    [[nodiscard]] KernelCore core(KernelModule module) const;

    [[nodiscard]] const backend::DeviceInfo& info() const { return device_->info(); }
    // Its device, for other labs to share.
    [[nodiscard]] const std::shared_ptr<backend::Backend>& backend() const { return device_; }
    // The language in which its device takes kernels (DeviceInfo::glsl); none where it takes modules.
    [[nodiscard]] std::optional<source::Language> language() const;
    // The Vulkan device. Throws std::runtime_error if there is none.
    [[nodiscard]] const backend::vulkan::Device& device() const;
    [[nodiscard]] const LabOptions& options() const { return options_; }

    // The options with which its shaders are compiled.
    [[nodiscard]] module::CompileOptions compile_options(source::Stage stage = source::Stage::compute) const;
    // The same without the optimizer: those of the module whose rules hold for the results.
    [[nodiscard]] module::CompileOptions judged_options(source::Stage stage = source::Stage::compute) const;

  private:
    LabOptions options_;
    std::shared_ptr<backend::Backend> device_;
    module::SpirvCache cache_;
};

}  // namespace gloam::subject
