// SPDX-License-Identifier: MIT
// Every pass of the effect on small images: the interpreter, one work group after the other, against the
// device. Of each group it also finds races.
#include <glm/gtc/packing.hpp>

#include "backend/vulkan/commands.hpp"
#include "effect/composite.hpp"
#include "effect/directional.hpp"
#include "interpreter/machine.hpp"
#include "module/reflection.hpp"
#include "on_device.hpp"
#include "support/method_names.hpp"
#include "surface_views.hpp"

namespace gloam::effect::interpreted_passes_test {

using interpreter::Word;

// The contents of one binding: the words of a buffer, or four words of each texel.
struct Bound {
    std::vector<Word> words;
    gpu::Extent extent{};  // of an image; 0 x 0: a buffer
    int channels = 0;
};

const gpu::Image* image_of(const gpu::Resource& resource) {
    const auto* image = std::get_if<std::reference_wrapper<const gpu::Image>>(&resource);
    return image == nullptr ? nullptr : &image->get();
}

Bound read(const gpu::Resource& resource) {
    const gpu::Image* image = image_of(resource);
    if (image == nullptr) {
        const gpu::Buffer& buffer = std::get<std::reference_wrapper<const gpu::Buffer>>(resource);
        const auto words = buffer.as<Word>();
        return {.words = {words.begin(), words.end()}};
    }
    Bound bound{.words = {}, .extent = image->extent(), .channels = gpu::channels(image->format())};
    const std::vector<float> texels = image->download();
    const auto channels = static_cast<std::size_t>(bound.channels);
    for (std::size_t texel = 0; texel < texels.size() / channels; ++texel) {
        for (std::size_t c = 0; c < 4; ++c) {
            const float value = c < channels ? texels[texel * channels + c] : (c == 3 ? 1.0F : 0.0F);
            bound.words.push_back(std::bit_cast<Word>(value));
        }
    }
    return bound;
}

// What the bindings hold after the interpreter has run a pass on what they held. Throws for a race, or a
// barrier that not all invocations of a group reach.
std::vector<Bound> interpreted(const Step& pass, std::vector<Bound> bound) {
    const auto& compiled = gpu::program_of(*pass.pipeline);
    std::vector<interpreter::Constant> constants;
    for (const gpu::SpecializationConstant& constant : compiled.constants)
        constants.push_back({constant.id, constant.bits});
    const interpreter::Program program(compiled.spirv, constants);
    interpreter::Machine<float> machine(program);
    std::vector<Word> parameters(pass.parameters.size() / sizeof(Word));
    std::ranges::copy(pass.parameters, std::as_writable_bytes(std::span(parameters)).begin());
    machine.bind_push_constants(parameters);
    for (std::uint32_t b = 0; b < bound.size(); ++b) {
        Bound& one = bound[b];
        if (one.extent.width == 0)
            machine.bind(0, b, one.words);
        else
            machine.bind(0, b, {.size = {one.extent.width, one.extent.height, 1}, .texels = one.words});
    }
    const std::array<std::uint32_t, 3>& groups = pass.groups;
    interpreter::Invocation at{.group_size = shader::reflect(compiled.spirv).local_size, .groups = groups};
    for (at.group[2] = 0; at.group[2] < groups[2]; ++at.group[2])
        for (at.group[1] = 0; at.group[1] < groups[1]; ++at.group[1])
            for (at.group[0] = 0; at.group[0] < groups[0]; ++at.group[0]) {
                machine.set_group(at);
                machine.run();
                for (std::uint32_t b = 0; b < bound.size(); ++b)
                    machine.keep_writes(
                        0, b, [&](std::size_t word, Word bits) { return bound[b].words[word] = bits; });
            }
    return bound;
}

// How the words that a pass wrote compare.
struct Comparison {
    std::size_t words = 0;
    std::size_t equal = 0;  // to the bit
    std::size_t close = 0;  // equal, or floats that other square roots and quotients may tell apart
};

// Whether two results differ by rounding at most.
bool is_close(Word a, Word b) {
    constexpr float apart = 1e-4F;
    const auto x = std::bit_cast<float>(a);
    const auto y = std::bit_cast<float>(b);
    const bool are_floats = (std::isnormal(x) || x == 0.0F) && (std::isnormal(y) || y == 0.0F);
    return a == b || (are_floats && std::abs(x - y) <= apart * std::max(1.0F, std::abs(y)));
}

Comparison compared(const std::vector<Bound>& before, const std::vector<Bound>& ours,
                    const std::vector<Bound>& device) {
    Comparison all;
    for (std::size_t b = 0; b < ours.size(); ++b) {
        for (std::size_t w = 0; w < ours[b].words.size(); ++w) {
            const auto component = static_cast<int>(w % 4);
            if (ours[b].channels != 0 && component >= ours[b].channels) continue;
            const Word x = ours[b].words[w];
            const Word y = device[b].words[w];
            if (x == before[b].words[w] && y == x) continue;  // not written
            ++all.words;
            all.equal += x == y ? 1 : 0;
            all.close += is_close(x, y) ? 1 : 0;
        }
    }
    return all;
}

// An image may be bound twice: written first, then read where earlier passes have written. Both bindings show
// what the pass has written.
void copy_to_second_bindings(const Step& pass, std::vector<Bound>& bound) {
    for (std::size_t second = 0; second < bound.size(); ++second) {
        const gpu::Image* image = image_of(pass.resources[second]);
        for (std::size_t first = 0; image != nullptr && first < second; ++first)
            if (image_of(pass.resources[first]) == image && bound[first].extent.width > 1)
                bound[second] = bound[first];
    }
}

class InterpretedPasses : public OnDevice<testing::Test> {
  protected:
    static constexpr std::size_t most_frames = 3;

