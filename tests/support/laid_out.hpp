// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <glm/glm.hpp>

#include "shader/reflection.hpp"
#include "support/test.hpp"

namespace gloam::test {

using shader::LaidOut;

template <class T>
struct Shape;  // of a member: type of its components, rows, columns
template <>
struct Shape<float> {
    static constexpr const char* type = "float";
    static constexpr unsigned rows = 1, columns = 1;
};
template <>
struct Shape<std::int32_t> {
    static constexpr const char* type = "int";
    static constexpr unsigned rows = 1, columns = 1;
};
template <>
struct Shape<std::uint32_t> {
    static constexpr const char* type = "uint";
    static constexpr unsigned rows = 1, columns = 1;
};
template <class T, std::size_t n>
struct Shape<std::array<T, n>> {
    static constexpr const char* type = Shape<T>::type;
    static constexpr unsigned rows = n, columns = 1;
};
template <glm::length_t n, class T>
struct Shape<glm::vec<n, T>> {
    static constexpr const char* type = Shape<T>::type;
    static constexpr unsigned rows = n, columns = 1;
};
template <glm::length_t c, glm::length_t r>
struct Shape<glm::mat<c, r, float>> {
    static constexpr const char* type = "float";
    static constexpr unsigned rows = r, columns = c;
};

// A member in one line: "vec 2 x 1 of float at 8: size".
inline std::string line_of(const LaidOut& member) {
    return fmt::format("{} x {} of {} at {}: {}", member.rows, member.columns, member.type, member.offset,
                       member.name);
}

template <class Member>
std::string line_of(const char* name, std::size_t offset) {
    using Of = Shape<Member>;
    return line_of(
        LaidOut{.name = name, .type = Of::type, .rows = Of::rows, .columns = Of::columns, .offset = offset});
}

inline std::vector<std::string> lines_of(const std::vector<LaidOut>& members) {
    std::vector<std::string> lines;
    for (const LaidOut& member : members) lines.push_back(line_of(member));
    return lines;
}

}  // namespace gloam::test

// The line of a member of a struct of ours.
#define MEMBER(type, name) gloam::test::line_of<decltype(type::name)>(#name, offsetof(type, name))
