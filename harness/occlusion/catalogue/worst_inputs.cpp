// SPDX-License-Identifier: MIT
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "catalogue/entry.hpp"

namespace gloam::catalogue {
namespace {

struct WorstInput {
    std::string equation;
    std::vector<check::Word> words;
};

// Found by `gloam stress --only worst-inputs` on llvmpipe (LLVM 15): the climb found larger errors than the
// same number of random inputs.
std::vector<WorstInput> found() {
    return {
        {"SMALL-ARC", {0x3f029205U}},
        {"ACOS", {0xbf01ba1dU}},
        {"ATAN2", {0xbf5038b6U, 0xbf5312c6U}},
        {"HALTON", {0x00000ad9U, 0x00000457U}},
        {"TSSAO-13", {0x3f21cce4U, 0x3f7efec8U}},
        {"TSSAO-14", {0x3e5f1971U, 0x3f7f3c64U, 0x3b838541U}},
        {"TSSAO-14-uniform", {0x3be44cfeU, 0x3f7dc365U, 0x3e576215U}},
        {"FRAME", {0x3f7f9cbbU, 0x3d57773cU, 0x3c78974bU}},
        {"TSSAO-ROT-disc", {0xbd56ff1cU, 0x3f2e625bU, 0xc019c067U}},
        {"TSSAO-ROT-hemisphere", {0x3e1c7e64U, 0xbf1f60b5U, 0xbdf03558U, 0x447b0fcbU}},
        {"POISSON-lift", {0xbf30a03dU, 0xbf394f01U}},
        {"DEPTH-perspective-vk", {0x3efff847U, 0xbf80013aU, 0xc000013eU}},
        {"DEPTH-perspective-gl", {0x33a00000U, 0xbf8001f4U, 0xbd7fc06bU}},
        {"DEPTH-orthographic-vk", {0x3efffe03U, 0x39006504U, 0x3f8000ebU}},
        {"DEPTH-orthographic-gl", {0x33bfffffU, 0x3b004025U, 0x3f805d4cU}},
        {"POSITION-perspective", {0xbf57ad61U, 0x3f8b76eaU, 0x417674c7U, 0x3f7ffff0U, 0xbf881e93U}},
        {"NDC-perspective", {0xbf085a79U, 0xbd17033aU, 0xbd8265a3U, 0x4072f97eU, 0x3fc8ae64U}},
        {"NORMALIZE", {0x47754b61U, 0x48b5a738U, 0xc6c163b6U, 0x3e87edb4U, 0xbf29e761U, 0x3f33061dU}},
        {"NORMAL-orthographic",
         {0xc09c5c17U, 0x2ecd4e04U, 0xbfdeb491U, 0xc09d277bU, 0xbbbe633aU, 0xc068c675U, 0xc09a9141U,
          0x3bdd0cd4U, 0xbfd8e67eU, 0xc09c1ef2U, 0x3d5c288eU, 0xc09dd989U, 0xc0bc5c17U, 0xbdc03113U,
          0xc024080eU}},
        {"NORMAL-facing",
         {0x3f1d4d1fU, 0x3f25b23fU, 0x3ee6f8e7U, 0xbf178967U, 0xbf29f22cU, 0xbeea044fU, 0x3bb8b5f4U,
          0x3ce72d14U, 0xbbcc9ea8U}},
        {"TSSAO-RP-uv", {0xbeef99beU, 0x3efc767aU, 0xbda4c0b1U, 0x3f027dd0U}},
        {"TSSAO-RP",
         {0x3f7cfeffU, 0xbf2269d1U, 0x3f429383U, 0x3f800000U, 0x3f712a10U, 0x3e470dffU, 0xbe9a12d9U,
          0xbe9a12d9U, 0xbd95bc61U, 0x3f7cf42aU, 0xbd19bb0eU, 0xbd19bb0eU, 0x40b6246eU, 0xbf865d77U,
          0x4041b7b1U, 0x4001b7b1U, 0xc0abbd93U, 0x3fa27a11U, 0xc0053bfbU, 0xbf8a77f7U}},
        {"TSSAO-RP-static",
         {0xc10d820bU, 0x40bdb345U, 0x4100d52cU, 0x41014c4cU, 0x3f65b71dU, 0x80000000U, 0x00000000U,
          0x80000000U, 0x80000000U, 0xbf002ceaU, 0x80000000U, 0x00000000U, 0x00000000U, 0x80000000U,
          0x00000000U, 0xc11a65cfU, 0x80000000U, 0x00000000U, 0xbf800000U, 0x411a83c7U, 0x3f5ff420U,
          0x3ec0d5cdU, 0xbe9c0169U, 0x00000000U, 0x3dbee8fcU, 0xbf3f81a0U, 0xbf2833a8U, 0x00000000U,
          0xbef36744U, 0x3f0bdff5U, 0xbf30856cU, 0x00000000U, 0x4073a6ebU, 0xbff0ca8eU, 0xc10f6c0dU,
          0x3f800000U, 0x3f393cc5U, 0xbefa73caU, 0x3ef954cfU, 0x00000000U, 0x3f30039aU, 0x3f12ac0eU,
          0xbee467feU, 0x00000000U, 0xbd78fc0aU, 0x3f285997U, 0x3f403ab7U, 0x00000000U, 0x40384855U,
          0xc109a6e4U, 0xc05ee77fU, 0x3f800000U, 0x3f8ca3c6U, 0x00000000U, 0x00000000U, 0x00000000U,
          0x00000000U, 0xbff919ecU, 0x00000000U, 0x00000000U, 0x00000000U, 0xbf800000U, 0x3ae88e94U,
          0xbf800000U, 0x00000000U, 0x00000000U, 0x3e75323aU, 0x00000000U}},
        {"TSSAO-RP-moving",
         {0xc0bfbe6fU, 0xc07df52fU, 0x40f2c381U, 0x41008b65U, 0x3f27e027U, 0x80000000U, 0x00000000U,
          0x80000000U, 0x80000000U, 0xbf0fb780U, 0x80000000U, 0x00000000U, 0x00000000U, 0x80000000U,
          0x00000000U, 0xc115d9a1U, 0x80000000U, 0x00000000U, 0xbf800000U, 0x4115d9a1U, 0x3ef39237U,
          0xbeec8e3bU, 0xbf3f9c53U, 0x00000000U, 0x3f195cc1U, 0xbee7df60U, 0x3f290a6fU, 0x00000000U,
          0xbf24e064U, 0xbf433494U, 0x3d7b3fd7U, 0x00000000U, 0xc10c165bU, 0xbf3d645aU, 0x40641e06U,
          0x3f800000U, 0x3f3927d6U, 0x3ed17275U, 0x3f0e6e25U, 0x00000000U, 0xbd9c1625U, 0x3f591841U,
          0xbf06420aU, 0x00000000U, 0xbf2fb4d4U, 0x3eac7f5fU, 0x3f24ff8dU, 0x00000000U, 0xc0663a95U,
          0xc082e3b1U, 0xc0c4a526U, 0x3f800000U, 0xbeb850f1U, 0x3f57e476U, 0xbecc499bU, 0x00000000U,
          0x3f3dc8aeU, 0x3f04aa13U, 0x3eda5766U, 0x00000000U, 0x3f10fff6U, 0xbe11b11dU, 0xbf4fcf00U,
          0x00000000U, 0xc08e1c45U, 0xc0ded3bfU, 0x3ebb391bU, 0x3f800000U, 0x3f0b9876U, 0x3f555d26U,
          0xbdb74af7U, 0x00000000U, 0xbf47a7a1U, 0x3f0b27eeU, 0x3e9edd9cU, 0x00000000U, 0x3e9d50c4U,
          0xbdcb9078U, 0x3f7248adU, 0x00000000U, 0xc040995cU, 0xc0c6b832U, 0x40e16310U, 0x3f800000U,
          0x3f9715acU, 0x00000000U, 0x00000000U, 0x00000000U, 0xbf800000U, 0xbffc3d8bU, 0x00000000U,
          0x00000000U, 0x00000000U, 0x00000000U, 0x00000000U, 0xbf800000U, 0x00000000U, 0x00000000U,
          0x3f678ad3U, 0x00000000U}},
        {"CAMERA-uv",
         {0xbf89ec2aU, 0xc00db2d9U, 0xc00808beU, 0x3fb89a06U, 0xbf749014U, 0x00000001U, 0x00000001U,
          0x00000000U}},
        {"CAMERA-position",
         {0xffdbc4e7U, 0x00000031U, 0x41763fedU, 0x3f36d9ffU, 0x3f3d00ceU, 0x00000001U, 0x00000001U,
          0x00000000U}},
        {"CAMERA-radius",
         {0x3bf5d7a8U, 0x3eec0577U, 0x3f81b986U, 0x3ff30059U, 0x00000001U, 0x00000001U, 0x00000000U}},
        {"TSSAO-BORDER-guard", {0x00000dd2U, 0x00400001U, 0x3f3fffffU}},
        {"TSSAO-BORDER-tan", {0x3fff8487U, 0x3f0017d9U}},
        {"FALLOFF-linear", {0xb6810001U, 0x3f007e84U}},
        {"FALLOFF-quadratic", {0xbf074c33U, 0x3fcc4d0dU}},
        {"TSSAO-1-cos", {0xf2b1480dU, 0x7197a2f2U, 0xf1491dbbU, 0xbf6c80e2U, 0x3c85bad3U, 0xbec3cd79U}},
        {"TSSAO-3", {0x3e80de65U, 0x3dffffffU, 0x3cfd8978U}},
        {"BILINEAR", {0x3e29506eU, 0x3ecd83dfU}},
        {"BILINEAR-valid",
         {0x39687000U, 0x3f1694d2U, 0x3d7f2470U, 0x3f7503dcU, 0x00000001U, 0x00000000U, 0x00000001U,
          0x00000001U}},
        {"TSSAO-9",
         {0xbda40093U, 0x3eb2bb28U, 0x3eae77eaU, 0xbde4cd8bU, 0xbebd7fafU, 0xbdf289abU, 0x40e301b5U,
          0xc0fe2843U, 0x4063f246U, 0x40dd603fU, 0x40ff1e8aU, 0x41000000U}},
        {"TSSAO-SI-b", {0x4912a873U, 0x41e036f5U}},
        {"TSSAO-11", {0x3ea0d100U, 0x43006dd0U}},
        {"TSSAO-10-g", {0x3f693ce9U, 0x4034394bU}},
        {"TSSAO-10-sigma", {0x3f7fffffU, 0x3f812a84U, 0x467bc153U, 0x40f3e46bU}},
        {"CS-REMAP", {0x3f7bd5d3U, 0xbed0fa25U, 0x3fde2474U, 0x40ff5f02U}},
    };
}

}  // namespace

void add_worst_inputs(Entries& entries) {
    for (const WorstInput& worst : found()) {
        const auto entry =
            std::ranges::find_if(entries, [&](const Entry& e) { return e.description.id == worst.equation; });
        if (entry == entries.end())
            throw std::logic_error("worst input of an unknown equation: " + worst.equation);
        check::Domain& domain = entry->question.domain;
        domain = domain.and_words(worst.words);
    }
}

}  // namespace gloam::catalogue