    [[nodiscard]] std::vector<scene::GBuffer> moving(gpu::Extent extent) const {
        std::vector<scene::GBuffer> views;
        for (int frame = 0; frame < static_cast<int>(most_frames); ++frame)
            views.push_back(drawn("moving", extent, {.frame = frame, .motion = true}));
        return views;
    }

    // The passes of the frames of one view, or of as many as there are.
    void expect_the_devices(const std::vector<scene::GBuffer>& views, const Settings& settings,
                            const std::string& what, std::size_t frames = most_frames) {
        AmbientOcclusion effect(device_, passes_, views.front().extent);
        effect.watch(watcher(what));
        for (std::size_t i = 0; i < frames; ++i) {
            if (i == 0) effect.begin(views.front(), settings);
            if (i > 0 && i < views.size()) effect.advance(views[i]);
            (void)effect.next();
        }
    }

    // Compares each pass with the interpreter.
    PassWatcher watcher(const std::string& what) {
        return [this, what, before = std::vector<Bound>()](const Step& pass, bool after) mutable {
            std::vector<Bound> now;
            for (const gpu::Resource& resource : pass.resources) now.push_back(read(resource));
            if (after) {
                expect_same(pass, before, now, what);
            } else {
                before = std::move(now);
            }
        };
    }

    std::map<std::string, Comparison> seen_;  // by the name of the pass

  private:
    void expect_same(const Step& pass, const std::vector<Bound>& before, const std::vector<Bound>& device,
                     const std::string& what) {
        std::vector<Bound> ours = interpreted(pass, before);
        copy_to_second_bindings(pass, ours);
        const Comparison one = compared(before, ours, device);
        EXPECT_EQ(one.close, one.words) << what << ", " << pass.name;
        Comparison& sum = seen_[pass.name];
        sum.words += one.words;
        sum.equal += one.equal;
    }
};

class InterpretedPassesOf : public InterpretedPasses, public testing::WithParamInterface<std::string> {};

TEST_P(InterpretedPassesOf, AreTheDevicesPixelByPixel) {
    const scene::GBuffer view = drawn("moving", {13, 9}, {.layers = 2});
    Settings settings = with_radius(with_method({}, GetParam()), 0.5F);
    if (reads(method_named(GetParam()), "layers")) settings.own.layers = 2;
    expect_the_devices({view}, settings, GetParam(), 2);
    EXPECT_GT(seen_["ambient_occlusion"].equal * 10, seen_["ambient_occlusion"].words * 6)
        << "most results have the same bits";
}

// Those that prepare images, whose passes are their own. What the others call is interpreted for the
// catalogue.
INSTANTIATE_TEST_SUITE_P(All, InterpretedPassesOf,
                         testing::ValuesIn(test::method_names([](const MethodInfo& method) {
                             return method.prepare != nullptr || method.name == "hemisphere";
                         })),
                         test::parameter_name);

TEST_F(InterpretedPasses, OfAMovingSceneAreTheDevicesPixelByPixel) {
    std::vector<scene::GBuffer> views = moving({37, 21});
    for (scene::GBuffer& view : views) view.normal.clear();
    for (const Filter filter : {Filter::convergence, Filter::geometry, Filter::bilateral, Filter::sao}) {
        Settings settings;
        settings.filter = filter;
        settings.remap_c = 1.5F;
        expect_the_devices(views, settings, "moving");
    }
    for (const char* name : {"ambient_occlusion", "filter_x", "filter_y", "normals_from_depth", "remap",
                             "remap_filtered", "reproject"})
        EXPECT_GT(seen_[name].words, 0U) << name;
}

// Those of bent normals, of light and of the lit image.
TEST_F(InterpretedPasses, BesideTheEffectAreTheDevicesPixelByPixel) {
    const scene::GBuffer view = drawn("moving", {13, 9});
    const Settings settings = with_radius({}, 0.5F);
    Directional directional(device_, passes_);
    directional.watch(watcher("directional"));
    for (const int interleave : {1, 3}) (void)directional.bent_normals(view, settings, {interleave});
    (void)directional.light(view, settings, clear_sky);

    Composite composite(device_, passes_);
    composite.watch(watcher("composite"));
    const std::vector<glm::vec3> light(view.depth.size(), glm::vec3(0.5F, 0.25F, 2.0F));
    (void)composite.lit(view.extent, light, light, std::vector<float>(view.depth.size(), 0.25F));
    for (const char* name : {"bent_normals", "bent_gather", "direct_light", "bounced_light", "composite"})
        EXPECT_GT(seen_[name].words, 0U) << name;
}

}  // namespace gloam::effect::interpreted_passes_test
