// SPDX-License-Identifier: MIT
#include "module/texts.hpp"

#include <set>
#include <stdexcept>
#include <utility>

#include "module/include.hpp"
#include "module/internal/front_end.hpp"

namespace gloam::shader {
namespace {

// The same of each text as it is names its own lines, and those of what it includes.
void check_as_it_is(const Source& source, Language language,
                    const std::vector<std::filesystem::path>& roots) {
    std::string text;
    for (const internal::Line& line : internal::split_lines(source.text)) {
        const auto directive = internal::directive_of(line);
        const bool version = directive && directive->keyword == "version";
        text += version ? std::string("\n") : std::string(line.text);
    }
    check_compiles({source.name, text}, language, roots);
}

}  // namespace

std::string pack(const std::vector<Source>& sources, const PackRequest& request,
                 const std::vector<std::filesystem::path>& roots) {
    const Stage stage = request.stage.value_or(usual_stage(request.language));
    const std::string name = sources.empty() ? "nothing" : sources.back().name;
    Packed result;
    try {
        result = packed(internal::active_text(sources, request.language, stage, roots), request);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(name + ": " + error.what());
    }
    try {
        check_program({name + " as packed", result.text}, !result.main, request.language, stage);
    } catch (const CompileError&) {
        if (!result.main)
            for (const Source& source : sources) check_as_it_is(source, request.language, roots);
        throw;
    }
    return result.text;
}

Excerpts excerpts(const Source& source, const std::vector<std::filesystem::path>& roots) {
    return excerpts(internal::active_text({source}, Language::vulkan450, Stage::compute, roots));
}

std::vector<Mutation> mutations(const Source& source, const std::vector<std::filesystem::path>& roots) {
    return mutations(internal::active_text({source}, Language::vulkan450, Stage::compute, roots));
}

// Throws what the first stage says.
void require_valid(const Source& source, const std::vector<std::filesystem::path>& roots) {
    using internal::Client;
    std::vector<Source> pieces{source};
    if (source.text.find("#version") == std::string::npos)
        pieces.insert(pieces.begin(), {.name = source.name, .text = preamble(Language::vulkan450)});
    std::string why;
    for (const Client client : {Client::vulkan, Client::none}) {
        for (const Stage stage : {Stage::compute, Stage::fragment, Stage::vertex}) {
            try {
                const internal::Parse parse(stage, client, source.name, pieces, roots);
                return;
            } catch (const CompileError& error) {
                if (why.empty()) why = error.what();
            }
        }
    }
    throw CompileError(why.substr(0, why.find('\n')));
}

std::string pack(const std::vector<std::filesystem::path>& files, const PackRequest& request,
                 const std::vector<std::filesystem::path>& roots) {
    std::vector<Source> sources;
    std::set<std::string> names;
    for (const std::filesystem::path& file : files) {
        const std::string name = std::filesystem::absolute(file).lexically_normal().string();
        if (names.insert(name).second) sources.push_back({name, read_text(file)});
    }
    return pack(sources, request, roots);
}

}  // namespace gloam::shader
