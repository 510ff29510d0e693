// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <deque>

#include "backend/vulkan/commands.hpp"
#include "check/internal/pass_work.hpp"

namespace gloam::check::internal {
namespace {

gpu::Extent extent_of(glm::ivec2 size) {
    return {static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y)};
}

bool has_short_integers(gpu::Format format) {
    return format == gpu::Format::r16ui || format == gpu::Format::rg16ui || format == gpu::Format::rgba16ui;
}

// Uploads and downloads take floats: integers of 16 bits by value, those of 32 by their bits.
float to_texel(gpu::Format format, Word word) {
    return has_short_integers(format) ? static_cast<float>(word) : std::bit_cast<float>(word);
}
Word from_texel(gpu::Format format, float texel) {
    return has_short_integers(format) ? static_cast<Word>(texel) : std::bit_cast<Word>(texel);
}

// The memory of a run on the device.
class DeviceMemory {
  public:
    DeviceMemory(const gpu::Device& device, const PassWork& work) : device_(device) {
        for (const Bound& bound : work.bindings) std::visit([this](const auto& one) { add(one); }, bound);
    }

    void read_back(PassWork& work) const {
        for (std::size_t i = 0; i < work.bindings.size(); ++i) {
            if (auto* image = std::get_if<BoundImage>(&work.bindings[i]); image != nullptr && image->written)
                read(std::get<std::reference_wrapper<const gpu::Image>>(resources[i]), *image);
            if (auto* buffer = std::get_if<BoundBuffer>(&work.bindings[i])) {
                const gpu::Buffer& memory = std::get<std::reference_wrapper<const gpu::Buffer>>(resources[i]);
                std::ranges::copy(memory.as<Word>(), buffer->words.begin());
            }
        }
    }

    std::vector<gpu::Resource> resources;
    std::vector<gpu::BindingKind> kinds;

  private:
    const gpu::Buffer& make_buffer(const std::vector<Word>& contents) {
        gpu::Buffer& buffer = buffers_.emplace_back(device_, contents.size() * sizeof(Word));
        std::ranges::copy(contents, buffer.as<Word>().begin());
        return buffer;
    }
    void add(std::monostate) { add(gpu::BindingKind::storage_buffer, make_buffer(std::vector<Word>{0})); }
    void add(const BoundImage& image) { add(gpu::BindingKind::storage_image, make_image(image)); }
    void add(const BoundBuffer& buffer) {
        add(buffer.uniform ? gpu::BindingKind::uniform_buffer : gpu::BindingKind::storage_buffer,
            make_buffer(buffer.words));
    }
    void add(const BoundSampler& sampler) {
        if (!sampler.stateless)
            return add(gpu::BindingKind::sampled_image, samplers_.emplace_back(device_, sampler.words));
        const backend::SampledHeader header = backend::sampled_header(sampler.words);
        add(gpu::BindingKind::sampled_image,
            make_image(
                {.size = {header.width, header.height},
                 .texels = {sampler.words.begin() + backend::sampled_header_words, sampler.words.end()}}));
    }
    template <class Made>
    void add(gpu::BindingKind kind, const Made& made) {
        kinds.push_back(kind);
        resources.emplace_back(std::cref(made));
    }

    gpu::Image& make_image(const BoundImage& image) {
        gpu::Image& made = images_.emplace_back(device_, extent_of(image.size), image.format);
        std::vector<float> texels;
        for (const Word word : image.texels) texels.push_back(to_texel(image.format, word));
        made.upload(texels);
        return made;
    }

    static void read(const gpu::Image& from, BoundImage& image) {
        std::ranges::transform(from.download(), image.texels.begin(),
                               [&](float texel) { return from_texel(image.format, texel); });
    }

    const gpu::Device& device_;
    std::deque<gpu::Image> images_;
    std::deque<gpu::Buffer> buffers_;
    std::deque<gpu::SampledImage> samplers_;
};

}  // namespace

void run_on_device(const gpu::Device& device, const PassInterface& pass, PassWork& work) {
    DeviceMemory memory(device, work);
    const gpu::ComputePipeline pipeline(
        device, {.spirv = pass.module,
                 .bindings = memory.kinds,
                 .push_constant_bytes = static_cast<std::uint32_t>(work.push_constants.size()),
                 .constants = work.constants});
    gpu::Commands commands(device);
    commands.dispatch(pipeline, memory.resources, work.groups, work.push_constants);
    commands.submit();
    memory.read_back(work);
}

}  // namespace gloam::check::internal
