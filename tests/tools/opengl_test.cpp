// SPDX-License-Identifier: MIT
// OpenGL devices on the command line.
#include <nlohmann/json.hpp>

#include "tools/expect.hpp"

namespace gloam::test {
namespace opengl_test {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

// The names of the OpenGL devices here.
std::vector<std::string> names() {
    const CommandResult result = run_command({"devices", "--json"});
    expect_success(result);
    std::vector<std::string> all;
    for (const json& device : json::parse(result.out)) {
        const std::string name = device.at("name");
        if (!name.starts_with("gl:") && !name.starts_with("es:")) continue;
        EXPECT_TRUE(device.at("index").is_null());
        EXPECT_THAT(device.at("api_version").get<std::string>(), HasSubstr("OpenGL"));
        all.push_back(name);
    }
    return all;
}

class OpenGlCommands : public testing::Test {
  protected:
    void SetUp() override {
        if (names_.empty()) GTEST_SKIP() << "no OpenGL device here";
    }
    const std::vector<std::string> names_ = names();
};

TEST_F(OpenGlCommands, EveryListedDeviceRunsChecks) {
    const CommandResult result =
        run_command({"check", "HALTON-2D", "BUILTIN-sin", "--inputs", "256", "--device", "gl"});
    EXPECT_EQ(result.status, 0) << result.err;
    for (const std::string& name : names_) EXPECT_THAT(result.out, HasSubstr("device: " + name + " ("));
    EXPECT_THAT(result.out, HasSubstr(std::to_string(2 * names_.size()) + " checks, 0 failed"));
    EXPECT_THAT(result.out, HasSubstr("not judged"));
}

TEST_F(OpenGlCommands, TheListIsAlsoForPeople) {
    const CommandResult result = run_command({"devices"});
    expect_success(result);
    for (const std::string& name : names_) EXPECT_THAT(result.out, HasSubstr("\n" + name + ": OpenGL "));
}

TEST_F(OpenGlCommands, ResultsSayWhichInterfaceItWas) {
    const TemporaryDirectory folder;
    const std::string file = (folder.path() / "results.json").string();
    expect_success(run_command({"check", "HALTON-2D", "--inputs", "64", "--device", names_.front(), "--json",
                                file, "--variant", "all"}));
    const CommandResult result = run_command({"report", file});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr(names_.front()));
    EXPECT_THAT(result.out, HasSubstr("1 checks, 0 failed"));
}

TEST_F(OpenGlCommands, OtherVariantsAndUnknownNamesAreRefusedInOneLine) {
    const std::string name = names_.front();
    expect_could_not_run(run_command({"check", "HALTON-2D", "--device", name, "--variant", "strict"}),
                         "OpenGL devices have the variant shipped only, not strict");
    expect_could_not_run(run_command({"check", "HALTON-2D", "--device", "gl:nonsense-1.0"}),
                         "no OpenGL device \"gl:nonsense-1.0\"");
    expect_could_not_run(run_command({"check", "HALTON-2D", "--device", name, "--validation"}),
                         "validation layers are of Vulkan");
}

}  // namespace opengl_test
}  // namespace gloam::test
