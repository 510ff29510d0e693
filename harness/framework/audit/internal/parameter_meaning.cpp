// SPDX-License-Identifier: MIT
#include "audit/internal/parameter_meaning.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/number.hpp"
#include "base/pattern.hpp"
#include "base/text.hpp"

namespace gloam::audit::internal {
namespace {

constexpr double pi = std::numbers::pi;

// Where a sentence ends: at a semicolon, or at a single full stop before a blank.
std::size_t sentence_end(std::string_view text) {
    std::size_t end = std::min(text.find(';'), text.size());
    for (std::size_t at = text.find('.'); at < end; at = text.find('.', at + 1)) {
        const bool single = at == 0 || text[at - 1] != '.';
        if (single && (at + 1 == text.size() || std::isspace(static_cast<unsigned char>(text[at + 1])) != 0))
            end = at;
    }
    return end;
}

// Names that most shaders use for the same thing, for parameters with so many components.
struct NameRule {
    std::string_view names;  // between blanks
    int fewest;
    int most;
    Meaning meaning;
};
constexpr int any = 4;
constexpr std::string_view colours =
    " color colour col rgb rgba rgbm albedo diffuse specular tint base f0 f90 c srgb hsv hsl ";
constexpr std::string_view shares =
    " color colour alpha opacity roughness rough metallic metalness smoothness amount mix factor weight "
    "saturation hue luma luminance brightness contrast ao occlusion visibility vis coverage fresnel f0 f90 t "
    "pct percent strength intensity steepness depth ndc ";
constexpr std::string_view directions =
    " n normal norm nrm normals dir direction l v h rd ray axis up forward tangent bitangent binormal view "
    "light half halfway reflection incident wi wo wh ";
constexpr std::string_view cosines =
    " nol nov noh loh voh vol ldoth ldotv ndotl ndotv ndoth vdoth hdotv hdotl vdotl nl nv nh lh vh ";
constexpr std::string_view sizes =
    " radius size width height thickness scale sigma dist distance length eps epsilon softness falloff gamma "
    "exponent power exposure shininess frequency freq lacunarity range whitepoint white far period "
    "wavelength "
    "aperture shutter speed sensitivity ior ";
constexpr std::array name_rules{
    NameRule{" uv st texcoord coord coords texcoords ", 2, 2, {}},
    NameRule{colours, 3, 4, {}},
    NameRule{shares, 1, 1, {}},
    NameRule{directions, 2, 3, {Kind::unit, 0.0, 0.0}},
    NameRule{" q quat quaternion rotation ", any, any, {Kind::unit, 0.0, 0.0}},
    NameRule{cosines, 1, 1, {}},
    NameRule{" cos costheta cosine mu cosangle ", 1, 1, {Kind::range, -1.0, 1.0}},
    NameRule{" angle theta phi rad radians rotation ", 1, 1, {Kind::range, -2.0 * pi, 2.0 * pi}},
    NameRule{" degrees deg ", 1, 1, {Kind::range, -360.0, 360.0}},
    NameRule{" time u_time itime seconds ", 1, 1, {Kind::range, 0.0, 3600.0}},
    NameRule{sizes, 1, any, {Kind::positive, 0.0, 0.0}},
    NameRule{" near ", 1, 1, {Kind::range, 0.01, 1.0}},
    NameRule{" resolution res dimensions ", 2, 3, {Kind::range, 1.0, 4096.0}},
    NameRule{" p pos position point origin ro center centre o ", 2, 3, {Kind::range, -10.0, 10.0}},
};

// The words of a name: "lightDir" and "light_dir" are light, dir; digits at the end are dropped.
std::vector<std::string> words_of(const std::string& name) {
    std::vector<std::string> words(1);
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto c = static_cast<unsigned char>(name[i]);
        const bool starts =
            std::isupper(c) != 0 && i > 0 && std::islower(static_cast<unsigned char>(name[i - 1])) != 0;
        if ((starts || c == '_') && !words.back().empty()) words.emplace_back();
        if (c != '_') words.back() += static_cast<char>(std::tolower(c));
    }
    for (std::string& word : words)
        while (word.size() > 1 && std::isdigit(static_cast<unsigned char>(word.back())) != 0) word.pop_back();
    return words;
}

// "-1e3", "2pi", "-2*pi/3"
std::optional<double> number_of(const std::string& text) {
    static const base::Pattern product(R"(^([-+]?)([\d.]+(?:e[-+]?\d+)?)?\*?(pi|π)?(?:/([\d.]+))?$)");
    const std::vector<std::string> m = product.first(text);
    if (m.empty() || (m[2].empty() && m[3].empty())) return std::nullopt;
    const auto times = base::number_from<double>(m[2].empty() ? "1" : m[2]);
    const auto over = base::number_from<double>(m[4].empty() ? "1" : m[4]);
    if (!times || !over || *over == 0.0) return std::nullopt;
    return (m[1] == "-" ? -1.0 : 1.0) * *times * (m[3].empty() ? 1.0 : pi) / *over;
}

double after(double x, double towards) {
    return static_cast<double>(std::nextafter(static_cast<float>(x), static_cast<float>(towards)));
}

std::optional<Meaning> range_between(const std::string& low, const std::string& high, bool above,
                                     bool below) {
    const auto first = number_of(low);
    const auto last = number_of(high);
    if (!first || !last || *first > *last) return std::nullopt;
    return Meaning{Kind::range, above ? after(*first, *last) : *first, below ? after(*last, *first) : *last};
}

// What a sentence says before and behind a list of names.
std::optional<Meaning> meaning_of_words(const std::string& before, const std::string& words, bool is_vector) {
    static const std::string number = R"(([-+]?(?:[\d.]|pi|π)(?:[\w.π*/]|e-)*))";
    static const base::Pattern interval(R"(([\[(])\s*)" + number + R"(\s*,\s*)" + number + R"(\s*([\])]))");
    static const base::Pattern span("()" + number + R"(\s*(?:to|\.\.+)\s*)" + number + "()");
    static const base::Pattern between(R"(between()\s+)" + number + R"(\s+and\s+)" + number + "()");
    static const base::Pattern lower(number + R"(\s*(<=|≤|<)\s*$)");
    static const base::Pattern upper(R"(^\s*(<=|≤|<)\s*)" + number);
    static const base::Pattern bound(R"(^\s*(>=|>|≥)\s*)" + number);
    static const base::Pattern upward(number + R"(\s+and up)");
    static const base::Pattern unit(R"(\b(unit|normali[sz]ed|direction)\b)");
    static const base::Pattern unit_before(
        R"(\b(unit|normali[sz]ed)([- ]length)?(\s+(vectors?|directions?|normals?))?\s*$)");
    static const base::Pattern sign(R"(\b(not\s|non[-\s]?)?(positive|negative)\b)");
    std::vector<std::string> low = lower.first(before);
    const std::vector<std::string> high = upper.first(words);
    if (!low.empty() && !high.empty()) return range_between(low[1], high[2], low[2] == "<", high[1] == "<");
    for (const base::Pattern* const form : {&interval, &span, &between}) {
        const std::vector<std::string> m = form->first(words);
        if (m.empty()) continue;
        if (const auto meaning = range_between(m[2], m[3], m[1] == "(", m[4] == ")")) return meaning;
    }
    if (low.empty()) low = upward.first(words);
    if (const std::vector<std::string> m = bound.first(words); low.empty() && !m.empty())
        low = {"", m[2], m[1]};
    if (!low.empty()) {
        const bool open = low.back() == "<" || low.back() == ">";
        const auto least = number_of(low[1]);
        if (!least) return std::nullopt;
        return Meaning{Kind::range, open ? after(*least, usual_high) : *least,
                       std::max(*least * 2.0, usual_high)};
    }
    if (is_vector && !(unit.first(words).empty() && unit_before.first(before).empty()))
        return Meaning{Kind::unit, 0.0, 0.0};
    const std::vector<std::string> m = sign.first(words);
    if (m.empty() || m[1].empty() != (m[2] == "positive")) return std::nullopt;
    return Meaning{m[1].empty() ? Kind::positive : Kind::range, 0.0, usual_high};
}

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// The word that begins there; empty: none.
std::string word_at(std::string_view text, std::size_t at) {
    std::size_t end = std::min(at, text.size());
    while (end < text.size() && is_word(text[end])) ++end;
    return std::string(text.substr(std::min(at, end), end - std::min(at, end)));
}

// Where the next name of a list can begin behind one: "a, b and c".
std::size_t next_in_list(std::string_view text, std::size_t end) {
    std::size_t next = std::min(text.find_first_not_of(" \t,&", end), text.size());
    const bool joined = text.substr(end, next - end).find_first_of(",&") != std::string_view::npos;
    const bool has_and = next > end && word_at(text, next) == "and";
    if (has_and) next = std::min(text.find_first_not_of(" \t", next + 3), text.size());
    return joined || has_and ? next : text.size();
}

// Where a sentence leaves a parameter: at another name, or where it speaks of the result, "to [0, 1]".
std::size_t words_end(std::string_view text, const std::set<std::string>& names) {
    static const base::Pattern result(
        R"(\b(returns?|gives?|yields?|results?|becomes?)\b|->|=>|(^|[^\s\d.iπ]|[^p]i)\s*\b(in|on)?to\b)");
    const std::size_t end = sentence_end(text);
    const std::string sentence(text.substr(0, end));
    const std::vector<std::string> found = result.first(sentence);
    std::size_t first = found.empty() ? end : sentence.find(found.front()) + (found[2].empty() ? 0 : 1);
    for (std::size_t at = 0; at < first; ++at) {
        const std::string word = word_at(text, at);
        if (names.contains(word)) first = at;
        if (!word.empty()) at += word.size() - 1;
    }
    return first;
}

}  // namespace

