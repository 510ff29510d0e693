// SPDX-License-Identifier: MIT
#include "module/texts.hpp"

#include <set>
#include <stdexcept>
#include <utility>

#include "base/pattern.hpp"
#include "module/include.hpp"
#include "module/internal/front_end.hpp"

namespace gloam::module {
namespace {

// The pieces keep their own line numbers; the last may end without a newline, in a comment.
void check_pieces(source::Language language, source::Stage stage, std::vector<source::Source> pieces,
                  bool add_main, const std::vector<std::filesystem::path>& roots) {
    const std::string name = pieces.back().name;
    const std::string local_size = stage == source::Stage::compute ? "layout(local_size_x = 1) in;\n" : "";
    if (add_main) pieces.push_back({name + ", behind its end", "\n" + local_size + "void main() {}\n"});
    internal::check(stage, internal::client_of(language), name, pieces, roots, internal::Check::program);
}

// The same of each text as it is names its own lines, and those of what it includes.
void check_as_it_is(const source::Source& source, source::Language language,
                    const std::vector<std::filesystem::path>& roots) {
    std::string text;
    for (const source::Line& line : source::split_lines(source.text)) {
        const auto directive = source::directive_of(line);
        const bool version = directive && directive->keyword == "version";
        text += version ? std::string("\n") : std::string(line.text);
    }
    check_compiles({source.name, text}, language, roots);
}

// A text that stands before others; none without definitions.
std::vector<source::Source> before_all(const std::vector<std::string>& defines) {
    if (defines.empty()) return {};
    return {{.name = "--define", .text = definitions_of(defines)}};
}

}  // namespace

std::string pack(const std::vector<source::Source>& sources, const source::PackRequest& request,
                 const std::vector<std::filesystem::path>& roots) {
    const source::Stage stage = request.stage.value_or(usual_stage(request.language));
    const std::string name = sources.empty() ? "nothing" : sources.back().name;
    source::Packed result;
    try {
        result = packed(internal::active_text(sources, request.language, stage, roots), request);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(name + ": " + error.what());
    }
    try {
        check_pieces(request.language, stage, {{name + " as packed", result.text}}, !result.main, {});
    } catch (const source::CompileError&) {
        if (!result.main)
            for (const source::Source& source : sources) check_as_it_is(source, request.language, roots);
        throw;
    }
    return result.text;
}

std::string definitions_of(const std::vector<std::string>& defines) {
    static const base::Pattern form(R"(^[A-Za-z_]\w*(=[^\n]*)?$)");
    std::string lines;
    for (std::string one : defines) {
        if (form.first(one).empty())
            throw std::invalid_argument("--define " + one + ": expected NAME or NAME=VALUE");
        if (const std::size_t equals = one.find('='); equals != std::string::npos) one[equals] = ' ';
        lines += "#define " + one + "\n";
    }
    return lines;
}

source::Excerpts excerpts(const source::Source& source, const std::vector<std::filesystem::path>& roots,
                          const std::vector<std::string>& defines) {
    std::vector<source::Source> texts = before_all(defines);
    texts.push_back(source);
    return source::excerpts(
        internal::active_text(texts, source::Language::vulkan450, source::Stage::compute, roots));
}

std::vector<source::Mutation> mutations(const source::Source& source,
                                        const std::vector<std::filesystem::path>& roots) {
    return source::mutations(
        internal::active_text({source}, source::Language::vulkan450, source::Stage::compute, roots));
}

void check_compiles(const source::Source& body, source::Language language,
                    const std::vector<std::filesystem::path>& roots) {
    // The compiler looks for includes beside the first piece.
    check_pieces(language, usual_stage(language), {{body.name, preamble(language)}, body}, true, roots);
}

// Throws what the first stage says.
void require_valid(const source::Source& source, const std::vector<std::filesystem::path>& roots) {
    using internal::Client;
    std::vector<source::Source> pieces{source};
    if (source.text.find("#version") == std::string::npos)
        pieces.insert(pieces.begin(), {.name = source.name, .text = preamble(source::Language::vulkan450)});
    std::string why;
    for (const Client client : {Client::vulkan, Client::none}) {
        for (const source::Stage stage :
             {source::Stage::compute, source::Stage::fragment, source::Stage::vertex}) {
            try {
                internal::check(stage, client, source.name, pieces, roots);
                return;
            } catch (const source::CompileError& error) {
                if (why.empty()) why = error.what();
            }
        }
    }
    throw source::CompileError(why.substr(0, why.find('\n')));
}

std::string pack(const std::vector<std::filesystem::path>& files, const source::PackRequest& request,
                 const std::vector<std::filesystem::path>& roots, const std::vector<std::string>& defines) {
    std::vector<source::Source> sources = before_all(defines);
    std::set<std::string> names;
    for (const std::filesystem::path& file : files) {
        const std::string name = std::filesystem::absolute(file).lexically_normal().string();
        if (names.insert(name).second) sources.push_back({name, read_text(file)});
    }
    return pack(sources, request, roots);
}

}  // namespace gloam::module
