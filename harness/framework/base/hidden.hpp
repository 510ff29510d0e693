// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

namespace gloam::base {

// Owns an object of a class that only one source defines. Its owner needs neither a destructor nor moves of
// its own, as it would with std::unique_ptr<T>.
template <class T>
using Hidden = std::unique_ptr<T, void (*)(T*)>;

template <class T, class... Arguments>
[[nodiscard]] Hidden<T> make_hidden(Arguments&&... arguments) {
    return {new T(std::forward<Arguments>(arguments)...), [](T* object) { delete object; }};
}

}  // namespace gloam::base
