// SPDX-License-Identifier: MIT
#include "module/include.hpp"
#include "module/support.hpp"

namespace gloam::module::cache_test {

const source::Source source = kernel("#include \"math/hypot.glsl\"", "fx_hypot(3.0, 4.0)");

std::size_t files_in(const std::filesystem::path& directory) {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(directory), std::filesystem::directory_iterator()));
}

// With the members of their results.
std::vector<std::string> texts_of(const std::vector<Function>& functions) {
    std::vector<std::string> texts = prototypes(functions);
    for (const Function& function : functions) texts.push_back(to_glsl(function.result));
    return texts;
}

using SpirvCacheTest = InFolder;

// tests/backend/vulkan/cache_test.cpp damages files in every way.
TEST_F(SpirvCacheTest, ReadsTheEntryInsteadOfCompiling) {
    const auto lib = folder.write("lib.glsl", "float f() { return 1.0; }\n");
    const source::Source user = kernel("#include \"lib.glsl\"", "f()");
    const CompileOptions options{.include_roots = {folder.path()}};
    const SpirvCache cache(folder.path() / "cache");
    const Spirv stored = cache.compile(user, options);
    const auto entry = std::filesystem::directory_iterator(folder.path() / "cache")->path();
    const auto written = std::filesystem::last_write_time(entry);
    std::filesystem::last_write_time(entry, written - std::chrono::hours(1));
    EXPECT_EQ(cache.compile(user, options), stored);
    folder.write("moved/lib.glsl", "float f() { return 1.0; }\n");
    EXPECT_EQ(cache.compile(user, {.include_roots = {folder.path() / "moved"}}), stored);
    EXPECT_EQ(files_in(folder.path() / "cache"), 1u) << "where an include lies changes no module";
    EXPECT_EQ(std::filesystem::last_write_time(entry), written - std::chrono::hours(1))
        << "the entry was written again";
}

TEST_F(SpirvCacheTest, FunctionsSurviveTheRoundTrip) {
    const SpirvCache cache(folder.path());
    for (const char* name : {"types.glsl", "fetch.glsl"}) {
        const source::Source text{"text",
                                  "#version 450\n#include \"" + std::string(name) +
                                      "\"\nfloat f(float a[2], out double d) { d = 1.0LF; return a[0]; }\n"};
        const auto expected = texts_of(functions(text, with_fixtures()));
        EXPECT_EQ(texts_of(cache.functions(text, with_fixtures())), expected);
        EXPECT_EQ(texts_of(cache.functions(text, with_fixtures())), expected);
    }
    EXPECT_EQ(files_in(folder.path()), 2u);
}

TEST_F(SpirvCacheTest, KeepsApartWhateverDiffers) {
    const SpirvCache cache(folder.path());
    std::vector<std::pair<source::Source, CompileOptions>> all{
        {source, with_fixtures()},
        {source, with_fixtures(Optimization::performance)},
        {source, with_fixtures(Optimization::size)},
        {{"other", source.text}, with_fixtures()},
        {{source.name, source.text + " "}, with_fixtures()}};
    for (const char* name : {"strict", "relaxed"}) {
        all.emplace_back(source, with_fixtures());
        all.back().second.variant = variant(name);
    }
    const source::Source any_stage{"any", "#version 450\nvoid main() {}\n"};
    for (const source::Stage stage : {source::Stage::compute, source::Stage::vertex, source::Stage::fragment})
        all.emplace_back(any_stage, CompileOptions{.stage = stage});
    for (int again = 0; again < 2; ++again)
        for (const auto& [text, options] : all)
            EXPECT_EQ(cache.compile(text, options), compile(text, options));
    EXPECT_EQ(files_in(folder.path()), all.size());
    for (const auto& [text, options] : {all.front(), all[5]}) (void)cache.functions(text, options);
    EXPECT_EQ(files_in(folder.path()), all.size() + 1) << "functions are those of every variant";
}

// A file that has changed, one in an earlier root that hides it, and one beside the source.
TEST_F(SpirvCacheTest, AnotherIncludeIsCompiledAgain) {
    const SpirvCache cache(folder.path() / "cache");
    const CompileOptions options{.include_roots = {folder.path() / "first", folder.path() / "second"}};
    source::Source user = kernel("#include \"outer.glsl\"", "f()");
    user.name = (folder.path() / "home" / "user.comp").string();
    folder.write("second/outer.glsl", "#include \"inner.glsl\"\n");
    folder.write("second/inner.glsl", "float f() { return 1.0; }\n");
    const Spirv first = cache.compile(user, options);
    Spirv before = first;
    for (const auto& [name, value] :
         {std::pair{"second/inner.glsl", "2.0"}, {"first/outer.glsl", "3.0"}, {"home/outer.glsl", "4.0"}}) {
        folder.write(name, std::string("float f() { return ") + value + "; }\n");
        EXPECT_NE(cache.compile(user, options), before) << name;
        before = compile(user, options);
        EXPECT_EQ(cache.compile(user, options), before) << name;
    }
    for (const char* name : {"first", "home"}) std::filesystem::remove_all(folder.path() / name);
    folder.write("second/inner.glsl", "float f() { return 1.0; }\n");
    EXPECT_EQ(cache.compile(user, options), first);
    folder.write("second/inner.glsl", "float f() { return x; }\n");
    EXPECT_THROW(static_cast<void>(cache.compile(user, options)), source::CompileError);
}

}  // namespace gloam::module::cache_test
