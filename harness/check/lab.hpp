// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "check/kernel_core.hpp"
#include "check/signature.hpp"
#include "gpu/device.hpp"
#include "shader/cache.hpp"
#include "shader/excerpt.hpp"

namespace gloam::check {

// The function is no text of the GLSL version of an OpenGL device.
class Unsupported : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The device name of the interpreter: correctly rounded, and available on every machine.
inline constexpr std::string_view interpreter_name = "interpreter";

// Its properties: float32 rounded to nearest even; NaN, infinity, -0 and subnormals preserved.
[[nodiscard]] gpu::DeviceInfo interpreter_info();

// An OpenGL device in the same terms. OpenGL says nothing of NaN, infinity, -0 and subnormals.
[[nodiscard]] gpu::DeviceInfo opengl_info(const gl::DeviceInfo& info);

// The image that serves a prototype: T f(ivec2), or void f(ivec2, T). Empty for any other prototype.
[[nodiscard]] std::optional<ImagePrototype> image_prototype(const shader::Function& function);

// The text whose functions are those of a file, or of an excerpt of the file (shader::Excerpt::text).
[[nodiscard]] shader::Source probe_of(const std::string& file, const std::string& excerpt = {});

struct LabOptions {
    std::string device;                                // see gpu::DeviceOptions; or interpreter_name;
                                                       // or an OpenGL device (gl/device_name.hpp)
    bool validation = false;                           // Vulkan validation layers on; any message is an error
    std::vector<std::filesystem::path> include_roots;  // folders searched for GLSL files, in order
    std::filesystem::path cache_directory;             // of compiled shaders and pipelines; empty: no cache
    shader::Variant variant;                           // how the shaders are compiled
    std::vector<shader::Excerpt> excerpts;             // functions that are compiled without the rest of
                                                       // their file
    std::chrono::milliseconds timeout{60'000};         // longest wait for one submission
};

// The cache of the shaders that a Lab with these options compiles.
[[nodiscard]] shader::SpirvCache shader_cache(const LabOptions& options);

// Runs shader functions on one device, with the folders of their files and the caches.
class Lab {
  public:
    explicit Lab(LabOptions options);
    // Uses a device that others share; the device options in `options` are ignored. nullptr: the interpreter.
    Lab(LabOptions options, std::shared_ptr<gpu::Device> device);

    // The function with this name and signature in `file`, ready to run. Each run supplies images for the
    // prototypes that the file declares. Throws std::invalid_argument if the file has no such function (with
    // a list of its functions) or its signature differs (with both signatures); shader::CompileError;
    // Unsupported; gl::Error.
    [[nodiscard]] KernelCore kernel(const std::string& file, const std::string& function,
                                    const Signature& signature) const;

    // Every function that a file and its includes define or call, as the compiler reports it. Throws
    // shader::CompileError.
    [[nodiscard]] std::vector<shader::Function> functions(const std::string& file) const;

    // What the kernel of a function is generated from. Throws like kernel().
    [[nodiscard]] KernelSource source(const std::string& file, const std::string& function,
                                      const Signature& signature) const;

    // The module of a compute shader, in the lab's variant. Throws shader::CompileError.
    [[nodiscard]] shader::Spirv compile(const shader::Source& text) const;
    // The same with other compile options.
    [[nodiscard]] shader::Spirv compile(const shader::Source& text,
                                        const shader::CompileOptions& options) const;

    // The same for a kernel. Also throws std::invalid_argument if the function uses bindings of its own,
    // because no resource is bound to them.
    [[nodiscard]] shader::Spirv compile_kernel(const shader::Source& text) const;

    // The generated shader of a function's kernel.
    [[nodiscard]] std::string code(const std::string& file, const std::string& function,
                                   const Signature& signature) const;

    // The same of such a kernel as an OpenGL device is given it: one text without includes. Throws
    // std::runtime_error where there is no such device; Unsupported.
    [[nodiscard]] std::string opengl_code(const KernelSource& source) const;

    // Throws std::runtime_error with the validation messages since the last call, if there are any.
    void require_silent_validation() const;

    // A kernel for this module on this lab's device.
    [[nodiscard]] KernelCore core(KernelModule module, const std::string& name) const;

    [[nodiscard]] const gpu::DeviceInfo& info() const { return info_; }
    // Whether it runs on an OpenGL device.
    [[nodiscard]] bool is_opengl() const { return gl_ != nullptr; }
    // The OpenGL device. Throws std::runtime_error if there is none.
    [[nodiscard]] const gl::Device& opengl() const;
    // The Vulkan device. Throws std::runtime_error if there is none.
    [[nodiscard]] const gpu::Device& device() const;
    [[nodiscard]] const LabOptions& options() const { return options_; }

    // The options with which its shaders are compiled.
    [[nodiscard]] shader::CompileOptions compile_options() const;

  private:
    LabOptions options_;
    std::shared_ptr<gpu::Device> device_;  // none: the interpreter, or OpenGL
    std::shared_ptr<gl::Device> gl_;
    gpu::DeviceInfo info_;
    shader::SpirvCache cache_;
};

}  // namespace gloam::check
