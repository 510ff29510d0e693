// SPDX-License-Identifier: MIT
// The passes of a frame as compute shaders of OpenGL 4.5 and OpenGL ES 3.1: the picture is that of Vulkan.
#include "backend/gl/opened.hpp"
#include "backend/gl/program.hpp"
#include "effect/errors.hpp"
#include "effect/internal/frame.hpp"
#include "effect/plan.hpp"
#include "module/reflection.hpp"
#include "numeric/numbers.hpp"
#include "on_device.hpp"
#include "support/method_names.hpp"
#include "support/poison.hpp"

namespace gloam::effect::opengl_passes_test {

std::vector<gl::Word> words_of(std::span<const std::byte> bytes) {
    std::vector<gl::Word> words((bytes.size() + sizeof(gl::Word) - 1) / sizeof(gl::Word));
    std::memcpy(words.data(), bytes.data(), bytes.size());
    return words;
}

gl::Image::Format format_of(gpu::Format format) {
    using enum gl::Image::Format;
    static const std::map<gpu::Format, gl::Image::Format> formats{{gpu::Format::r8, r8},
                                                                  {gpu::Format::r16f, r16f},
                                                                  {gpu::Format::r32f, r32f},
                                                                  {gpu::Format::r32ui, r32ui}};
    const auto found = formats.find(format);
    return found == formats.end() ? rgba32f : found->second;
}

std::string text_of(const PlannedPass& pass, const scene::PassLibrary& passes, shader::Language language) {
    std::map<std::uint32_t, std::uint32_t> constants;
    for (const auto& constant : pass.source.constants) constants[constant.id] = constant.bits;
    std::vector<std::string> defines = pass.source.defines;
    defines.emplace_back("GLOAM_PARAMETER_BLOCK");
    return passes.text(pass.source.file, defines, pass.source.replaced, constants, language);
}

// The plan of a first frame, executed on a device of OpenGL.
class OnOpenGl {
  public:
    OnOpenGl(const gl::Device& device, const Plan& plan, const scene::GBuffer& view,
             const scene::PassLibrary& passes)
        : device_(device),
          es_(device.info().id.version.api == gl::Api::es),
          plan_(plan),
          view_(view),
          passes_(passes) {
        for (const PlannedImage& image : plan.images) {
            const auto [place, is_new] =
                images_.try_emplace(image.name, device, format_of(image.format), image.extent.width,
                                    image.extent.height, image.levels);
            EXPECT_TRUE(is_new) << image.name;
            if (image.origin == PlannedImage::Origin::engine) fill(image.name, place->second);
        }
        for (const PlannedBuffer& buffer : plan.buffers) {
            const auto place =
                buffers_.try_emplace(buffer.name, device, buffer.contents.size() / sizeof(gl::Word) + 1)
                    .first;
            place->second.write(0, words_of(buffer.contents));
        }
    }

    [[nodiscard]] std::vector<float> run() {
        for (const PlannedPass& pass : plan_.passes) run(pass);
        const std::vector<float> texels = images_.at(plan_.result).read();
        std::vector<float> occlusion;
        for (std::size_t i = 0; i < texels.size(); i += 4) occlusion.push_back(texels[i]);
        return occlusion;
    }

  private:
    void fill(const std::string& name, gl::Image& image) const {
        if (name == "depth") return image.write(view_.depth);
        ASSERT_EQ(name, "normal");
        std::vector<float> channels;
        for (const glm::vec3& normal : view_.normal)
            channels.insert(channels.end(), {normal.x, normal.y, normal.z, 0.0F});
        image.write(channels);
    }

    void run(const PlannedPass& pass) {
        const auto language = es_ ? shader::Language::es310 : shader::Language::gl430;
        const gl::Program program(device_, gl::Program::Stage::compute,
                                  {.name = pass.source.file, .text = text_of(pass, passes_, language)});
        gl::Dispatch work{.program = program, .storage = {}, .uniforms = {}, .groups = pass.groups};
        for (std::uint32_t binding = 0; binding < pass.resources.size(); ++binding) {
            const ImageName name = image_name_of(pass.resources[binding]);
            if (const auto image = images_.find(name.image); image != images_.end())
                work.images.emplace(binding, image->second);
            work.levels.emplace(binding, name.level.value_or(0));
            if (const auto buffer = buffers_.find(pass.resources[binding]); buffer != buffers_.end())
                work.storage.emplace(binding, buffer->second);
        }
        std::vector<gl::Word> values = words_of(with_camera(pass));
        values.resize((values.size() + 3) / 4 * 4);  // a uniform block ends with a vec4
        gl::Buffer parameters(device_, values.size());
        parameters.write(0, values);
        work.uniforms.emplace(0, parameters);
        gl::dispatch(device_, work);
    }

    // The plan knows the view's size, not its camera.
    [[nodiscard]] std::vector<std::byte> with_camera(const PlannedPass& pass) const {
        std::vector<std::byte> bytes = pass.parameters;
        const shader::ModuleInterface interface = shader::reflect(module_of(pass.source, passes_));
        const glm::vec2 camera = view_.camera.p00_p11();
        for (const shader::LaidOut& member : interface.push_constants.value().members)
            if (member.name == "p00_p11") std::memcpy(bytes.data() + member.offset, &camera, sizeof camera);
        return bytes;
    }

