// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "shader/compile.hpp"

namespace gloam::shader::internal {

// compile() and functions() in another process, with results as bytes. A compiler is a large program, and the
// text can be untrusted: a macro, a loop to unroll or a deep expression can exhaust it. The process has
// limits far beyond the needs of any reasonable shader: 60 s of processor time, 3 GiB. Both throw
// CompileError.
[[nodiscard]] std::string compiled_apart(const Source& source, const CompileOptions& options);
[[nodiscard]] std::string functions_apart(const Source& source, const CompileOptions& options);

}  // namespace gloam::shader::internal
