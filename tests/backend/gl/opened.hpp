// SPDX-License-Identifier: MIT
#pragma once

#include "backend/gl/device.hpp"
#include "support/test.hpp"

namespace gloam::gl {

// The device of a test, which is skipped in one line where this machine has no such device.
class Opened : public testing::Test {
  protected:
    // False where there is none.
    bool open(const std::string& name) {
        try {
            device_.emplace(name);
        } catch (const Unavailable& error) {
            skipped_ = error.what();
        }
        return device_.has_value();
    }
    [[nodiscard]] const Device& device() const { return *device_; }
    void close() { device_.reset(); }

    std::string skipped_;

  private:
    std::optional<Device> device_;
};

#define GLOAM_OPEN_OR_SKIP(name) \
    if (!open(name)) GTEST_SKIP() << skipped_

}  // namespace gloam::gl
