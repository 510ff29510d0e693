// SPDX-License-Identifier: MIT
#include "catalogue/printed.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace gloam::catalogue {
namespace {

struct Paper {
    std::string_view prefix;
    std::string_view title;
    std::string_view remark;
};

constexpr Paper papers[] = {
    {"TSSAO-", "TSSAO, in the counting of the paper that restates it", ""},
    {"CGF-", "TSSAO, in the counting of Mattausch, Scherzer and Wimmer (Computer Graphics Forum 29(8))",
     "Equations 4, 5 and 7 are counted by their order around the blend, 6; those from 8 on were not at "
     "hand.\n\n"},
    {"ISSAO-", "ISSAO (Qiu et al. 2014)", ""},
    {"CS-", "The comparative study (Aalund and Baerentzen 2013)", ""}};

std::vector<PrintedEquation> temporal() {
    const std::string integral =
        "an integral over directions, so no function: TSSAO-2 estimates it, gloam_sample_cosine is its "
        "cosine, the falloffs are its D";
    const std::string mean = "the mean of TSSAO-2 over the k samples of a frame: the same function";
    return {
        {"TSSAO-1", "ambient occlusion", {"TSSAO-1-cos", "FALLOFF-step", "FALLOFF-linear"}, integral},
        {"TSSAO-2", "estimate by n samples", {"TSSAO-2", "TSSAO-2-add", "METHOD-hemisphere"}, ""},
        {"TSSAO-3", "contribution of a sample point", {"TSSAO-3", "TSSAO-3-V", "TSSAO-3-uniform"}, ""},
        {"TSSAO-4", "contribution of a frame", {"TSSAO-2", "TSSAO-2-add"}, mean},
        {"TSSAO-5", "blend with the history", {"TSSAO-5", "TSSAO-5-weight"}, ""},
        {"TSSAO-6", "convergence", {"TSSAO-6"}, ""},
        {"TSSAO-7", "centre of a pixel", {"TSSAO-7", "TSSAO-7-index", "TSSAO-7-pixel"}, ""},
        {"TSSAO-8", "disocclusion", {"TSSAO-8"}, ""},
        {"TSSAO-9",
         "change of the neighbourhood",
         {"TSSAO-9", "TSSAO-9-test", "TSSAO-9-probe", "TSSAO-9-reach"},
         ""},
        {"TSSAO-10", "filter", {"TSSAO-10", "TSSAO-10-weight", "TSSAO-10-g"}, ""},
        {"TSSAO-11", "shrink factor", {"TSSAO-11", "TSSAO-11-window"}, ""},
        {"TSSAO-12", "contribution of a patch", {"TSSAO-12", "TSSAO-12-unscaled", "METHOD-disc"}, ""},
        {"TSSAO-13", "kernel on a disc", {"TSSAO-13", "POINTS-disc"}, ""},
        {"TSSAO-14", "kernel in a half ball", {"TSSAO-14", "TSSAO-14-uniform"}, ""},
        {"CGF-1", "ambient occlusion", {"TSSAO-1-cos", "FALLOFF-step"}, integral},
        {"CGF-2", "estimate by n samples", {"TSSAO-2", "TSSAO-2-add"}, ""},
        {"CGF-3", "contribution of a sample point", {"TSSAO-3", "TSSAO-3-V", "FALLOFF-exponential"}, ""},
        {"CGF-4", "reprojection", {"TSSAO-RP-static", "TSSAO-RP", "TSSAO-RP-moving", "TSSAO-RP-world"}, ""},
        {"CGF-5", "contribution of a frame", {"TSSAO-2", "TSSAO-2-add"}, mean},
        {"CGF-6", "blend with the history", {"TSSAO-5"}, ""},
        {"CGF-7",
         "weight of the history",
         {"TSSAO-5", "TSSAO-5-weight"},
         "the second component of the result"}};
}

std::vector<PrintedEquation> improved() {
    return {{"ISSAO-1", "offsets of the samples", {"ISSAO-1", "ISSAO-1-printed"}, ""},
            {"ISSAO-2", "ambient light", {"ISSAO-2"}, ""},
            {"ISSAO-3", "occlusion factor without attenuation", {"ISSAO-3"}, ""},
            {"ISSAO-4", "occlusion factor with attenuation", {"ISSAO-4"}, ""},
            {"ISSAO-5", "attenuation", {"ISSAO-5"}, ""},
            {"ISSAO-6", "occlusion factor of the samples", {"ISSAO-6", "ISSAO-6-mean"}, ""},
            {"ISSAO-7", "bilateral filter", {"ISSAO-7", "ISSAO-7-weight"}, ""}};
}

std::vector<PrintedEquation> study() {
    const std::vector<std::string> alchemy{"CS-M", "FALLOFF-alchemy"};
    const std::string derived =
        "a step from the obscurance with rho = u d / max(u, d)^2 to the estimate: gloam_falloff_alchemy is "
        "rho, "
        "gloam_contribution_alchemy what is averaged";
    const std::string open =
        "an integral over directions, so no function: TSSAO-2 and TSSAO-3-uniform estimate it";
    return {
        {"CS-2.1",
         "rendering equation",
         {"ISSAO-2", "CS-D"},
         "no function solves it: with constant light it is CS-2.2, with light by direction CS-D is a term"},
        {"CS-2.2",
         "constant ambient light",
         {"ISSAO-2"},
         "albedo times light times 1 - AO: gloam_ambient_light"},
        {"CS-2.3", "ambient occlusion", {"TSSAO-1-cos", "TSSAO-2", "TSSAO-3-uniform"}, open},
        {"CS-2.4",
         "ambient occlusion by visibility",
         {"TSSAO-1-cos", "TSSAO-3-uniform", "TSSAO-2"},
         open + "; the sum behind it, without a number, lacks the factor 2 of uniform directions"},
        {"CS-2.5",
         "ambient obscurance",
         {"FALLOFF-linear", "FALLOFF-quadratic", "FALLOFF-alchemy", "FALLOFF-step"},
         "CS-2.4 with rho = 1 - D of the distance for V: the falloffs are the D"},
        {"CS-3.1", "Crytek", {"CS-A", "CS-A-buffer", "CS-A-sample"}, ""},
        {"CS-3.2",
         "HBAO, the integral",
         {"CS-C", "CS-C-horizon", "CS-C-slope", "CS-C-derivatives"},
         "gloam_hbao_step adds what a sample uncovers of the inner integral"},
        {"CS-3.3", "HBAO, the inner integral", {"CS-C", "CS-C-sine"}, "its sin h - sin t, sample by sample"},
        {"CS-3.4", "HBAO, the estimate", {"CS-C", "CS-C-start-slope", "CS-C-visibility"}, ""},
        {"CS-3.5",
         "volumetric obscurance",
         {"CS-I", "CS-I-chord", "CS-I-ratio", "CS-I-pair", "METHOD-volumetric"},
         ""},
        {"CS-3.6", "Alchemy, the obscurance", {"FALLOFF-alchemy", "CS-M"}, derived},
        {"CS-3.7", "Alchemy, both together", {"FALLOFF-alchemy", "CS-M"}, derived},
        {"CS-3.8", "Alchemy, by vectors", alchemy, derived},
        {"CS-3.9", "Alchemy, squares in the divisor", alchemy, derived},
        {"CS-3.10", "Alchemy, the estimate", alchemy, "printed without the factor 2 sigma"}};
}

const Description& described(const Entries& entries, const PrintedEquation& printed, const std::string& id) {
    for (const Entry& entry : entries)
        if (entry.description.id == id) return entry.description;
    throw std::logic_error(printed.number + ": the catalogue has no " + id);
}

}  // namespace

