// SPDX-License-Identifier: MIT
#pragma once

#include "support/test.hpp"

namespace gloam::test {

// A variable of the environment; "" where it is not set.
inline std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

// Where compiled shaders are kept between tests; empty when the environment does not say.
inline std::filesystem::path cache_directory() {
    return variable("GLOAM_CACHE_DIR");
}

// Sets an environment variable as long as it lives, or unsets it (nullptr).
class ScopedVariable {
  public:
    ScopedVariable(const char* name, const char* value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        set(value);
    }
    ~ScopedVariable() { set(old_ ? old_->c_str() : nullptr); }
    ScopedVariable(const ScopedVariable&) = delete;
    ScopedVariable& operator=(const ScopedVariable&) = delete;

  private:
    void set(const char* value) const { value == nullptr ? ::unsetenv(name_) : ::setenv(name_, value, 1); }

    const char* name_;
    std::optional<std::string> old_;
};

}  // namespace gloam::test
