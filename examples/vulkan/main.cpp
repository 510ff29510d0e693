// SPDX-License-Identifier: MIT
// Ambient occlusion of a sequence of G-buffers, by the passes that `gloam pack --effect` wrote: packed_effect
// GBUFFERS OUT. gloam_effect.h says what there is to make, to bind and to run; nothing here knows a pass or a
// method by its name.
#include <gloam_effect.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>
#include <stdexcept>

#include "device.hpp"
#include "files.hpp"

namespace {

namespace fs = std::filesystem;

// What the bindings mean in this frame, by the numbers of gloam_effect.h.
struct Resources {
    const std::vector<const Image*>& images;
    const std::vector<Buffer*>& buffers;
};

// The first channel of a texel, as it is.
float first_channel(const std::byte* texel, VkFormat format) {
    if (format == VK_FORMAT_R32_SFLOAT || format == VK_FORMAT_R32G32B32A32_SFLOAT) {
        float value = 0.0F;
        std::memcpy(&value, texel, sizeof value);
        return value;
    }
    if (format == VK_FORMAT_R8_UNORM) return static_cast<float>(static_cast<unsigned char>(*texel)) / 255.0F;
    std::uint16_t bits = 0;
    std::memcpy(&bits, texel, sizeof bits);
    if (format == VK_FORMAT_R16G16B16A16_UINT) return static_cast<float>(bits);
    // A half of [0, 1]: no sign, no infinity.
    const int exponent = bits >> 10;
    const auto mantissa = static_cast<float>((bits & 0x3FFU) + (exponent > 0 ? 0x400U : 0U));
    return std::ldexp(mantissa, std::max(exponent, 1) - 25);
}

std::vector<std::uint32_t> identity() {
    std::vector<std::uint32_t> words(16);
    for (std::size_t i = 0; i < 4; ++i) words[5 * i] = std::bit_cast<std::uint32_t>(1.0F);
    return words;
}

// The constants of the half-size view, for passes whose divisor is 2.
View half_view(const View& view) {
    View half = view;
#ifdef GLOAM_HALF_RESOLUTION
    gloam_view_constants constants;
    const std::pair<const char*, void*> members[] = {
        {"size", constants.size},
        {"border", constants.border},
        {"p00_p11", constants.p00_p11},
        {"previous_p00_p11", constants.previous_p00_p11},
        {"previous_from_current", constants.previous_from_current}};
    for (const auto& [name, member] : members)
        std::memcpy(member, view.at(name).data(), 4 * view.at(name).size());
    constants = gloam_half_view(&constants);
    for (const auto& [name, member] : members)
        std::memcpy(half.at(name).data(), member, 4 * half.at(name).size());
#endif
    return half;
}

class Pass {
  public:
    Pass(const Device& device, const gloam_pass_info& info)
        : info_(info),
          bindings_(info.bindings, info.bindings + info.binding_count),
          set_layout_(make_set_layout(device)),
          layout_(make_layout(device)),
          pipeline_(make_pipeline(device)) {}

    const gloam_pass_info& info() const { return info_; }