const std::vector<PrintedEquation>& printed_equations() {
    static const std::vector<PrintedEquation> all = [] {
        std::vector<PrintedEquation> rows = temporal();
        for (const auto& more : {improved(), study()}) rows.insert(rows.end(), more.begin(), more.end());
        return rows;
    }();
    return all;
}

std::string number_from(std::string_view text) {
    std::string lower;
    for (const char c : text) lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    std::string words;  // joined by hyphens, without "eq"
    for (std::size_t i = 0; i < lower.size();) {
        const std::size_t end = std::min(lower.find_first_of(" -()", i), lower.size());
        std::string word = lower.substr(i, end - i);
        if (word == "mattausch") word = "cgf";
        if (!word.empty() && word != "eq" && word != "eq.") words += (words.empty() ? "" : "-") + word;
        i = end + 1;
    }
    return words;
}

std::string printed_page(const Entries& entries) {
    std::string text =
        "# Equations by their numbers in the papers\n\n"
        "`gloam list numbers --markdown` prints this page. `gloam list equations`, `check`, `explain` and "
        "`pack` take "
        "each\nnumber: `gloam explain CS-3.1 2 1`, `gloam list equations 'CGF-*'`.\n";
    for (const Paper& paper : papers) {
        text += fmt::format("\n## {}\n\n{}| number | equation | functions |\n| --- | --- | --- |\n",
                            paper.title, paper.remark);
        for (const PrintedEquation& printed : printed_equations()) {
            if (!printed.number.starts_with(paper.prefix)) continue;
            std::string functions;
            for (const std::string& id : printed.ids) {
                const Description& d = described(entries, printed, id);
                functions += fmt::format("{}`{}` ({})", functions.empty() ? "" : ", ", d.function, d.id);
            }
            const std::string note = printed.note.empty() ? "" : ": " + printed.note;
            text += fmt::format("| {} | {}{} | {} |\n", printed.number, printed.title, note, functions);
        }
    }
    return text;
}

}  // namespace gloam::catalogue
