// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/failure.hpp"

// What runs kernels: Vulkan devices, OpenGL devices, the interpreter.
namespace gloam::backend {

// Whatever a kernel reads and writes, as bits.
using Word = std::uint32_t;

// Width and height of an image, in pixels.
struct Extent {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    friend bool operator==(const Extent&, const Extent&) = default;
};

// What went wrong with a device, in one line.
class Error : public base::Failure {
    using base::Failure::Failure;
};

template <base::Reason of>
class ErrorFor : public Error {
  public:
    explicit ErrorFor(const std::string& message) : Error(message, of) {}
};

using DeviceLost = ErrorFor<base::Reason::device_lost>;  // it cannot be used any more
using Hang = ErrorFor<base::Reason::hang>;               // a submission did not end in time, and runs still
using OutOfMemory = ErrorFor<base::Reason::out_of_memory>;  // of the device, or of the host in its service
using Unsupported =
    ErrorFor<base::Reason::unsupported>;  // the device, or its GLSL, lacks what a function needs

// A run whose outputs are unreliable: the kernel did not complete for every input, wrote outside its memory,
// or cannot be interpreted.
class Fault : public Error {
    using Error::Error;
};

// A Fault of one input, whose result is undefined: the kernel reads or writes outside an array, or does not
// end.
class UndefinedResult : public Fault {
    using Fault::Fault;
};

// Properties of float32 arithmetic that a driver reports (VkPhysicalDeviceFloatControlsProperties).
struct FloatControls {
    bool preserves_signed_zero_inf_nan = false;
    bool preserves_denormals = false;
    bool flushes_denormals = false;
    bool rounds_to_even = false;
    bool rounds_to_zero = false;
};

// How exactly a device samples: bits behind the point of a texel's coordinate, and of a level, with which it
// calculates weights; whether it filters depths by the rules of linear filters.
struct SamplerPrecision {
    std::uint32_t subtexel_bits = 4;
    std::uint32_t level_bits = 4;
    bool filters_depth = false;
};

// A device as it describes itself. `index`: of a Vulkan device, its position in
// backend::vulkan::list_devices().
struct DeviceInfo {
    std::size_t index = 0;
    std::string name;             // "llvmpipe (LLVM 15.0.6, 256 bits)"
    std::string manifest;         // of its driver, where it was asked for or tells devices of one name apart
    std::size_t of_manifest = 0;  // then, its position among the devices of that driver
    std::string type;         // "cpu", "integrated", "discrete", "virtual", "other"; "opengl", "opengl es";
                              // "interpreter"
    std::string driver;       // driver name and its own version text, or its version if it has no text
    std::string api_version;  // "1.3.230", "OpenGL 4.5"
    std::string identity;     // hexadecimal; it changes whenever compiled pipelines become invalid
    std::string glsl;         // the version of GLSL in which it takes kernels, as "450" or "310es"; empty: it
                              // takes SPIR-V modules
    std::uint32_t max_image_size = 0;  // pixels, each side of a 2-D image
    std::uint64_t max_buffer_bytes = 0;
    std::array<std::uint32_t, 3> max_group_count{};
    std::uint32_t subgroup_size = 0;
    double timestamp_period_ns = 0.0;  // 0: the device has no timestamps
    FloatControls float32;
    SamplerPrecision samplers;
};

// The value of a specialization constant: the 32-bit pattern of the bool, int, uint or float.
struct Constant {
    std::uint32_t id = 0;  // constant_id
    std::uint32_t bits = 0;
};

// The invocations that evaluate one input of a kernel together.
struct Team {
    enum class Kind {
        alone,
        quad,  // 2 x 2 fragments, which have derivatives
        group  // a work group, with shared memory, barriers and subgroups
    };
    Kind kind = Kind::alone;
    std::array<std::uint32_t, 3> size{1, 1, 1};  // of a quad 2, 2, 1

