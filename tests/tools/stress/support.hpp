// SPDX-License-Identifier: MIT
#pragma once

#include "effect/method_functions.hpp"
#include "stress/run.hpp"
#include "support/lab.hpp"

namespace gloam::stress::test {

// A brief run on the default device with validation, its shaders from `glsl`.
class Bench {
  public:
    explicit Bench(const std::filesystem::path& glsl = GLOAM_GLSL_DIR,
                   const std::filesystem::path& stress_shaders = GLOAM_STRESS_SHADERS)
        : lab_(options(glsl, stress_shaders, methods_.folder())),
          passes_(glsl, gloam::test::cache_directory()) {}

    [[nodiscard]] Context context(std::uint64_t frames = 20'000) const {
        return {.lab = lab_, .passes = passes_, .brief = true, .frames = frames};
    }

    // With one method only: enough where what is broken is none of a method's own.
    [[nodiscard]] Context context_of(const std::string& method) const {
        Context one = context();
        one.methods = {effect::method_named(method)};
        return one;
    }

  private:
    static check::LabOptions options(const std::filesystem::path& glsl,
                                     const std::filesystem::path& stress_shaders,
                                     const std::filesystem::path& methods) {
        check::LabOptions all = gloam::test::make_lab().options();
        all.include_roots = {glsl, stress_shaders, methods};
        return all;
    }

    effect::MethodFunctions methods_;
    check::Lab lab_;
    scene::PassLibrary passes_;
};

// Tests of one method, by its name: a suite shares a run. They are instantiated for all methods, so that
// after a change of one method `tools/test-readers` runs its own.
class EachMethod : public testing::TestWithParam<std::string> {
  protected:
    static void SetUpTestSuite() { bench_.emplace(); }
    static void TearDownTestSuite() { bench_.reset(); }

    [[nodiscard]] static const Bench& bench() { return *bench_; }
    [[nodiscard]] static Context context() { return bench_->context_of(GetParam()); }

  private:
    inline static std::optional<Bench> bench_;
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

// That one row.
inline Row row_of(const Rows& rows, const std::string& quantity, const std::string& varied = "") {
    const Rows found = rows_with(rows, quantity, varied);
    EXPECT_EQ(found.size(), 1U) << quantity << ", " << varied;
    return found.empty() ? Row{} : found.front();
}

}  // namespace gloam::stress::test
