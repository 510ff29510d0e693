// SPDX-License-Identifier: MIT
#pragma once

#include "effect/methods.hpp"

namespace gloam::test {

// The names of the methods for which `wanted` holds: tests that are parametrised by one run alone after a
// change of its shader (tools/test-readers).
template <class Predicate>
std::vector<std::string> method_names(Predicate wanted) {
    std::vector<std::string> names;
    for (const effect::MethodInfo& method : effect::methods()) {
        if (wanted(method)) names.push_back(method.name);
    }
    return names;
}

inline std::vector<std::string> method_names() {
    return method_names([](const effect::MethodInfo&) { return true; });
}

// The method's name as the name of the parameter.
inline std::string parameter_name(const testing::TestParamInfo<std::string>& info) {
    return info.param;
}

}  // namespace gloam::test
