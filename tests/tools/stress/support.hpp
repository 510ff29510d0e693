// SPDX-License-Identifier: MIT
#pragma once

#include "effect/method_functions.hpp"
#include "stress/run.hpp"
#include "support/lab.hpp"

namespace gloam::stress::test {

// A brief run on the default device with validation, its shaders from `glsl`.
class Bench {
  public:
    explicit Bench(const std::filesystem::path& glsl = GLOAM_GLSL_DIR)
        : lab_(options(glsl, methods_.folder())), passes_(glsl, gloam::test::cache_directory()) {}

    // With one method only: enough where what is broken is none of a method's own.
    [[nodiscard]] Context context(const std::string& method = "hemisphere") const {
        return {.lab = lab_,
                .passes = passes_,
                .scope = {.brief = true, .frames = 20'000},
                .methods = {effect::method_named(method)}};
    }

  private:
    static subject::LabOptions options(const std::filesystem::path& glsl,
                                       const std::filesystem::path& methods) {
        subject::LabOptions all = gloam::test::make_lab().options();
        all.include_roots = {glsl, GLOAM_STRESS_SHADERS, methods};
        return all;
    }

    effect::MethodFunctions methods_;
    subject::Lab lab_;
    scene::PassLibrary passes_;
};

// What a run finds.
using Rows = std::vector<Row>;
template <class Run>
Rows rows_of(const Run& run, Context context) {
    Rows rows;
    context.found = [&](const Row& row) { rows.push_back(row); };
    run(context);
    return rows;
}

// Tests of each method by its name, or of each equation by its number, so that after a change of one
// `tools/test-readers` runs its own. A suite shares a run.
template <class Parameter>
class OfEach : public testing::TestWithParam<Parameter> {
  protected:
    static void SetUpTestSuite() { bench.emplace(); }
    static void TearDownTestSuite() { bench.reset(); }

    inline static std::optional<Bench> bench;
};

inline void expect_all_passed(const Rows& rows) {
    EXPECT_FALSE(rows.empty());
    for (const Row& row : rows)
        EXPECT_TRUE(row.passed()) << row.varied << ": " << row.quantity << " " << row.measured;
}

// The rows of that quantity whose `varied` holds a text.
inline Rows rows_with(const Rows& rows, const std::string& quantity, const std::string& varied = "") {
    Rows found;
    std::ranges::copy_if(rows, std::back_inserter(found), [&](const Row& row) {
        return row.quantity == quantity && row.varied.find(varied) != std::string::npos;
    });
    return found;
}

}  // namespace gloam::stress::test
