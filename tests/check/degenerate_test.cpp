// SPDX-License-Identifier: MIT
#include "check/degenerate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "check/domain.hpp"
#include "check/image_ends.hpp"

namespace gloam::check {
namespace degenerate_test {

using glm::vec3;

struct Ball {
    float radius;
    vec3 center;
};

vec3 vector_at(std::span<const Word> row, std::size_t first) {
    return {from_word<float>(row[first]), from_word<float>(row[first + 1]), from_word<float>(row[first + 2])};
}

bool on_axis(vec3 v) {
    return (v.x == 0.0F ? 1 : 0) + (v.y == 0.0F ? 1 : 0) + (v.z == 0.0F ? 1 : 0) == 2;
}

Domain::Inputs two_vectors(const Values& a, const Values& b) {
    return Domain{a, b}.and_degenerate(SignatureOf<float(vec3, vec3)>::describe()).draw(8'000, 1);
}

TEST(Degenerate, VectorsAreEqualOppositeParallelAndAlongAnAxis) {
    const Domain::Inputs inputs = two_vectors(vector(3, uniform(-4, 4)), vector(3, uniform(-4, 4)));
    std::map<std::string, int> seen;
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        const vec3 a = vector_at(inputs.row(i), 0);
        const vec3 b = vector_at(inputs.row(i), 3);
        if (a == b) ++seen["equal"];
        if (a == -b) ++seen["opposite"];
        const float lengths = glm::length(a) * glm::length(b);
        if (a != b && a != -b && std::abs(glm::dot(a, b)) > 0.999999F * lengths) ++seen["parallel"];
        if (on_axis(a) || on_axis(b)) ++seen["axis"];
        for (int k = 0; k < 3; ++k) ASSERT_LE(std::max(std::abs(a[k]), std::abs(b[k])), 4.0F);
    }
    for (const char* kind : {"equal", "opposite", "parallel", "axis"}) EXPECT_GT(seen[kind], 40) << kind;
}

TEST(Degenerate, AVectorKeepsToItsValues) {
    const Domain::Inputs inputs = two_vectors(unit_vector(3), vector_of_length(3, uniform(2, 3)));
    int parallel = 0;
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        const vec3 unit = vector_at(inputs.row(i), 0);
        const vec3 long_one = vector_at(inputs.row(i), 3);
        ASSERT_NEAR(glm::length(unit), 1.0, 1e-6);
        ASSERT_NEAR(glm::length(long_one), 2.5, 0.500001);
        if (std::abs(glm::dot(unit, long_one)) > 0.9999999F * glm::length(long_one)) ++parallel;
    }
    EXPECT_GT(parallel, 100);
}

TEST(Degenerate, EveryNumberOfAStructIsBadOnceAlone) {
    const Domain domain{vector({uniform(1, 2), uniform(1, 2), uniform(1, 2), uniform(1, 2)})};
    const Domain::Inputs inputs = domain.and_degenerate(SignatureOf<float(Ball)>::describe()).draw(4'000, 1);
    std::map<std::pair<std::size_t, std::string>, int> seen;
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        int bad = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const auto value = from_word<float>(inputs.row(i)[k]);
            if (value >= 1.0F && value <= 2.0F) continue;
            ++bad;
            const char* const kind = std::isnan(value)   ? "NaN"
                                     : value == 0.0F     ? "zero"
                                     : std::isinf(value) ? "infinite"
                                                         : "negative";
            ++seen[{k, kind}];
        }
        ASSERT_LE(bad, 1);
    }
    EXPECT_EQ(seen.size(), 16U);
}

TEST(Degenerate, SidesOfImagesAreZeroAndOneAndStayWhereTheyMust) {
    const auto seen = [](const Values& size) {
        const Domain::Inputs inputs =
            Domain{size}.and_degenerate(SignatureOf<float(glm::ivec2)>::describe()).draw(1'000, 1, {9, 7});
        std::set<std::pair<Word, Word>> sizes;
        for (std::size_t i = 0; i < inputs.count(); ++i) sizes.insert({inputs.row(i)[0], inputs.row(i)[1]});
        return sizes;
    };
    EXPECT_EQ(seen(image_size()), (std::set<std::pair<Word, Word>>{{9, 7}, {0, 7}, {1, 7}, {9, 0}, {9, 1}}));
    EXPECT_EQ(seen(image_size().only_as_drawn()), (std::set<std::pair<Word, Word>>{{9, 7}}));
}

TEST(Degenerate, OneWordOfAStructMayBeASize) {
    const Values camera = vector({uniform(1, 2), image_size(), booleans()});
    EXPECT_EQ(camera.image_sizes, std::vector<std::size_t>{1});
}

TEST(Degenerate, FewInputsHoldSomeOfEveryKind) {
    const Domain domain = Domain{uniform(-1, 1).and_special()};
    const Domain::Inputs inputs = domain.draw(16, 3);
    int drawn = 0;
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        const auto value = std::abs(from_word<float>(inputs.row(i)[0]));
        if (value > 0x1p-20F && value < 0.9999F) ++drawn;
    }
    EXPECT_GE(drawn, 4);
    EXPECT_EQ(inputs.count(), 16U);
}

TEST(Domain, BothSidesOfZeroAreThereWhereARangeHoldsIt) {
    const auto words = [](double low, double high) {
        const Domain::Inputs inputs = Domain{uniform(low, high)}.draw(100, 1);
        return std::set<Word>(inputs.words.begin(), inputs.words.end());
    };
    constexpr float least = std::numeric_limits<float>::denorm_min();
    for (const float side : {0.0F, -0.0F, least, -least, 0x1p-126F, -0x1p-126F}) {
        EXPECT_TRUE(words(-1, 1).contains(to_word(side))) << side;
        EXPECT_EQ(words(0, 1).contains(to_word(side)), side >= 0.0F) << side;
        EXPECT_FALSE(words(0.5, 1).contains(to_word(side))) << side;
    }
}

TEST(ImageEnds, ImagesHoldExactlyZeroAndOne) {
    const auto make = [](glm::ivec2 size, numeric::Random&) {
        return ImageSet{
            {"depth", make_image<float>(size, [](glm::ivec2 p) { return p.x == 0 ? INFINITY : 2.0F; })},
            {"normal", make_image<vec3>(size, [](glm::ivec2) { return vec3(0.6F, 0, 0.8F); })},
            {"mask", make_image<unsigned>(size, [](glm::ivec2) { return 5U; })}};
    };
    const auto scenarios = with_exact_ends(
        {{.name = "small", .size = {2, 2}, .make = make}, {.name = "large", .size = {40, 30}, .make = make}});
    ASSERT_EQ(scenarios.size(), 5U);
    numeric::Random random(1);
    for (std::size_t i = 2; i < 5; ++i) {
        const ImageSet images = scenarios[i].make(scenarios[i].size, random);
        std::set<float> depths;
        for (const Word word : images.at("depth").words) depths.insert(from_word<float>(word));
        EXPECT_EQ(depths, (std::vector<std::set<float>>{{0}, {1}, {0, 1, 2, INFINITY}})[i - 2]);
        for (int x = 0; x < 40; ++x) {
            const auto normal = images.at("normal").at<vec3>({x, 3});
            EXPECT_TRUE(normal == vec3(0) || std::abs(glm::length(normal) - 1.0F) < 1e-6F);
            EXPECT_EQ(images.at("mask").at<unsigned>({x, 3}), 5U);
        }
    }
    EXPECT_TRUE(with_exact_ends({}).empty());
}

}  // namespace degenerate_test
}  // namespace gloam::check
