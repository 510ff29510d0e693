// SPDX-License-Identifier: MIT
// Functions that need other invocations: derivatives and discard in quads; shared memory, barriers and subgroups.
#include "check/function.hpp"
#include "check/own_function.hpp"
#include "check/run.hpp"
#include "shader/include.hpp"
#include "support/lab.hpp"

#include "support/matchers.hpp"

namespace gloam::check::team_test {

Lab lab_of(const std::string& device = {}) {
    return Lab({.device = device, .validation = device.empty(), .include_roots = {FIXTURES}});
}

TEST(Quads, EveryInputIsOneQuad) {
    const Lab lab = lab_of();
    const Function<Quad<float>(Quad<float>)> width(lab, "quads_cpp.glsl", "edge_width");
    std::vector<std::tuple<Quad<float>>> inputs;
    for (int i = 0; i < 300'000; ++i) {
        const auto x = static_cast<float>(i);
        inputs.emplace_back(Quad<float>{{x, x + 1.0F, x + 2.0F, x + 3.0F}});
    }
    const std::vector<Quad<float>> all = width(inputs);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i] != Quad<float>{{3, 3, 3, 3}}) { printf("%zu: %g %g %g %g\n", i, all[i][0], all[i][1], all[i][2], all[i][3]); if (i > 5000) break; }
}

}  // namespace gloam::check::team_test