    // Returns what has to live until the commands have run.
    vk::raii::DescriptorSet record(const vk::raii::CommandBuffer& commands, const Device& device,
                                   const vk::raii::DescriptorPool& pool, const Resources& resources,
                                   Extent extent, const View& view, bool odd) const {
        vk::raii::DescriptorSet set = written_set(device, pool, resources);
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline_);
        commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout_, 0, *set, nullptr);
        const std::vector<std::uint32_t> words = push_constants(view, odd);
        if (!words.empty())
            commands.pushConstants<std::uint32_t>(*layout_, vk::ShaderStageFlagBits::eCompute, 0, words);
        const auto groups = [&](std::uint32_t side, int axis) {
            return (side + info_.pixels[axis] - 1) / info_.pixels[axis];
        };
        if (info_.list_buffer >= 0)
            commands.dispatchIndirect(*resources.buffers[info_.list_buffer]->handle, info_.list_offset);
        else if (info_.pixels[0] == 0)
            commands.dispatch(info_.groups[0], info_.groups[1], info_.groups[2]);
        else
            commands.dispatch(groups(extent.width, 0), groups(extent.height, 1), 1);
        barrier(commands);
        return set;
    }

  private:
    vk::raii::DescriptorSetLayout make_set_layout(const Device& device) const {
        std::vector<vk::DescriptorSetLayoutBinding> bindings;
        for (const gloam_binding& b : bindings_)
            bindings.emplace_back(b.number, vk::DescriptorType(b.type), 1, vk::ShaderStageFlagBits::eCompute);
        return {device.get(), vk::DescriptorSetLayoutCreateInfo({}, bindings)};
    }
    vk::raii::PipelineLayout make_layout(const Device& device) const {
        const vk::PushConstantRange range(vk::ShaderStageFlagBits::eCompute, 0, info_.preset_bytes);
        vk::PipelineLayoutCreateInfo create({}, *set_layout_);
        if (info_.preset_bytes > 0) create.setPushConstantRanges(range);
        return {device.get(), create};
    }
    vk::raii::Pipeline make_pipeline(const Device& device) const {
        const auto words = read_words(fs::path(MODULES) / (std::string(info_.name) + ".spv"));
        const vk::raii::ShaderModule module(device.get(), vk::ShaderModuleCreateInfo({}, words));
        const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main");
        return {device.get(), nullptr, vk::ComputePipelineCreateInfo({}, stage, *layout_)};
    }
    vk::raii::DescriptorSet written_set(const Device& device, const vk::raii::DescriptorPool& pool,
                                        const Resources& resources) const {
        vk::raii::DescriptorSets sets(device.get(), {*pool, *set_layout_});
        for (const gloam_binding& b : bindings_) {
            vk::WriteDescriptorSet write(*sets.front(), b.number, 0, 1, vk::DescriptorType(b.type));
            vk::DescriptorImageInfo image(*device.sampler(), {}, general);
            vk::DescriptorBufferInfo buffer({}, 0, VK_WHOLE_SIZE);
            if (b.image >= 0) image.imageView = *resources.images[b.image]->view;
            if (b.buffer >= 0) buffer.buffer = *resources.buffers[b.buffer]->handle;
            b.image >= 0 ? write.setPImageInfo(&image) : write.setPBufferInfo(&buffer);
            device.get().updateDescriptorSets(write, nullptr);
        }
        return std::move(sets.front());
    }
    // The preset's, and in their places the view's.
    std::vector<std::uint32_t> push_constants(const View& view, bool odd) const {
        std::vector<std::uint32_t> words(info_.preset_bytes / 4);
        if (!words.empty())
            std::memcpy(words.data(), odd ? info_.odd_preset : info_.preset, info_.preset_bytes);
        for (std::uint32_t i = 0; i < info_.member_count; ++i) {
            const gloam_member& member = info_.members[i];
            if (member.of_view == 0) continue;
            const auto value = view.find(member.name);
            if (value == view.end() || 4 * value->second.size() != member.bytes)
                throw std::runtime_error(std::string("no value for the push constant ") + member.name);
            std::ranges::copy(value->second, words.begin() + member.offset / 4);
        }
        return words;
    }

    gloam_pass_info info_;
    std::vector<gloam_binding> bindings_;
    vk::raii::DescriptorSetLayout set_layout_;
    vk::raii::PipelineLayout layout_;
    vk::raii::Pipeline pipeline_;
};

// The effect for views of one size.
class Effect {
  public:
    Effect(const Device& device, Extent extent) : device_(device), extent_(extent) {
        images_.reserve(GLOAM_IMAGES);
        for (const gloam_image_info& info : gloam_images) images_.emplace_back(device, info, extent);
        for (const Image& image : images_) bound_images_.push_back(&image);
        const std::size_t tiles = std::size_t{(extent.width + GLOAM_TILE - 1) / GLOAM_TILE} *
                                  ((extent.height + GLOAM_TILE - 1) / GLOAM_TILE);
        buffers_.reserve(GLOAM_BUFFERS);
        for (const gloam_buffer_info& info : gloam_buffers)
            buffers_.emplace_back(
                device, info.bytes + tiles * info.bytes_a_tile,
                vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eIndirectBuffer);
        for (Buffer& buffer : buffers_) bound_buffers_.push_back(&buffer);
        for (const gloam_pass_info& info : gloam_passes) passes_.emplace_back(device, info);
        run(true, {});
    }

    // Nothing is known of the frame before.
    void cut() {
        device_.run([&](const vk::raii::CommandBuffer& commands) {
            for (int i = 0; i < GLOAM_IMAGES; ++i)
                if (gloam_images[i].origin == GLOAM_KEPT)
                    commands.clearColorImage(*bound_images_[i]->handle, general, vk::ClearColorValue{},
                                             whole);
        });
        for (int i = 0; i < GLOAM_BUFFERS; ++i) fill(i);
    }

    // Occlusion of a frame, from the engine's images.
    Picture frame(const std::map<int, Picture>& given, const View& view) {
        for (const auto& [image, picture] : given) upload(*bound_images_[image], picture);
        for (int i = 0; i < GLOAM_BUFFERS; ++i)
            if (gloam_buffers[i].refilled != 0) fill(i);
        run(false, view);
        Picture result = download(*bound_images_[GLOAM_RESULT], gloam_images[GLOAM_RESULT].format);
        for (const auto& [a, b] : gloam_exchanged_images)
            if (a >= 0) std::swap(bound_images_[a], bound_images_[b]);
        for (const auto& [a, b] : gloam_exchanged_buffers)
            if (a >= 0) std::swap(bound_buffers_[a], bound_buffers_[b]);
        odd_ = !odd_;
        return result;
    }

  private:
    void fill(int buffer) {
        bound_buffers_[buffer]->fill(gloam_buffers[buffer].contents, gloam_buffers[buffer].contents_bytes);
    }