    const gl::Device& device_;
    bool es_;
    const Plan& plan_;
    const scene::GBuffer& view_;
    const scene::PassLibrary& passes_;
    std::map<std::string, gl::Image> images_;
    std::map<std::string, gl::Buffer> buffers_;
};

// Those that prepare images, and some that do not: tests/glsl/languages_test.cpp has each as a function.
std::vector<std::string> passes_of_methods() {
    std::vector<std::string> names{"hemisphere", "gtao", "bitmask"};
    const auto prepared =
        test::method_names([](const MethodInfo& method) { return method.prepare != nullptr; });
    names.insert(names.end(), prepared.begin(), prepared.end());
    return names;
}

class OpenGlPasses : public OnDevice<testing::TestWithParam<std::string>> {};

// On both devices, so that Vulkan's picture is made once.
constexpr std::array device_names{"gl:llvmpipe-4.5", "es:llvmpipe-3.1"};

// Why there is no such device; empty: there is.
std::string why_not_opened(std::optional<gl::Device>& device, const char* name) {
    try {
        device.emplace(name);
    } catch (const gl::Unavailable& error) {
        return error.what();
    }
    return {};
}

TEST_P(OpenGlPasses, GiveThePictureOfVulkan) {
    const gpu::Extent extent{49, 35};
    const scene::GBuffer view = drawn("room", extent, {});
    Settings settings = with_method(preset_named("tssao-paper").settings, GetParam());
    const Plan plan = plan_of(settings, {.view = extent, .first = true}, passes_);
    const std::vector<float> want = run(view, settings).filtered;
    const auto [least, most] = std::ranges::minmax(want);
    EXPECT_GT(most - least, 0.01F);
    for (const char* name : device_names) {
        std::optional<gl::Device> device;
        if (const std::string why = why_not_opened(device, name); !why.empty()) GTEST_SKIP() << why;
        const std::vector<float> got = OnOpenGl(*device, plan, view, passes_).run();
        ASSERT_EQ(got.size(), want.size());
        const double largest = largest_difference(got, want);
        EXPECT_LT(largest, 1e-5) << name;
        RecordProperty(name, numeric::to_short_text(largest));
    }
}

INSTANTIATE_TEST_SUITE_P(All, OpenGlPasses, testing::ValuesIn(passes_of_methods()), test::parameter_name);

// Of an odd size, poisoned.
class OpenGlFrames : public OnDevice<testing::TestWithParam<Preset>> {};

TEST_P(OpenGlFrames, GiveThePictureOfVulkan) {
    std::optional<gl::Device> device;
    if (const std::string why = why_not_opened(device, device_names[0]); !why.empty()) GTEST_SKIP() << why;
    for (const bool from_depth : {false, true}) {
        scene::GBuffer view = drawn("columns", {83, 45});
        test::poison(view);
        if (from_depth) view.normal.clear();
        Settings settings = GetParam().settings;
        settings.output = OutputFormat::r32f;
        settings.history = false;
        const Plan plan = frame_plan(settings, view);
        const std::vector<float> want = run(view, settings).filtered;
        const std::vector<float> got = OnOpenGl(*device, plan, view, passes_).run();
        ASSERT_EQ(got.size(), want.size());
        // A tap within rounding of a limit counts on one driver and not on the other.
        EXPECT_LT(errors_of(got, want).rmse, 1e-3) << from_depth;
        EXPECT_LT(largest_difference(got, want), 0.06) << from_depth;
        EXPECT_GT(std::ranges::max(want), 0.5F);
    }
}

INSTANTIATE_TEST_SUITE_P(All, OpenGlFrames, testing::ValuesIn(frames_of_all_resolutions()), preset_name);

// The passes of the effect as one text each in GLSL ES 3.10: Mesa's compiler takes them.

class EsPasses : public gl::Opened {
  protected:
    void expect_linked(const Settings& settings, const PlanOptions& options) {
        for (const PlannedPass& pass : plan_of(settings, options, passes_).passes) {
            const std::string text = text_of(pass, passes_, shader::Language::es310);
            if (!seen_.insert(text).second) continue;
            EXPECT_NO_THROW(gl::Program(device(), gl::Program::Stage::compute, {pass.name, text}))
                << settings.method << " " << pass.name;
            files_.insert(pass.source.file);
        }
    }

    scene::PassLibrary passes_{GLOAM_GLSL_DIR};
    std::set<std::string> seen_;
    std::set<std::string> files_;
};

TEST_F(EsPasses, AreTakenByADriver) {
    GLOAM_OPEN_OR_SKIP("es:llvmpipe-3.1");
    Settings moving = with_method({}, "gtao");
    moving.remap_b = 2.0F;
    expect_linked(moving, {.moving_objects = true, .normals = false});
    Settings other = with_method({}, "alchemy");
    other.filter = Filter::geometry;
    expect_linked(other, {});
    Settings layered = with_method(other, "hemisphere");
    layered.filter = Filter::none;
    layered.own.layers = 2;
    expect_linked(layered, {.moving_objects = true});
    EXPECT_EQ(files_.size(), 5U);
}

}  // namespace gloam::effect::opengl_passes_test