std::optional<Meaning> meaning_of_name(const std::string& name, int components) {
    const std::vector<std::string> words = words_of(name);
    std::string whole;
    for (const std::string& word : words) whole += word;
    for (const std::string& word : {whole, words.back(), words.front()})
        for (const NameRule& rule : name_rules)
            if (components >= rule.fewest && components <= rule.most &&
                rule.names.find(" " + word + " ") != std::string_view::npos)
                return rule.meaning;
    return std::nullopt;
}

std::optional<Meaning> meaning_of_comment(std::string_view comment, const std::string& name,
                                          const std::set<std::string>& others, bool is_vector) {
    constexpr std::size_t most = 160;  // characters that belong to a name, which patterns take the square of
    for (std::size_t at = 0, end = 0; at < comment.size(); at = std::max(at + 1, end)) {
        bool is_listed = false;
        end = at;
        for (std::size_t next = at;; next = next_in_list(comment, end)) {
            const std::string word = word_at(comment, next);
            if (word.empty() || (word != name && !others.contains(word))) break;
            is_listed = is_listed || word == name;
            end = next + word.size();
        }
        if (end == at) end = at + word_at(comment, at).size();
        if (!is_listed) continue;
        const std::size_t begin = at - std::min(at, most);
        const std::string_view rest = comment.substr(end, most);
        if (const auto meaning = meaning_of_words(
                base::lower(std::string(comment.substr(begin, at - begin))),
                base::lower(std::string(rest.substr(0, words_end(rest, others)))), is_vector))
            return meaning;
    }
    return std::nullopt;
}

}  // namespace gloam::audit::internal
