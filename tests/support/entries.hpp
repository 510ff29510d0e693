// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <vector>

#include "catalogue/catalogue.hpp"

namespace gloam::test {

// All entries of the catalogue, made once.
inline const std::vector<catalogue::Entry>& entries() {
    static const std::vector<catalogue::Entry> all = catalogue::all_entries();
    return all;
}

// The numbers of all entries of the catalogue: tests that are parametrised by one run alone after a change of
// its shader (tools/test --seeing).
inline auto entry_numbers() {
    return testing::Range(std::size_t{0}, entries().size());
}

// The entry's ID as the name of the parameter.
inline std::string entry_name(const testing::TestParamInfo<std::size_t>& info) {
    std::string name = entries()[info.param].description.id;
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

}  // namespace gloam::test
