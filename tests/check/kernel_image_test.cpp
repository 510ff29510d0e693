// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/lab.hpp"

namespace gloam::check {
namespace kernel_image_test {

using testing::HasSubstr;
using testing::ThrowsMessage;

class KernelImageTest : public testing::Test {
  protected:
    Lab lab = test::make_lab(FIXTURES);
    Kernel<float(glm::ivec2)> plus{lab, "images.glsl", "plus"};

    static ImageSet images(glm::ivec2 size, Border border) {
        return {{"fetch_depth", make_image<float>(
                                    size, [](glm::ivec2 p) { return float(p.x + 10 * p.y); }, border)},
                {"fetch_normal",
                 make_image<glm::vec3>(size, [](glm::ivec2 p) { return glm::vec3(9, 9, p.x + 1); }, border)}};
    }

    static std::vector<std::tuple<glm::ivec2>> pixels(glm::ivec2 size) {
        std::vector<std::tuple<glm::ivec2>> all;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) all.emplace_back(glm::ivec2(x, y));
        }
        return all;
    }
};

TEST_F(KernelImageTest, ServesPrototypesFromImagesOfAnySize) {
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(3, 3), glm::ivec2(7, 2), glm::ivec2(1, 5)}) {
        const ImageSet set = images(size, Border::clamp);
        const auto inputs = pixels(size);
        const std::vector<float> sums = plus(inputs, set);
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const glm::ivec2 p = std::get<0>(inputs[i]);
            float want = 0.0F;
            for (const glm::ivec2 offset :
                 {glm::ivec2(0), glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
                want += set.at("fetch_depth").at<float>(p + offset);
            }
            EXPECT_EQ(sums[i], want * float(p.x + 1));
        }
    }
}

TEST_F(KernelImageTest, ReadOutsideIsAFaultThatNamesImageAndPixel) {
    const ImageSet set = images({3, 3}, Border::fault);
    EXPECT_NO_THROW((void)plus.with_images(set, {glm::ivec2(1, 1)}));
    EXPECT_THAT([&] { (void)plus.with_images(set, {glm::ivec2(0, 1)}); },
                ThrowsMessage<std::runtime_error>(
                    HasSubstr("fetch_depth: pixel (-1, 1) is outside the 3 x 3 image")));
}

TEST_F(KernelImageTest, MissingOrWrongImageIsNamed) {
    ImageSet set = images({3, 3}, Border::clamp);
    set.erase("fetch_normal");
    EXPECT_THAT([&] { (void)plus.with_images(set, {glm::ivec2(1, 1)}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("fetch_normal")));
    set["fetch_normal"] = make_image<float>({3, 3}, [](glm::ivec2) { return 1.0F; });
    EXPECT_THAT([&] { (void)plus.with_images(set, {glm::ivec2(1, 1)}); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("vec3")));
}

TEST_F(KernelImageTest, EmptyImageIsRefused) {
    EXPECT_THROW((void)make_image<float>({0, 3}, [](glm::ivec2) { return 1.0F; }), std::invalid_argument);
}

TEST_F(KernelImageTest, StoresReachTheImage) {
    const Kernel<float(glm::ivec2, glm::ivec2)> store(lab, "stores.glsl", "store_at");
    const ImageSet set{
        {"store_value", make_image<glm::vec2>({4, 3}, [](glm::ivec2) { return glm::vec2(-1); })}};
    std::vector<std::tuple<glm::ivec2, glm::ivec2>> inputs;
    for (const auto& [pixel] : pixels({3, 3})) inputs.emplace_back(pixel, glm::ivec2(1, 0));
    ImageSet stored;
    (void)store(inputs, set, stored);
    const Image& image = stored.at("store_value");
    EXPECT_EQ(image.at<glm::vec2>({3, 2}), glm::vec2(2, 2));
    EXPECT_EQ(image.at<glm::vec2>({0, 1}), glm::vec2(-1));
}

TEST_F(KernelImageTest, StoreOutsideIsAFaultAndChangesNothing) {
    const Kernel<float(glm::ivec2, glm::ivec2)> store(lab, "stores.glsl", "store_at");
    const ImageSet set{
        {"store_value", make_image<glm::vec2>({2, 2}, [](glm::ivec2) { return glm::vec2(-1); })}};
    EXPECT_THAT(
        [&] { (void)store.with_images(set, {glm::ivec2(1, 1), glm::ivec2(1, 0)}); },
        ThrowsMessage<std::runtime_error>(HasSubstr("store_value: pixel (2, 1) is outside the 2 x 2 image")));
    std::vector<Word> words;
    append_words(glm::ivec2(1, 1), words);
    append_words(glm::ivec2(0, 1), words);
    const KernelCore::Result result = store.core().run(words, 1, set);
    EXPECT_TRUE(result.fault.has_value());
    EXPECT_EQ(result.stored.at("store_value").words, set.at("store_value").words);
}

}  // namespace kernel_image_test
}  // namespace gloam::check
