// SPDX-License-Identifier: MIT
#include "subject/domain.hpp"
#include "judge/reproduction.hpp"
#include "numeric/numbers.hpp"
#include "support/lab.hpp"

namespace gloam::subject::domain_test {

using namespace judge;

using glm::vec3;

std::set<Word> words_of(const Values& values, std::size_t count) {
    const Domain::Inputs inputs = Domain{values}.draw(count, 1);
    return {inputs.words.begin(), inputs.words.end()};
}

std::set<float> floats_of(const Values& values, std::size_t count) {
    std::set<float> floats;
    for (const Word word : words_of(values, count)) floats.insert(from_word<float>(word));
    return floats;
}

TEST(Domain, RangesAreKeptAndTheirEndsIncluded) {
    const std::set<float> values = floats_of(uniform(-2, 3), 10'000);
    EXPECT_EQ(*values.begin(), -2.0F);
    EXPECT_EQ(*values.rbegin(), 3.0F);
    std::set<int> whole;
    for (const Word word : words_of(integers(-3, 3), 1'000)) whole.insert(from_word<int>(word));
    EXPECT_THAT(whole, ElementsAre(-3, -2, -1, 0, 1, 2, 3));
}

TEST(Domain, LogUniformReachesEveryDecade) {
    const std::set<float> values = floats_of(log_uniform(1e-6, 1e6), 10'000);
    EXPECT_EQ(*values.begin(), 1e-6F);
    EXPECT_EQ(*values.rbegin(), 1e6F);
    std::set<int> decades;
    for (const float value : values) decades.insert(static_cast<int>(std::floor(std::log10(value))));
    EXPECT_GE(decades.size(), 12U);
}

TEST(Domain, EverySpecialValueIsThere) {
    const std::set<Word> words = words_of(uniform(0, 1).and_special(), 200);
    for (const double special : numeric::special_values(numeric::float32))
        EXPECT_TRUE(words.contains(to_word(static_cast<float>(special)))) << special;
}

TEST(Domain, BranchPointsComeWithTheirNeighbours) {
    const auto inputs = Domain{uniform(0, 1).and_near({0.25})}.draw(100, 1);
    std::set<float> at_branch;
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        if (inputs.branch[i]) at_branch.insert(from_word<float>(inputs.row(i)[0]));
    }
    EXPECT_EQ(at_branch, (std::set<float>{std::nextafter(0.25F, 0.0F), 0.25F, std::nextafter(0.25F, 1.0F)}));
}

TEST(Domain, NumbersAndTheirNeighboursAreTriedWhereValuesAdmitThem) {
    const Signature signature = SignatureOf<float(glm::vec3, glm::vec3, float, float)>::describe();
    const Domain domain{vector(3, uniform(-1, 1)), unit_vector(3), uniform(0.5, 4).only_as_drawn(),
                        made_by<float>([](numeric::Random&) { return 2.0F; })};
    const std::array numbers{0.25F, 3.0F};
    const auto inputs = domain.and_numbers(signature, numbers).draw(800, 1);
    std::array<std::set<float>, 8> seen;
    for (std::size_t i = 0; i < inputs.count(); ++i)
        for (std::size_t k = 0; k < seen.size(); ++k) seen[k].insert(from_word<float>(inputs.row(i)[k]));
    for (std::size_t k = 0; k < 3; ++k) {
        for (const float number : {-0.25F, 0.25F})
            for (const int step : {-1, 0, 1}) EXPECT_TRUE(seen[k].contains(numeric::step(number, step))) << k;
        EXPECT_LE(*seen[k].rbegin(), 1.0F);
        EXPECT_FALSE(seen[k + 3].contains(0.25F)) << "not a unit vector any more";
    }
    EXPECT_FALSE(seen[6].contains(3.0F)) << "only as drawn";
    EXPECT_EQ(seen[7], std::set<float>{2.0F}) << "nothing says what else it may be";
}

TEST(Domain, TiesPlaceOneParameterBesideAnother) {
    const auto inputs = Domain{uniform(0, 1), uniform(1, 2)}.tied(0, 1, 0.5).draw(4'000, 1);
    std::size_t tied = 0;
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        if (!inputs.branch[i]) continue;
        ++tied;
        const float half = 0.5F * from_word<float>(inputs.row(i)[1]);
        EXPECT_LE(std::abs(from_word<float>(inputs.row(i)[0]) - half), 0x1p-23F);
    }
    EXPECT_GT(tied, 100U);
}

TEST(Domain, UnitVectorsHaveLengthOneAndCoverTheSphere) {
    for (const int size : {3, 4}) {
        const auto inputs = Domain{unit_vector(size)}.draw(20'000, 1);
        const auto count = static_cast<double>(inputs.count());
        glm::dvec4 sum(0);
        glm::dvec4 squares(0);
        for (std::size_t i = 0; i < inputs.count(); ++i) {
            glm::dvec4 v(0);
            for (int k = 0; k < size; ++k)
                v[k] = from_word<float>(inputs.row(i)[static_cast<std::size_t>(k)]);
            ASSERT_NEAR(glm::length(v), 1.0, 1e-7);
            sum += v;
            squares += v * v;
        }
        EXPECT_LT(glm::length(sum) / count, 0.03);
        for (int k = 0; k < size; ++k) EXPECT_NEAR(squares[k] / count, 1.0 / size, 0.02);
    }
}

TEST(Domain, SeedsDecideEverything) {
    const Domain domain{uniform(0, 1).and_special(), vector(3, signed_log_uniform(1e-3, 1e3))};
    EXPECT_EQ(domain.draw(1'000, 5).words, domain.draw(1'000, 5).words);
    EXPECT_NE(domain.draw(1'000, 5).words, domain.draw(1'000, 6).words);
}

TEST(Domain, NonsenseIsRefused) {
    expect_error<std::invalid_argument>([] { (void)uniform(1, 0); }, {"these are 1 and 0"});
    EXPECT_THROW((void)log_uniform(0, 1), std::invalid_argument);
    EXPECT_THROW((void)unit_vector(5), std::invalid_argument);
    EXPECT_THROW((void)Domain{uniform(0, 1)}.tied(0, 1), std::invalid_argument);
}

TEST(Domain, AnAdjustedDomainKeepsAGivenInputAsItIs) {
    const Domain domain =
        Domain{uniform(0, 1)}.adjusted([](std::span<Word> row) { row[0] = 0U; }).and_words({to_word(0.5F)});
    const Domain::Inputs inputs = domain.draw(3, 1);
    EXPECT_EQ(from_word<float>(inputs.row(0)[0]), 0.5F);
    EXPECT_EQ(inputs.row(1)[0], 0U);
    EXPECT_EQ(domain.draw(1, 1).count(), 1U);
    EXPECT_THAT(Domain{image_size()}.and_words({1U, 1U}).draw(1, 1, {9, 7}).words, ElementsAre(9U, 7U));
}

TEST(Values, AdmitNothingElse) {
    const auto admits = [](const Values& values, auto... scalars) {
        const std::vector<Word> words{to_word(scalars)...};
        return values.admits(words);
    };
    EXPECT_FALSE(admits(uniform(0, 1), 1.0000001F));
    EXPECT_FALSE(admits(uniform(0, 1), nan));
    EXPECT_FALSE(admits(integers(-3, 70), 71));
    EXPECT_FALSE(admits(integers(-3, 70), -4));
    EXPECT_FALSE(admits(unit_vector(2), 0.8F, 0.61F));
    EXPECT_FALSE(admits(vector(2, uniform(0, 1)), 0.5F, -0.5F));
    EXPECT_FALSE(admits(either(uniform(0, 1), uniform(4, 5)), 3.0F));
    EXPECT_TRUE(admits(uniform(0, 1).and_near({2.0}), 2.0F));
    EXPECT_FALSE(admits(made_by<float>([](numeric::Random&) { return 1.0F; }), 1.0F)) << "nobody can tell";
}

// Inputs that are degenerate, and images at the ends of their ranges.

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

Domain::Inputs two_vectors(const Values& a, const Values& b, bool only_vectors = false) {
    return Domain{a, b}
        .and_degenerate(SignatureOf<float(vec3, vec3)>::describe(), only_vectors)
        .draw(8'000, 1);
}

TEST(Degenerate, VectorsAreEqualOppositeParallelAndAlongAnAxis) {
    for (const bool only_vectors : {false, true}) {
        const Domain::Inputs inputs =
            two_vectors(vector(3, uniform(-4, 4)), vector(3, uniform(-4, 4)), only_vectors);
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

TEST(Degenerate, FewInputsHoldSomeOfEveryKind) {
    const Domain::Inputs inputs = Domain{uniform(-1, 1).and_special()}.draw(16, 3);
    EXPECT_GE(std::ranges::count_if(inputs.words,
                                    [](Word word) {
                                        const float value = std::abs(from_word<float>(word));
                                        return value > 0x1p-20F && value < 0.9999F;
                                    }),
              4);
    EXPECT_EQ(inputs.count(), 16U);
}

TEST(Domain, BothSidesOfZeroAreThereWhereARangeHoldsIt) {
    const auto words = [](double low, double high) { return words_of(uniform(low, high), 100); };
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

// A function that should return its first word; where `fails` is true it returns another one.
template <class Type>
struct Planted {
    Domain domain;
    std::function<bool(std::span<const Word>)> fails;
    mutable std::size_t evaluations = 0;

    [[nodiscard]] Sample shrunk(std::size_t index, std::span<const Word> failing) const {
        const auto first_failing = [&](std::span<const std::vector<Word>> inputs) -> std::optional<Sample> {
            ++evaluations;
            const auto found = std::ranges::find_if(inputs, [&](const auto& row) { return fails(row); });
            if (found == inputs.end()) return std::nullopt;
            return Sample{.inputs = *found, .got = {~found->front()}};
        };
        return shrink({.signature = SignatureOf<Type>::describe(), .domain = domain},
                      {.index = index, .inputs = {failing.begin(), failing.end()}}, first_failing);
    }

    // Shrinks every failing input of a draw; each must still fail, and lie in the domain.
    void expect_shrinks_to(const std::vector<Word>& smallest) const {
        const Domain::Inputs inputs = domain.draw(2000, 1);
        std::size_t seen = 0;
        for (std::size_t i = 0; i < inputs.count() && seen < 20; ++i) {
            const auto row = inputs.row(i);
            if (!fails(row)) continue;
            const Sample found = shrunk(i, row);
            EXPECT_EQ(found.inputs, smallest) << "from input " << i;
            EXPECT_EQ(found.index, i);
            EXPECT_TRUE(fails(found.inputs));
            EXPECT_TRUE(domain.holds(found.inputs, row));
            EXPECT_EQ(found.got, std::vector<Word>{~found.inputs[0]});
            ++seen;
        }
        EXPECT_EQ(seen, 20U);
    }
};

TEST(Shrink, ANumberGoesToTheRoundestOneThatFails) {
    using Fails = std::function<bool(std::span<const Word>)>;
    const Fails always = [](auto) { return true; };
    const auto beyond = [](float limit) {
        return Fails([=](auto in) { return (from_word<float>(in[0]) > limit) == (limit > 0.0F); });
    };
    const auto shrinks = [](const Values& values, const Fails& fails, Word smallest) {
        Planted<unsigned(float)>{.domain = {values}, .fails = fails}.expect_shrinks_to({smallest});
    };
    shrinks(any_float(), always, 0U);
    shrinks(uniform(-1000, 1000), beyond(3.25F), to_word(4.0F));
    shrinks(uniform(-1000, 1000), beyond(-0.1F), to_word(-1.0F));
    shrinks(log_uniform(5, 100), always, to_word(8.0F));
    shrinks(constant(2.75F), always, to_word(2.75F));
    Planted<unsigned(unsigned)>{.domain = {integers(0, 1'000'000)},
                                .fails = [](auto in) { return in[0] >= 1000U; }}
        .expect_shrinks_to({1024U});
    Planted<unsigned(int)>{.domain = {integers(-500, 500)},
                           .fails = [](auto in) { return static_cast<int>(in[0]) <= -3; }}
        .expect_shrinks_to({static_cast<Word>(-3)});
}

TEST(Shrink, WhatDoesNotMatterGoesToZero) {
    Planted<unsigned(glm::vec3, bool, int)>{
        .domain = {vector(3, uniform(-8, 8)), booleans(), integers(-9, 9)},
        .fails = [](auto in) { return from_word<float>(in[1]) >= 1.0F; }}
        .expect_shrinks_to({0U, to_word(1.0F), 0U, 0U, 0U});
}

TEST(Shrink, ValuesThatMustBeEqualShrinkTogether) {
    const Domain equal = Domain({uniform(0, 100), uniform(0, 100)}).adjusted([](std::span<Word> words) {
        words[1] = words[0];
    });
    Planted<unsigned(float, float)>{
        .domain = equal, .fails = [](auto in) { return in[0] == in[1] && from_word<float>(in[0]) > 1.5F; }}
        .expect_shrinks_to({to_word(2.0F), to_word(2.0F)});
}

TEST(Shrink, ManyCandidatesCostOneEvaluation) {
    const Planted<unsigned(glm::vec4)> planted{
        .domain = {vector(4, uniform(-1e6, 1e6))},
        .fails = [](auto in) { return from_word<float>(in[0]) > 100.0F && from_word<float>(in[3]) < -5.0F; }};
    const Sample found = planted.shrunk(
        0, std::vector<Word>{to_word(123456.7F), to_word(-3.3F), to_word(1e-9F), to_word(-98765.4F)});
    EXPECT_EQ(found.inputs, (std::vector<Word>{to_word(128.0F), 0U, 0U, to_word(-8.0F)}));
    EXPECT_LT(planted.evaluations, 40U);
}

}  // namespace gloam::subject::domain_test
