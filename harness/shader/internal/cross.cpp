// SPDX-License-Identifier: MIT
#include "shader/internal/cross.hpp"

#include <stdexcept>
#include <utility>

namespace gloam::shader::internal {

Cross::Cross(const Spirv& module, spvc_backend backend, std::string purpose) : purpose_(std::move(purpose)) {
    spvc_context context = nullptr;
    if (spvc_context_create(&context) != SPVC_SUCCESS) throw std::runtime_error("SPIRV-Cross: out of memory");
    context_.reset(context);
    spvc_parsed_ir parsed = nullptr;
    require(spvc_context_parse_spirv(context, module.data(), module.size(), &parsed));
    require(
        spvc_context_create_compiler(context, backend, parsed, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP, &compiler_));
}

void Cross::require(spvc_result result) const {
    if (result == SPVC_SUCCESS) return;
    throw std::runtime_error("SPIRV-Cross cannot " + purpose_ + ": " +
                             spvc_context_get_last_error_string(context_.get()));
}

}  // namespace gloam::shader::internal
