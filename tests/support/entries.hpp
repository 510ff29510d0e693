// SPDX-License-Identifier: MIT
#pragma once

#include "catalogue/catalogue.hpp"
#include "support/test_name.hpp"

namespace gloam::test {

// All entries of the catalogue, made once.
inline const std::vector<catalogue::Entry>& entries() {
    static const std::vector<catalogue::Entry> all = catalogue::all_entries(GLOAM_GLSL_DIR);
    return all;
}

// The numbers of all entries of the catalogue: tests that are parametrised by one run alone after a change of
// its shader (tools/test-readers).
inline auto entry_numbers() {
    return testing::Range(std::size_t{0}, entries().size());
}

// The entry's ID as the name of the parameter.
inline std::string entry_name(const testing::TestParamInfo<std::size_t>& info) {
    return test_name(entries()[info.param].description.id);
}

}  // namespace gloam::test
