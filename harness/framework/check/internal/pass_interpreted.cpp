// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "check/internal/pass_work.hpp"
#include "interpreter/machine.hpp"

namespace gloam::check::internal {
namespace {

// What an image of this format keeps of a word that a shader writes.
Word stored(gpu::Format format, Word word) {
    const auto value = std::bit_cast<float>(word);
    switch (format) {
        case gpu::Format::r16f:
        case gpu::Format::rg16f:
        case gpu::Format::rgba16f:
            return std::bit_cast<Word>(glm::unpackHalf1x16(glm::packHalf1x16(value)));
        case gpu::Format::r8:
        case gpu::Format::rgba8:
            return std::bit_cast<Word>(value > 0.0F ? std::round(std::min(value, 1.0F) * 255.0F) / 255.0F
                                                    : 0.0F);
        case gpu::Format::r16ui:
        case gpu::Format::rg16ui:
        case gpu::Format::rgba16ui:
            return std::min(word, 0xFFFFU);
        default:
            return word;
    }
}

// A pass whose bindings are bound. The machine sees four words for each texel of an image.
class InterpretedPass {
  public:
    InterpretedPass(const shader::Spirv& module, PassWork& work)
        : work_(work), machine_(interpreter::Program(module, work.constants)), seen_(work.bindings.size()) {
        parameters_.resize(work.push_constants.size() / sizeof(Word));
        std::ranges::copy(work.push_constants, std::as_writable_bytes(std::span(parameters_)).begin());
        machine_.bind_push_constants(parameters_);
        for (std::uint32_t b = 0; b < seen_.size(); ++b) {
            if (const auto* image = std::get_if<BoundImage>(&work.bindings[b])) seen_[b] = widened(*image);
            if (const auto* buffer = std::get_if<BoundBuffer>(&work.bindings[b])) seen_[b] = buffer->words;
            bind(b);
        }
    }

    void run() {
        const auto for_each = [](const std::array<std::uint32_t, 3>& counts, std::array<std::uint32_t, 3>& at,
                                 const auto& visit) {
            for (at[2] = 0; at[2] < counts[2]; ++at[2])
                for (at[1] = 0; at[1] < counts[1]; ++at[1])
                    for (at[0] = 0; at[0] < counts[0]; ++at[0]) visit();
        };
        interpreter::Invocation at{.group_size = work_.group_size, .groups = work_.groups};
        for_each(work_.groups, at.group, [&] {
            machine_.set_group(at);
            machine_.run();
            for (std::uint32_t b = 0; b < seen_.size(); ++b) keep_writes(b);
        });
        for (std::uint32_t b = 0; b < seen_.size(); ++b) take(work_.bindings[b], seen_[b]);
    }

  private:
    static std::vector<Word> widened(const BoundImage& image) {
        const auto channels = static_cast<std::size_t>(gpu::channels(image.format));
        const Word one = image.integers ? 1U : std::bit_cast<Word>(1.0F);
        std::vector<Word> words;
        for (std::size_t first = 0; first < image.texels.size(); first += channels)
            for (std::size_t c = 0; c < 4; ++c)
                words.push_back(c < channels ? image.texels[first + c] : (c == 3 ? one : 0U));
        return words;
    }

    void bind(std::uint32_t b) {
        if (const auto* image = std::get_if<BoundImage>(&work_.bindings[b])) {
            const glm::uvec2 size(image->size);
            machine_.bind(0, b, interpreter::ImageView{.size = {size.x, size.y, 1}, .texels = seen_[b]});
        } else if (const auto* sampler = std::get_if<BoundSampler>(&work_.bindings[b])) {
            machine_.bind(0, b, interpreter::sampled_view_of(sampler->words, {}));
        } else {
            machine_.bind(0, b, seen_[b]);
        }
    }

    void keep_writes(std::uint32_t b) {
        const auto* image = std::get_if<BoundImage>(&work_.bindings[b]);
        machine_.keep_writes(0, b, [&](std::size_t word, Word bits) {
            return seen_[b][word] = image == nullptr ? bits : stored(image->format, bits);
        });
    }

    static void take(Bound& bound, const std::vector<Word>& seen) {
        if (auto* buffer = std::get_if<BoundBuffer>(&bound)) buffer->words = seen;
        auto* image = std::get_if<BoundImage>(&bound);
        if (image == nullptr) return;
        const auto channels = static_cast<std::size_t>(gpu::channels(image->format));
        for (std::size_t i = 0; i < image->texels.size(); ++i)
            image->texels[i] = seen[i / channels * 4 + i % channels];
    }

    PassWork& work_;
    interpreter::Machine<float> machine_;
    std::vector<std::vector<Word>> seen_;
    std::vector<Word> parameters_;
};

}  // namespace

void run_interpreted(const PassInterface& pass, PassWork& work) {
    try {
        InterpretedPass(pass.module, work).run();
    } catch (const interpreter::Error& error) {
        const std::string message = pass.name + ": " + error.what();
        if (error.kind() == interpreter::Error::Kind::unknown_instruction)
            throw backend::Unsupported(message);
        throw backend::Fault(message);
    }
}

}  // namespace gloam::check::internal
