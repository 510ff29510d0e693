// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "check/kernel_core.hpp"
#include "check/signature.hpp"
#include "gpu/device.hpp"
#include "shader/cache.hpp"

namespace gloam::check {

// The device of this name is the interpreter: exact, and there on every machine.
inline constexpr std::string_view interpreter_name = "interpreter";

// What it says of itself: float32 rounded to even, NaN, infinity, -0 and subnormals kept.
[[nodiscard]] gpu::DeviceInfo interpreter_info();

struct LabOptions {
    std::string device;                                // see gpu::DeviceOptions; or interpreter_name
    bool validation = false;                           // Vulkan validation layers on; any message is an error
    std::vector<std::filesystem::path> include_roots;  // where GLSL files are looked for, first match wins
    std::filesystem::path cache_directory;      // compiled shaders and pipelines; empty: nothing is kept
    shader::Variant variant;                    // how the shaders are compiled
    std::chrono::milliseconds timeout{60'000};  // longest wait for one submission
};

// A place to run shader functions: one device, the folders of their files, the caches.
class Lab {
  public:
    explicit Lab(LabOptions options);
    // On a device that others use, too: what the options say of the device does not count. None: the
    // interpreter.
    Lab(LabOptions options, std::shared_ptr<gpu::Device> device);

    // The function of that name and signature in `file`, ready to run. Image prototypes that it declares are
    // served at every run. Throws std::invalid_argument when the file has no such function (lists what it
    // has) or its signature differs (prints both); shader::CompileError.
    [[nodiscard]] KernelCore kernel(const std::string& file, const std::string& function,
                                    const Signature& signature) const;

    // Every function that a file and its includes define or call, as the compiler saw it. Throws
    // shader::CompileError.
    [[nodiscard]] std::vector<shader::Function> functions(const std::string& file) const;

    // What such a kernel is generated from. Throws as kernel() does.
    [[nodiscard]] KernelSource source(const std::string& file, const std::string& function,
                                      const Signature& signature) const;

    // The module of a compute shader, in the lab's variant. Throws shader::CompileError.
    [[nodiscard]] shader::Spirv compile(const shader::Source& text) const;
    // The same in any other way.
    [[nodiscard]] shader::Spirv compile(const shader::Source& text,
                                        const shader::CompileOptions& options) const;

    // The same for a kernel. Throws std::invalid_argument as well, for a function that uses bindings of its
    // own: nothing stands behind them.
    [[nodiscard]] shader::Spirv compile_kernel(const shader::Source& text) const;

    // The generated shader of such a kernel.
    [[nodiscard]] std::string code(const std::string& file, const std::string& function,
                                   const Signature& signature) const;

    // Throws std::runtime_error with the validation messages since the last call, if there are any.
    void require_silent_validation() const;

    // The module ready to run, on this lab's device.
    [[nodiscard]] KernelCore core(KernelModule module, const std::string& name) const;

    [[nodiscard]] const gpu::DeviceInfo& info() const { return info_; }
    // Throws std::runtime_error where the interpreter is the device.
    [[nodiscard]] const gpu::Device& device() const;
    [[nodiscard]] const LabOptions& options() const { return options_; }

    // How its shaders are compiled.
    [[nodiscard]] shader::CompileOptions compile_options() const;

  private:
    LabOptions options_;
    std::shared_ptr<gpu::Device> device_;  // none: the interpreter
    gpu::DeviceInfo info_;
    shader::SpirvCache cache_;
};

}  // namespace gloam::check
