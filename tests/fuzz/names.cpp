// SPDX-License-Identifier: MIT
// Untrusted text in names, messages and bounds.
#include "base/text.hpp"
#include "fuzz/fuzz.hpp"

using namespace gloam;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::text_of(data, size);
    const std::string name = base::file_name_of(text);
    fuzz::require(!name.empty() && name.size() <= 120 && name.front() != '.');
    fuzz::require(name.find_first_of(std::string_view("/\0\n\\ '\"`$", 9)) == std::string::npos);
    const std::size_t most = size % 50;
    fuzz::require(base::shortened(text, most).size() <= std::max<std::size_t>(most, 3));
    for (const char c : base::one_line(text)) fuzz::require(static_cast<unsigned char>(c) >= 0x20U);
    fuzz::read_or_refuse(
        [&] { base::require_bounded_json(text, {.bytes = 1000, .depth = 5, .members = 5}); });
    return 0;
}
