// SPDX-License-Identifier: MIT
// The front end of the framework, as far as it is ours: lines, directives, includes, declarations.
// (gloam tries glslang in a copy of the process first, see harness/framework/base/process.hpp.)
#include "fuzz/fuzz.hpp"
#include "module/include.hpp"
#include "source/declarations.hpp"

using namespace gloam;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(fuzz::text_of(data, size));
    const auto& file = fuzz::file_of(text, ".glsl");
    fuzz::read_or_refuse([&] { (void)module::include_closure({file.string(), text}, {file.parent_path()}); });
    fuzz::read_or_refuse([&] { (void)source::outline(source::whole_text(text)); });
    return 0;
}
