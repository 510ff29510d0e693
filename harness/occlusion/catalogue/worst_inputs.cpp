// SPDX-License-Identifier: MIT
#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "catalogue/entry.hpp"

namespace gloam::catalogue {
namespace {

// An equation and the words of its input, in hexadecimal; they may go on in lines that begin with a space.
// Found by `gloam stress --only worst-inputs` on llvmpipe (LLVM 15): the climb found larger errors than the
// same number of random inputs.
constexpr const char* found = R"(
SMALL-ARC 3f029205
ACOS bf01ba1d
ATAN2 bf5038b6 bf5312c6
HALTON 00000ad9 00000457
TSSAO-13 3f21cce4 3f7efec8
TSSAO-14 3e5f1971 3f7f3c64 3b838541
TSSAO-14-uniform 3be44cfe 3f7dc365 3e576215
FRAME 3f7f9cbb 3d57773c 3c78974b
TSSAO-ROT-disc bd56ff1c 3f2e625b c019c067
TSSAO-ROT-hemisphere 3e1c7e64 bf1f60b5 bdf03558 447b0fcb
POISSON-lift bf30a03d bf394f01
DEPTH-perspective-vk 3efff847 bf80013a c000013e
DEPTH-perspective-gl 33a00000 bf8001f4 bd7fc06b
DEPTH-orthographic-vk 3efffe03 39006504 3f8000eb
DEPTH-orthographic-gl 33bfffff 3b004025 3f805d4c
POSITION-perspective bf57ad61 3f8b76ea 417674c7 3f7ffff0 bf881e93
NDC-perspective bf085a79 bd17033a bd8265a3 4072f97e 3fc8ae64
NORMALIZE 47754b61 48b5a738 c6c163b6 3e87edb4 bf29e761 3f33061d
NORMAL-orthographic c09c5c17 2ecd4e04 bfdeb491 c09d277b bbbe633a c068c675 c09a9141 3bdd0cd4 bfd8e67e
 c09c1ef2 3d5c288e c09dd989 c0bc5c17 bdc03113 c024080e
NORMAL-facing 3f1d4d1f 3f25b23f 3ee6f8e7 bf178967 bf29f22c beea044f 3bb8b5f4 3ce72d14 bbcc9ea8
TSSAO-RP-uv beef99be 3efc767a bda4c0b1 3f027dd0
TSSAO-RP 3f7cfeff bf2269d1 3f429383 3f800000 3f712a10 3e470dff be9a12d9 be9a12d9 bd95bc61 3f7cf42a bd19bb0e
 bd19bb0e 40b6246e bf865d77 4041b7b1 4001b7b1 c0abbd93 3fa27a11 c0053bfb bf8a77f7
TSSAO-RP-static c10d820b 40bdb345 4100d52c 41014c4c 3f65b71d 80000000 00000000 80000000 80000000 bf002cea
 80000000 00000000 00000000 80000000 00000000 c11a65cf 80000000 00000000 bf800000 411a83c7 3f5ff420 3ec0d5cd
 be9c0169 00000000 3dbee8fc bf3f81a0 bf2833a8 00000000 bef36744 3f0bdff5 bf30856c 00000000 4073a6eb bff0ca8e
 c10f6c0d 3f800000 3f393cc5 befa73ca 3ef954cf 00000000 3f30039a 3f12ac0e bee467fe 00000000 bd78fc0a 3f285997
 3f403ab7 00000000 40384855 c109a6e4 c05ee77f 3f800000 3f8ca3c6 00000000 00000000 00000000 00000000 bff919ec
 00000000 00000000 00000000 bf800000 3ae88e94 bf800000 00000000 00000000 3e75323a 00000000
TSSAO-RP-moving c0bfbe6f c07df52f 40f2c381 41008b65 3f27e027 80000000 00000000 80000000 80000000 bf0fb780
 80000000 00000000 00000000 80000000 00000000 c115d9a1 80000000 00000000 bf800000 4115d9a1 3ef39237 beec8e3b
 bf3f9c53 00000000 3f195cc1 bee7df60 3f290a6f 00000000 bf24e064 bf433494 3d7b3fd7 00000000 c10c165b bf3d645a
 40641e06 3f800000 3f3927d6 3ed17275 3f0e6e25 00000000 bd9c1625 3f591841 bf06420a 00000000 bf2fb4d4 3eac7f5f
 3f24ff8d 00000000 c0663a95 c082e3b1 c0c4a526 3f800000 beb850f1 3f57e476 becc499b 00000000 3f3dc8ae 3f04aa13
 3eda5766 00000000 3f10fff6 be11b11d bf4fcf00 00000000 c08e1c45 c0ded3bf 3ebb391b 3f800000 3f0b9876 3f555d26
 bdb74af7 00000000 bf47a7a1 3f0b27ee 3e9edd9c 00000000 3e9d50c4 bdcb9078 3f7248ad 00000000 c040995c c0c6b832
 40e16310 3f800000 3f9715ac 00000000 00000000 00000000 bf800000 bffc3d8b 00000000 00000000 00000000 00000000
 00000000 bf800000 00000000 00000000 3f678ad3 00000000
CAMERA-uv bf89ec2a c00db2d9 c00808be 3fb89a06 bf749014 00000001 00000001 00000000
CAMERA-position ffdbc4e7 00000031 41763fed 3f36d9ff 3f3d00ce 00000001 00000001 00000000
CAMERA-radius 3bf5d7a8 3eec0577 3f81b986 3ff30059 00000001 00000001 00000000
TSSAO-BORDER-guard 00000dd2 00400001 3f3fffff
TSSAO-BORDER-tan 3fff8487 3f0017d9
FALLOFF-linear b6810001 3f007e84
FALLOFF-quadratic bf074c33 3fcc4d0d
TSSAO-1-cos f2b1480d 7197a2f2 f1491dbb bf6c80e2 3c85bad3 bec3cd79
TSSAO-3 3e80de65 3dffffff 3cfd8978
BILINEAR 3e29506e 3ecd83df
BILINEAR-valid 39687000 3f1694d2 3d7f2470 3f7503dc 00000001 00000000 00000001 00000001
TSSAO-9 bda40093 3eb2bb28 3eae77ea bde4cd8b bebd7faf bdf289ab 40e301b5 c0fe2843 4063f246 40dd603f 40ff1e8a
 41000000
TSSAO-SI-b 4912a873 41e036f5
TSSAO-11 3ea0d100 43006dd0
TSSAO-10-g 3f693ce9 4034394b
TSSAO-10-sigma 3f7fffff 3f812a84 467bc153 40f3e46b
METHOD-alchemy 3ffe46b7 c088dc58 c02f2b70 00000000 bf800000 00000000 3fa4dba1 bf13b0b2 00000015 0000000d 00000000
 3f80f5f6 3bc97f4b 40a2a47d 00000000 00000002 3fd959de 3d4cccdd 3f72b113
METHOD-volumetric_area 3f8b3ac1 4003f401 c06eb3b8 bf449c22 bc3e888b 3f23ed05 3fb4bbbf bf3da571 00000017 0000000f
 00000000 3f5c09f9 3dafaafb 3e9c1f45 000166c8 00000004 3fad2e38
METHOD-disc_proxy 3f3e661e 3eb0b86e bfbd299e 00000000 bf667297 3edefa99 3fa1fa6b 402d0fb1 00000011 0000000f 00000001
 3f853369 3b8420c7 408705b7 0000f707 00000003 3f406126 3f7fffde
METHOD-disc_proxy_two 3f9170cc bead6738 bfbd299e 80000000 3f6743c2 3edb91af 3f540c6e c0305f3b 00000011 0000000f 00000001
 3f945dfe 3ae08744 3feda91e 00000096 00000003 5d5e0b6b 3f719ce5
METHOD-curvature 3dd5adcc bf05ef31 bfda1188 bcb09512 bda0cfb7 3fffc9aa 3fc70df2 bf004004 00000015 0000000d 00000000
 3ecb6543 3c34ada4 40c6beea 0002a8c1 00000007 7f800000 3ffe42b3
CS-REMAP 3f7bd5d3 bed0fa25 3fde2474 40ff5f02
)";

}  // namespace

void add_worst_inputs(Entries& entries) {
    std::string text = found;
    for (std::size_t at = 0; (at = text.find("\n ", at)) != std::string::npos;) text.erase(at, 1);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty()) continue;
        std::istringstream row(line);
        std::string equation;
        row >> equation >> std::hex;
        std::vector<subject::Word> words;
        for (subject::Word word = 0; row >> word;) words.push_back(word);
        const auto entry =
            std::ranges::find_if(entries, [&](const Entry& e) { return e.description.id == equation; });
        if (entry == entries.end()) throw std::logic_error("worst input of an unknown equation: " + equation);
        subject::Domain& domain = entry->question.domain;
        domain = domain.and_words(words);
    }
}

}  // namespace gloam::catalogue
