// SPDX-License-Identifier: MIT
// Wrong results of functions of a file, planted behind the back of a device.
#include "backend/sampled.hpp"
#include "subject/fixture_functions.hpp"
#include "support/changed_device.hpp"

#include "support/test.hpp"

namespace gloam::judge::own_planted_test {

using namespace subject;

using module::Scalar;

// What a device makes of its outputs, and of the images before it reads them; then how many inputs are
// outside.
struct Planted {
    const char* file;
    std::vector<const char*> functions;
    std::function<void(std::span<Word>)> outputs;
    std::function<void(std::span<Word> image)> image;
    std::size_t least = 1;
    std::size_t most = SIZE_MAX;
    Ranges ranges = {};
    std::size_t inputs = 512;
};

void expect_noticed(const std::vector<Planted>& rows, const std::shared_ptr<backend::Backend>& device,
                    const std::string& name = {}) {
    for (const Planted& row : rows) {
        test::ChangedDevice::Changes changes{.after = row.outputs};
        if (row.image)
            changes.before = [&row](std::vector<std::vector<Word>>& images) {
                for (std::vector<Word>& words : images) row.image(words);
            };
        LabOptions options = options_of(row.file);
        if (!name.empty()) options.device = name, options.validation = false;
        const Lab lab(options, std::make_shared<test::ChangedDevice>(device, changes));
        for (const char* function : row.functions) {
            const Answer answer = answer_of(lab, row.file, function, row.ranges, row.inputs);
            EXPECT_GE(answer.outside(), row.least) << function << " row " << &row - rows.data();
            EXPECT_LE(answer.outside(), row.most) << function << " row " << &row - rows.data() << answer;
        }
    }
}

TEST(OwnTypes, AWrongElementPixelOrInvocationIsNoticed) {
    using Outputs = std::span<Word>;
    const auto moved = [](std::int64_t steps) {
        return [=](Outputs row) { row[0] = stepped_float(Scalar::float16_, row[0], steps); };
    };
    const auto rotated = [](Outputs row) { std::rotate(row.begin(), row.begin() + 1, row.end()); };
    const Ranges pixels{{"p", {0, 3}}};
    const auto image = [&](const char* function, std::function<void(std::span<Word>)> change,
                           std::size_t outside = 128) {
        return Planted{"own_images.glsl", {function}, std::move(change), {}, outside, outside, pixels, 128};
    };
    const auto halves = [](std::vector<const char*> functions, std::function<void(Outputs)> change,
                           std::size_t least, std::size_t most = SIZE_MAX) {
        return Planted{"numbers.glsl", std::move(functions), std::move(change), {}, least, most, {}, 1024};
    };
    expect_noticed(
        {halves({"half_sum"}, moved(0), 0, 0),  // a rounding is to either neighbour
         halves({"half_sum"}, moved(2), 501),
         halves(
             {"halves_changed", "half_vectors"}, [](Outputs row) { row.back() ^= 0x00100000U; }, 101),
         {"arrays.glsl", {"array_transposed", "array_swapped", "array_split"}, rotated, {}},
         {"uniforms.glsl", {"graded", "shade"}, rotated, {}},
         image("blurred", [](Outputs row) { row[4 * 5 * 4 - 1] ^= 0x100U; }),
         image("filled", [](Outputs row) { std::ranges::swap_ranges(row.first(4), row.last(4)); }),
         image("counted", [](Outputs row) { ++row[1]; }),
         image("pair", [](Outputs row) { row[2] = to_word(3.5F); }),  // a format of two channels
         image(
             "counted", [](Outputs) {}, 0),
         // The first invocation has the result of the one below it; one derivative may be that of either row.
         {"edges.glsl", {"edge_fine"}, [](Outputs row) { std::swap(row[0], row[2]); }, {}},
         {"edges.glsl", {"edge_any"}, [](Outputs row) { std::swap(row[0], row[2]); }, {}, 0, 0}},
        test::SharedDevice::get());
}

using backend::Compare;
using backend::SampledHeader;
using backend::Wrap;

template <class Change>
auto of_header(Change change) {
    return [change](std::span<Word> image) {
        SampledHeader header = backend::sampled_header(image);
        change(header);
        std::ranges::copy(std::bit_cast<std::array<Word, backend::sampled_header_words>>(header),
                          image.begin());
    };
}
const auto other_filter = of_header([](SampledHeader& h) { h.linear = 1 - h.linear; });
const Ranges directions{{"p", {-1, 1}}};

TEST(OwnSamplers, AWrongSamplerIsNoticed) {
    const auto rows_of = [](std::vector<const char*> functions, const Ranges& ranges, std::size_t inputs) {
        return [=](std::function<void(std::span<Word>)> change, std::size_t least = 1,
                   std::size_t most = SIZE_MAX) {
            return Planted{"samplers.glsl", functions, {}, std::move(change), least, most, ranges, inputs};
        };
    };
    const auto sampled = rows_of({"sampled"}, {{"uv", {-1, 2}}}, 512);
    const auto shadow = rows_of({"shadow_at_level"}, {{"p", {0, 1}}}, 1024);
    const auto cube = rows_of({"cube_at_level", "of_cube"}, directions, 1024);
    const auto compares = [](Compare other) {
        return of_header([other](SampledHeader& h) {
            h.compare = h.compare == Compare::less_equal ? other : Compare::less_equal;
        });
    };
    // The faces +x and -x of the largest level.
    const auto exchanged = [](std::span<Word> image) {
        const std::span<Word> texels = image.subspan(backend::sampled_header_words);
        const std::size_t face = texels.size() / backend::cube_faces / 2;
        std::ranges::swap_ranges(texels.first(face), texels.subspan(face, face));
    };
    // A texel at a corner, where three faces meet.
    const auto corner = [](std::span<Word> image) { image[backend::sampled_header_words] = to_word(60.0F); };
    const auto nothing = [](std::span<Word>) {};
    expect_noticed(
        {sampled(other_filter), sampled(of_header([](SampledHeader& h) {
             h.wrap = h.wrap == Wrap::edge ? Wrap::repeat : Wrap::edge;
         })),
         sampled(of_header([](SampledHeader& h) { h.wrap = Wrap::border; })), sampled(nothing, 0, 0),
         shadow(compares(Compare::greater_equal)), shadow(compares(Compare::less)), shadow(other_filter),
         cube(exchanged, 101), cube(corner, 1), cube(nothing, 0, 0)},
        test::SharedDevice::get());
}

// The rules of OpenGL 4.5 are those of Vulkan.
TEST(OwnSamplers, OpenGlReadsTheSameImages) {
    const std::string name = "gl:llvmpipe-4.5";
    std::shared_ptr<backend::Backend> opengl;
    try {
        opengl = std::make_shared<backend::gl::Device>(name);
    } catch (const backend::gl::Unavailable& error) {
        GTEST_SKIP() << error.what();
    }
    LabOptions options = options_of("samplers.glsl");
    options.device = name;
    options.validation = false;
    const Lab lab(options, opengl);
    for (const char* function :
         {"at_level", "graded", "gathered", "cube_at_level", "cube_gathered", "one_of_cubes", "cube_count",
          "shadow_at_level", "shadow_gathered", "sized", "levels"}) {
        const bool of_cube = std::string_view(function).find("cube") != std::string_view::npos;
        const Answer answer = answer_of(lab, "samplers.glsl", function, of_cube ? directions : Ranges{}, 512);
        EXPECT_TRUE(answer.passed()) << function << "\n" << answer;
    }
    EXPECT_THROW((void)answer_of(lab, "samplers.glsl", "sampled"), backend::Unsupported) << "a quad";
    expect_noticed(
        {{"samplers.glsl", {"cube_at_level", "shadow_at_level"}, {}, other_filter, 1, SIZE_MAX, directions}},
        opengl, name);
}

}  // namespace gloam::judge::own_planted_test
