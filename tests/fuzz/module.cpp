// SPDX-License-Identifier: MIT
// A SPIR-V module of any compiler: what reads its instructions and declarations, and the interpreter's
// reader.
#include <cstring>

#include "fuzz/fuzz.hpp"
#include "interpreter/internal/code.hpp"
#include "interpreter/internal/lowering.hpp"
#include "module/spirv.hpp"

using namespace gloam;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    module::Spirv module(size / sizeof(std::uint32_t));
    if (!module.empty()) std::memcpy(module.data(), data, module.size() * sizeof(std::uint32_t));
    fuzz::read_or_refuse([&] {
        const module::Spirv strict = module::with_no_contraction(module);
        fuzz::require(module::with_no_contraction(strict) == strict);
    });
    fuzz::read_or_refuse([&] { (void)module::with_relaxed_precision(module); });
    fuzz::read_or_refuse([&] { (void)module::float_constants(module::without_names(module)); });
    fuzz::read_or_refuse([&] {
        const interpreter::internal::Module read(module, {});
        (void)interpreter::internal::Lowering(read).run("main");
    });
    return 0;
}