    // Those that run once, or those of a frame.
    void run(bool once, const View& view) const {
        const std::vector<vk::DescriptorPoolSize> sizes{
            {vk::DescriptorType::eStorageImage, 16 * GLOAM_PASSES},
            {vk::DescriptorType::eCombinedImageSampler, 16 * GLOAM_PASSES},
            {vk::DescriptorType::eStorageBuffer, 16 * GLOAM_PASSES}};
        const vk::raii::DescriptorPool pool(
            device_.get(), {vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, GLOAM_PASSES, sizes});
        std::vector<vk::raii::DescriptorSet> sets;  // until they have run
        const View of_half = once ? View{} : half_view(view);
        device_.run([&](const vk::raii::CommandBuffer& commands) {
            for (const Pass& pass : passes_)
                if ((pass.info().turn == GLOAM_ONCE) == once)
                    sets.push_back(pass.record(commands, device_, pool, {bound_images_, bound_buffers_},
                                               extent_, pass.info().divisor == 2 ? of_half : view, odd_));
        });
    }

    // Images have one channel or four.
    void upload(const Image& image, const Picture& picture) const {
        const std::size_t pixels = std::size_t{picture.width} * picture.height;
        if (picture.width != image.extent.width || picture.height != image.extent.height)
            throw std::runtime_error("the images of a frame differ in size");
        const std::size_t channels = picture.channels == 1 ? 1 : 4;
        Buffer staging(device_, 4 * channels * pixels, vk::BufferUsageFlagBits::eTransferSrc);
        for (std::size_t i = 0; i < pixels; ++i)
            std::memcpy(staging.data + 4 * channels * i, &picture.values[picture.channels * i],
                        4 * picture.channels);
        device_.run([&](const vk::raii::CommandBuffer& commands) {
            commands.copyBufferToImage(*staging.handle, *image.handle, general, image.all_of_it());
            barrier(commands);
        });
    }

    Picture download(const Image& image, VkFormat format) const {
        const std::size_t pixels = std::size_t{image.extent.width} * image.extent.height;
        const std::size_t texel = format == VK_FORMAT_R32_SFLOAT            ? 4
                                  : format == VK_FORMAT_R32G32B32A32_SFLOAT ? 16
                                  : format == VK_FORMAT_R16_SFLOAT          ? 2
                                  : format == VK_FORMAT_R8_UNORM            ? 1
                                                                            : 8;
        const Buffer staging(device_, texel * pixels, vk::BufferUsageFlagBits::eTransferDst);
        device_.run([&](const vk::raii::CommandBuffer& commands) {
            commands.copyImageToBuffer(*image.handle, general, *staging.handle, image.all_of_it());
            barrier(commands);
        });
        Picture picture{image.extent.width, image.extent.height, 1, std::vector<float>(pixels)};
        for (std::size_t i = 0; i < pixels; ++i)
            picture.values[i] = first_channel(staging.data + texel * i, format) * gloam_result_unit;
        return picture;
    }

    const Device& device_;
    Extent extent_;
    std::vector<Image> images_;
    std::vector<Buffer> buffers_;
    std::vector<const Image*> bound_images_;  // those that are exchanged change places
    std::vector<Buffer*> bound_buffers_;
    std::vector<Pass> passes_;
    bool odd_ = false;
};

// What the engine has, from the files of a frame.
std::map<int, Picture> engine_images(const std::string& prefix) {
    std::map<int, Picture> images;
    for (int i = 0; i < GLOAM_IMAGES; ++i)
        if (gloam_images[i].origin == GLOAM_ENGINE)
            images[i] = read_pfm(prefix + "_" + gloam_images[i].name + ".pfm");
    return images;
}

void shade(const fs::path& gbuffers, const fs::path& out) {
    const Device device;
    std::optional<Effect> effect;
    View before;
    fs::create_directories(out);
    for (int number = 0;; ++number) {
        char name[16];
        std::snprintf(name, sizeof name, "f%04d", number);
        if (!fs::exists(gbuffers / (std::string(name) + ".json"))) break;
        const std::map<int, Picture> images = engine_images((gbuffers / name).string());
        const Picture& any = images.begin()->second;
        View view = read_view(gbuffers / (std::string(name) + ".json"));
        view["size"] = {any.width, any.height};
        const bool follows =
            effect && view.contains("previous_from_current") && before["size"] == view["size"];
        if (!effect || before["size"] != view["size"]) effect.emplace(device, Extent{any.width, any.height});
        if (!follows) {
            effect->cut();
            view["previous_from_current"] = identity();
        }
        view["previous_p00_p11"] = follows ? before["p00_p11"] : view["p00_p11"];
        write_pfm(out / (std::string(name) + "_ao.pfm"), effect->frame(images, view));
        before = view;
    }
    if (!effect) throw std::runtime_error(gbuffers.string() + ": holds no f0000.json");
}

}  // namespace

int main(int count, char** arguments) {
    try {
        if (count != 3) throw std::runtime_error("usage: packed_effect GBUFFERS OUT");
        shade(arguments[1], arguments[2]);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "packed_effect: %s\n", error.what());
        return 2;
    }
}
