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

std::optional<double> number_of(std::string text) {
    if (text == "pi" || text == "π") return pi;
    if (text == "-pi" || text == "-π") return -pi;
    if (text == "2pi" || text == "2π") return 2.0 * pi;
    if (text.starts_with("+")) text.erase(0, 1);
    const auto number = base::number_from<double>(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

double after(double x, double towards) {
    return static_cast<double>(std::nextafter(static_cast<float>(x), static_cast<float>(towards)));
}

// Bytes. Patterns that begin with a repetition take the square of a text's length.
constexpr std::size_t longest_clause = 4000;

// What the rest of a sentence behind a parameter's name says.
std::optional<Meaning> meaning_of_words(const std::string& words, bool is_vector) {
    static const base::Pattern interval(R"(([\[(])\s*([-+\w.π]+)\s*,\s*([-+\w.π]+)\s*([\])]))");
    static const base::Pattern span(  // without brackets
        R"(()([-+]?[\d.]+(?:e-?\d+)?)\s*(?:to|\.\.+)\s*([-+]?[\d.]*\d(?:e-?\d+)?|pi|2pi)())");
    static const base::Pattern bound(R"(^\s*(>=|>|≥)\s*([-+]?[\d.]*\d(?:e-?\d+)?))");
    static const base::Pattern upward(R"(([-+]?[\d.]*\d)\s+and up)");
    static const base::Pattern unit(R"(\b(unit|normali[sz]ed|direction)\b)");
    if (words.size() > longest_clause) return std::nullopt;
    for (const base::Pattern* const form : {&interval, &span}) {
        const std::vector<std::string> m = form->first(words);
        if (m.empty()) continue;
        const auto low = number_of(m[2]);
        const auto high = number_of(m[3]);
        if (low && high && *low <= *high)
            return Meaning{Kind::range, m[1] == "(" ? after(*low, *high) : *low,
                           m[4] == ")" ? after(*high, *low) : *high};
    }
    std::vector<std::string> m = bound.first(words);
    if (m.empty()) m = upward.first(words);
    if (!m.empty()) {
        const bool open = m.size() > 2 && m[1] == ">";
        const double low = number_of(m.back()).value_or(0.0);
        return Meaning{Kind::range, open ? after(low, usual_high) : low, std::max(low * 2.0, usual_high)};
    }
    if (is_vector && !unit.first(words).empty()) return Meaning{Kind::unit, 0.0, 0.0};
    if (words.find("positive") != std::string::npos) return Meaning{Kind::positive, 0.0, 0.0};
    return std::nullopt;
}

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Where a whole word stands, from `from` on.
std::size_t find_word(std::string_view text, std::string_view word, std::size_t from) {
    for (std::size_t at = text.find(word, from); at != std::string_view::npos; at = text.find(word, at + 1))
        if ((at == 0 || !is_word(text[at - 1])) &&
            (at + word.size() >= text.size() || !is_word(text[at + word.size()])))
            return at;
    return std::string_view::npos;
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
    constexpr std::size_t most = 160;  // characters that belong to a name
    for (std::size_t at = find_word(comment, name, 0); at != std::string_view::npos;
         at = find_word(comment, name, at + 1)) {
        std::string_view rest = comment.substr(at + name.size(), most);
        std::size_t end = sentence_end(rest);
        for (const std::string& other : others)
            if (other != name) end = std::min(end, find_word(rest, other, 0));
        if (const auto meaning = meaning_of_words(base::lower(std::string(rest.substr(0, end))), is_vector))
            return meaning;
    }
    return std::nullopt;
}

}  // namespace gloam::audit::internal
