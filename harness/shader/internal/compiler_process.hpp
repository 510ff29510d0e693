// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "shader/compile.hpp"

namespace gloam::shader::internal {

// compile() and functions(), as bytes, by another process: a compiler is a large program, and the text may be
// anybody's. What a macro, a loop to unroll or a deep expression makes it do ends there, at limits far beyond
// what any shader of sense needs: 60 s of processor time, 3 GiB. Throw CompileError.
[[nodiscard]] std::string compiled_apart(const Source& source, const CompileOptions& options);
[[nodiscard]] std::string functions_apart(const Source& source, const CompileOptions& options);

}  // namespace gloam::shader::internal