    [[nodiscard]] std::uint32_t count() const { return size[0] * size[1] * size[2]; }
    friend bool operator==(const Team&, const Team&) = default;
};
inline constexpr Team quad_team{.kind = Team::Kind::quad, .size = {2, 2, 1}};

// A kernel is a function that is evaluated once for each of many inputs. Its storage buffers, of descriptor
// set 0:
struct KernelBinding {
    static constexpr unsigned inputs = 0;
    static constexpr unsigned outputs = 1;
    static constexpr unsigned faults = 2;
    static constexpr unsigned first_image = 3;
};

inline constexpr unsigned kernel_group_size = 64;

// Push constants of every kernel.
struct KernelRun {
    Word count = 0;       // inputs
    Word row_length = 0;  // invocations in one row of work groups; of teams, the teams in a row
    Word canary = 0;      // xor the position of the input: written behind every output
};

// Words of the fault buffer: the number of accesses outside their image, and the first recorded one.
struct KernelFaults {
    Word count = 0;
    Word image = 0;
    Word x = 0;
    Word y = 0;
    Word input = 0;
};

// Words behind the outputs, which no kernel may change.
inline constexpr std::size_t guard_words = 64;

// An image of a kernel: a storage buffer that it reads, unless it is one of these.
struct KernelImage {
    bool sampled = false;      // a sampler reads it
    std::string layered = {};  // the format of a storage image with a layer for each input
};

// A kernel before a device compiles it.
struct KernelProgram {
    std::vector<Word> spirv;
    std::vector<Constant> constants = {};
    std::string text = {};  // the same kernel in the language of DeviceInfo::glsl
    std::size_t input_words = 0;
    std::size_t output_words = 0;
    std::size_t fixed_inputs = 0;  // inputs that are constants of the module; 0: they come from memory
    std::vector<KernelImage> images = {};
    std::array<std::uint32_t, 2> layer_size{};  // the sides of all images with layers, which begin empty
    std::string name = {};                      // for messages
    Team team = {};
    // Of a quad: the shader before it, of the corners (-1, -1), (1, -1), (-1, 1).
    std::vector<Word> vertex_spirv = {};

    // Words of an input or of an output row, whichever are more.
    [[nodiscard]] std::size_t widest() const { return std::max(input_words, output_words + 1); }
};

// The memory of a run.
struct KernelMemory {
    std::span<const Word> inputs;  // a row of KernelProgram::input_words for each
    std::vector<Word> outputs;     // a row for each: output_words, the canary; behind all rows guard_words
    KernelFaults faults{};
    // Each a width, a height, a border, then its texels; a sampled one as in backend/sampled.hpp; of a
    // layered one no words.
    std::span<const std::vector<Word>> images;
};

// A compiled kernel. Its device must outlive it.
class Kernel {
  public:
    Kernel() = default;
    virtual ~Kernel() = default;
    Kernel(const Kernel&) = delete;
    Kernel& operator=(const Kernel&) = delete;

    // That one run takes.
    [[nodiscard]] virtual std::size_t most_inputs() const = 0;

    // Evaluates `count` inputs and waits. Changes the outputs and the faults. Throws DeviceLost, Hang,
    // OutOfMemory, Fault.
    virtual void run(std::size_t count, Word canary, KernelMemory& memory) const = 0;
};

class Backend {
  public:
    Backend() = default;
    virtual ~Backend() = default;
    Backend(const Backend&) = delete;
    Backend& operator=(const Backend&) = delete;

    [[nodiscard]] virtual const DeviceInfo& info() const = 0;

    // Throws DeviceLost, OutOfMemory; Fault for what the interpreter does not know; std::invalid_argument for
    // more images than the device has room for; other std::runtime_error if the driver rejects the kernel.
    [[nodiscard]] virtual std::unique_ptr<Kernel> make_kernel(const KernelProgram& program) const = 0;

    // Messages of Vulkan's validation layers (warnings and errors, one line each) since the last call, oldest
    // first.
    [[nodiscard]] virtual std::vector<std::string> take_validation_messages() { return {}; }
};

}  // namespace gloam::backend
