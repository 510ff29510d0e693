// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "backend/backend.hpp"
#include "backend/gl/device.hpp"
#include "backend/vulkan/device.hpp"
#include "backend/vulkan/resources.hpp"
#include "module/reflection.hpp"
#include "pass/pass.hpp"

namespace gloam::pass::internal {

// A name of a pass, and what stands behind it.
struct PassSlot {
    enum class Kind { image, buffer_member, push_constant, constant };

    Kind kind = Kind::image;
    std::string name;        // as users give it
    std::string other_name;  // a second one: "Block.member", the number of a constant
    std::string says;        // what is expected: "int", "image of vec4", "sampler2D"
    module::Type type;       // of a value, or of a pixel
    std::size_t index = 0;   // of the binding or constant in its list
    module::LaidOut member;  // of a block

    // Of an array of which the buffer holds as many elements as are given.
    [[nodiscard]] bool is_unbounded() const { return !type.sizes.empty() && type.sizes.front() == 0; }
};

struct PassInterface {
    std::string name;  // for messages: "blur.comp"
    module::Spirv module;
    module::ModuleInterface declared;
    std::vector<PassSlot> slots;
    std::string text = {};  // the same shader for OpenGL; empty: what SPIRV-Cross makes of the module
};

// Throws std::invalid_argument, with the pass and the name, for what a pass cannot have.
[[nodiscard]] PassInterface interface_of(std::string name, module::Spirv module, std::string text);

// The place in bytes of each scalar of a member, in the order of a C++ value's words. `elements`: of an
// unbounded array.
[[nodiscard]] std::vector<std::size_t> places_of(const module::LaidOut& member, std::size_t elements);

// The format that GLSL calls so.
[[nodiscard]] std::optional<backend::vulkan::Format> format_named(const std::string& name);

// What stands at a binding during a run, in the host's memory. A run changes it as the pass does.
struct Bound {
    enum class Kind { nothing, image, sampler, storage, uniform };

    Kind kind = Kind::nothing;
    // Of an image four for each texel, bits of the floats or integers that the shader sees; of a sampler
    // those of backend/sampled.hpp.
    std::vector<Word> words;
    std::vector<bool> fresh;  // by word: not given
    // Of an image; of a sampler without a state, which reads the nearest texel, of 32 bits.
    backend::vulkan::Format format = backend::vulkan::Format::rgba32f;
    glm::ivec2 size{1};
    bool integers = false;
    bool written = false;    // the shader may write to it
    bool stateless = false;  // a sampler

    [[nodiscard]] std::size_t channels() const {
        return static_cast<std::size_t>(backend::vulkan::channels(format));
    }
    // Of an image, and of a sampler's one level.
    [[nodiscard]] std::span<const Word> texels() const {
        return std::span(words).subspan(kind == Kind::sampler ? backend::sampled_header_words : 0);
    }
};
using backend::texel_words;

struct PassWork {
    std::vector<Bound> bindings;  // by number
    std::vector<std::byte> push_constants;
    std::vector<backend::Constant> constants;
    std::array<std::uint32_t, 3> groups{};
    std::array<std::uint32_t, 3> group_size{};
};

// A run of a pass with these inputs, ready but for the contents of what is not given. Throws
// std::invalid_argument like Pass::run().
[[nodiscard]] PassWork bound(const PassInterface& pass, const PassInputs& inputs, const PassOptions& options);
[[nodiscard]] PassWork bound(const PassInterface& pass, const PassBindings& bindings);

// Run a pass on a Vulkan device, once for each work. Throws like backend::vulkan::Commands and the pipelines.
void run_on_device(const backend::vulkan::Device& device, const PassInterface& pass,
                   std::span<PassWork> works);

// The same on OpenGL. Throws backend::Unsupported for what the version lacks.
void run_on_opengl(const backend::gl::Device& device, const PassInterface& pass, std::span<PassWork> works);

// The same on the interpreter, one invocation after another. Throws backend::Unsupported for instructions
// that it does not know; backend::Fault, with the place, for an access outside an image or array.
void run_interpreted(const PassInterface& pass, std::span<PassWork> works);

}  // namespace gloam::pass::internal
