// SPDX-License-Identifier: MIT
// The passes of the effect as one text each in GLSL ES 3.10: Mesa's compiler takes them.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "effect/methods.hpp"
#include "effect/plan.hpp"
#include "effect/presets.hpp"
#include "gl/opened.hpp"
#include "gl/program.hpp"
#include "scene/pass_library.hpp"
#include "shader/language.hpp"

namespace gloam::effect {
namespace es_passes_test {

class EsPasses : public gl::Opened {
  protected:
    void expect_linked(const Settings& settings, const PlanOptions& options) {
        for (const PlannedPass& pass : plan_of(settings, options).passes) {
            std::map<std::uint32_t, std::uint32_t> constants;
            for (const gpu::SpecializationConstant& constant : pass.source.constants)
                constants[constant.id] = constant.bits;
            const std::string text = passes_.text(pass.source.file, pass.source.defines, pass.source.replaced,
                                                  constants, shader::Language::es310);
            if (!seen_.insert(text).second) continue;
            EXPECT_NO_THROW(gl::Program(device(), gl::Program::Stage::compute, {pass.name, text}))
                << settings.method << " " << pass.name;
            files_.insert(pass.source.file);
        }
    }

    scene::PassLibrary passes_{GLOAM_GLSL_DIR};
    std::set<std::string> seen_;
    std::set<std::string> files_;
};

TEST_F(EsPasses, AreTakenByADriver) {
    GLOAM_OPEN_OR_SKIP("es:llvmpipe-3.1");
    for (const char* method : {"hemisphere", "gtao", "mssao", "sao_chain", "separable"}) {
        Settings settings = with_method({}, method);
        settings.remap_b = 2.0F;
        expect_linked(settings, {.moving_objects = true, .tiles = true, .normals = false});
    }
    expect_linked(preset_named("balanced").settings, {});
    Settings halves = with_method({}, "alchemy");
    halves.precision = HistoryPrecision::float16;
    halves.table_size = 2048;
    halves.filter = Filter::geometry;
    expect_linked(halves, {});
    Settings half = halves;
    half.resolution = Resolution::half;
    half.filter = Filter::none;
    half.layers = 2;
    expect_linked(half, {.moving_objects = true});
    EXPECT_EQ(files_.size(), 14U);
}

}  // namespace es_passes_test
}  // namespace gloam::effect
