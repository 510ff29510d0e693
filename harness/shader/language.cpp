// SPDX-License-Identifier: MIT
#include "shader/language.hpp"

#include <array>

#include "shader/internal/front_end.hpp"

namespace gloam::shader {
namespace {

// The default of sampler2D is lowp: depths would lose most of their bits.
constexpr const char* es_precisions =
    "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";

struct Entry {
    Language language;
    const char* name;
    const char* version;
    bool es;
    Stage stage;
    internal::Client client;
};

constexpr std::array entries{
    Entry{Language::vulkan450, "450", "450", false, Stage::compute, internal::Client::vulkan},
    Entry{Language::gl330, "330", "330 core", false, Stage::fragment, internal::Client::none},
    Entry{Language::es300, "300es", "300 es", true, Stage::fragment, internal::Client::none},
    Entry{Language::es310, "310es", "310 es", true, Stage::compute, internal::Client::none},
    Entry{Language::es320, "320es", "320 es", true, Stage::compute, internal::Client::none},
};

const Entry& entry_of(Language language) {
    for (const Entry& entry : entries)
        if (entry.language == language) return entry;
    throw std::invalid_argument("language " + std::to_string(static_cast<int>(language)) +
                                ": not one of 450, 330, 300es, 310es, 320es");
}

// The pieces keep their own line numbers; the last may end without a newline, in a comment.
void check_pieces(const Entry& entry, Stage stage, std::vector<Source> pieces, bool add_main,
                  const std::vector<std::filesystem::path>& include_roots) {
    const std::string name = pieces.back().name;
    const std::string local_size = stage == Stage::compute ? "layout(local_size_x = 1) in;\n" : "";
    if (add_main) pieces.push_back({"main", "\n" + local_size + "void main() {}\n"});
    internal::Parse parse(stage, entry.client, name, std::move(pieces), include_roots);
    static_cast<void>(parse.link(internal::Unreached::dropped));
}

}  // namespace

namespace internal {

Client client_of(Language language) {
    return entry_of(language).client;
}

}  // namespace internal

std::optional<Language> language_from(std::string_view name) {
    for (const Entry& entry : entries)
        if (name == entry.name) return entry.language;
    return std::nullopt;
}

std::string to_string(Language language) {
    return entry_of(language).name;
}

std::string preamble(Language language) {
    const Entry& entry = entry_of(language);
    return "#version " + std::string(entry.version) + "\n" + (entry.es ? es_precisions : "");
}

Stage usual_stage(Language language) {
    return entry_of(language).stage;
}

void check_program(const Source& text, bool add_main, Language language, Stage stage) {
    check_pieces(entry_of(language), stage, {text}, add_main, {});
}

void check_compiles(const Source& body, Language language,
                    const std::vector<std::filesystem::path>& include_roots) {
    const Entry& entry = entry_of(language);
    // The compiler looks for includes beside the first piece.
    check_pieces(entry, entry.stage, {{body.name, preamble(language)}, body}, true, include_roots);
}

}  // namespace gloam::shader
