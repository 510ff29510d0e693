// SPDX-License-Identifier: MIT
#include "catalogue/inputs.hpp"
#include "catalogue/temporal_parts.hpp"
#include "reference/temporal.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;
using History = reference::GloamHistory;
using Packed = reference::GloamPackedHistory;

constexpr Origin origin{"gloam/temporal/packed_history.glsl",
                        "gloam: the layout of TSSAO's ambient-occlusion buffer in 64 bits"};

Values depths() {
    return either(log_uniform(1e-3, 1e6), log_uniform(1e-12, 1e12))
        .and_near({0x1p-126, 0x1p-31, 0x1p32, 0x1.fffffep127})
        .and_special();
}

// Members of 16 bits, and some larger ones.
Values members() {
    return either(log_integers(65535), log_integers(4294967295)).and_near_integers({32768, 65535});
}

}  // namespace

void append_packed_history(Entries& entries) {
    append_exact<unsigned(float)>(entries, origin,
                                  {.id = "PACKED-round",
                                   .function = "gloam_round_half_up",
                                   .title = "nearest integer, by no operation that rounds",
                                   .formula = "floor(x + 1/2)"},
                                  &reference::gloam_round_half_up,
                                  {either(uniform(0, 70000), log_uniform(1e-30, 8388608))});
    append_exact<unsigned(float)>(entries, origin,
                                  {.id = "PACKED-depth",
                                   .function = "gloam_depth_to_code",
                                   .title = "depth in 16 bits",
                                   .formula = "6 bits of exponent, 10 of mantissa; 65535 for background"},
                                  &reference::gloam_depth_to_code, {depths()});
    append_exact<float(unsigned)>(entries, origin,
                                  {.id = "PACKED-depth-of",
                                   .function = "gloam_depth_from_code",
                                   .title = "depth from 16 bits",
                                   .formula = "the inverse of PACKED-depth"},
                                  &reference::gloam_depth_from_code, {members()});
    const Values history =
        vector({uniform(0, 1).and_near({0.0, 1.0}).and_special(),
                either(uniform(0, 5000), log_uniform(1e-30, 1e30)).and_near({4095.0}).and_special(),
                log_integers(4294967295).and_near_integers({65536, 16777216}), depths()});
    append_exact<Packed(History)>(entries, origin,
                                  {.id = "PACKED-encode",
                                   .function = "gloam_history_encode",
                                   .title = "history in 64 bits",
                                   .formula = "(32768 AO, 16 w, j, code of d), rounded"},
                                  &reference::gloam_history_encode, {history});
    const Values packed = vector({members(), members(), members(), members()});
    append_exact<glm::vec4(Packed)>(entries, origin,
                                    {.id = "PACKED-texel",
                                     .function = "gloam_packed_texel",
                                     .title = "texel that 64 bits stand for",
                                     .formula = "(AO, w, j, d), the inverse of PACKED-encode"},
                                    &reference::gloam_packed_texel, {packed});
    append_exact<History(Packed)>(entries, origin,
                                  {.id = "PACKED-decode",
                                   .function = "gloam_history_decode",
                                   .title = "history from 64 bits",
                                   .formula = "the same, sanitized"},
                                  &reference::gloam_history_decode, {packed});
}

}  // namespace gloam::catalogue
