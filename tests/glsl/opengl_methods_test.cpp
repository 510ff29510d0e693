// SPDX-License-Identifier: MIT
// Every method as a fragment shader of OpenGL ES 3.0: the results are those of Vulkan.
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "support/method_names.hpp"
#include "wavy_view.hpp"

namespace gloam {
namespace opengl_methods_test {

using test::Gather;
namespace view = test::wavy_view;

class OpenGlMethods : public testing::TestWithParam<std::string> {
  protected:
    test::MethodFunctions functions;
};

TEST_P(OpenGlMethods, GiveTheResultsOfVulkan) {
    const std::string& method = GetParam();
    std::optional<check::Lab> opengl;
    try {
        opengl.emplace(check::LabOptions{.device = "es:llvmpipe-3.0",
                                         .include_roots = {functions.folder(), GLOAM_GLSL_DIR},
                                         .cache_directory = test::cache_directory()});
    } catch (const gl::Unavailable& error) {
        GTEST_SKIP() << error.what();
    }
    const check::Lab vulkan = functions.lab();
    const std::string file = test::MethodFunctions::file(method);
    const view::Inputs points = view::points();
    const check::ImageSet images = view::images(test::packed_method(functions, file));
    view::expect_alike(check::Kernel<Gather>(*opengl, file, effect::method_function)(points, images),
                       check::Kernel<Gather>(vulkan, file, effect::method_function)(points, images));
}

INSTANTIATE_TEST_SUITE_P(All, OpenGlMethods, testing::ValuesIn(test::method_names()), test::parameter_name);

}  // namespace opengl_methods_test
}  // namespace gloam
