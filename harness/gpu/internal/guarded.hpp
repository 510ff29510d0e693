// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include "gpu/internal/context.hpp"

namespace gloam::gpu {

// Owns Vulkan handles that a submission may use. Vulkan forbids destroying them while it runs, and after a
// timeout its end is unknown. Only in that case they are leaked on purpose.
template <class Handles>
class Guarded {
  public:
    Guarded(Context& context, Handles handles)
        : context_(context), handles_(std::make_unique<Handles>(std::move(handles))) {}
    ~Guarded() {
        if (!context_.idle()) context_.keep(std::move(handles_));
    }
    Guarded(const Guarded&) = delete;
    Guarded& operator=(const Guarded&) = delete;

    [[nodiscard]] Handles& operator*() const { return *handles_; }
    [[nodiscard]] Handles* operator->() const { return handles_.get(); }

  private:
    Context& context_;
    std::unique_ptr<Handles> handles_;
};

}  // namespace gloam::gpu
