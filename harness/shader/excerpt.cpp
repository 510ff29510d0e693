// SPDX-License-Identifier: MIT
#include "shader/excerpt.hpp"

#include <algorithm>

#include "shader/internal/active_text.hpp"
#include "shader/internal/compiler_process.hpp"
#include "shader/internal/declarations.hpp"
#include "shader/internal/lines.hpp"
#include "shader/internal/outline.hpp"
#include "shader/internal/selection.hpp"

namespace gloam::shader {
namespace {

using internal::ActiveText;
using internal::Declaration;
using internal::Outline;
using internal::Piece;
using Kind = Piece::Kind;

constexpr std::size_t given = 1;  // files

std::string version_of(const ActiveText& text) {
    for (const internal::Line& line : text.files.front().lines) {
        const auto directive = internal::directive_of(line);
        if (directive && directive->keyword == "version") return directive->argument;
    }
    return {};
}

// "f(vec2, float)"
std::string definition_of(const Piece& piece) {
    std::string parameters;
    for (const Declaration& declaration : internal::declarations(piece.text)) {
        for (const internal::DeclaredParameter& parameter : declaration.parameters)
            parameters += (parameters.empty() ? "" : ", ") + parameter.type;
    }
    return piece.names.front() + "(" + parameters + ")";
}

bool defines(const Piece& piece, const std::string& function) {
    return piece.kind == Kind::function && piece.names.front() == function;
}

// Bindings, stage inputs and outputs; a specialization constant is a constant like others.
bool is_interface(const Piece& piece) {
    return piece.kind == Kind::interface && piece.text.find("constant_id") == std::string::npos;
}

Excerpt excerpt_of(const std::string& function, const ActiveText& active, const Outline& outline) {
    internal::Selection selection(outline, given);
    selection.want({function});
    Excerpt excerpt{.function = function, .text = {}, .interface = {}, .definitions = {}};
    for (const std::string& extension : outline.extensions) excerpt.text += extension + "\n";
    for (std::size_t i = 0; i < outline.pieces.size(); ++i) {
        const Piece& piece = outline.pieces[i];
        if (!selection.keeps(i) || piece.kind == Kind::comment || defines(piece, "main")) continue;
        if (is_interface(piece)) {
            excerpt.interface.insert(piece.names.begin(), piece.names.end());
            continue;
        }
        excerpt.text +=
            internal::line_directive(piece.line, active.files[piece.file].name) + piece.text + "\n";
        if (defines(piece, function))
            excerpt.definitions.push_back(piece.file < given ? definition_of(piece) : "");
    }
    return excerpt;
}

}  // namespace

Excerpts internal::excerpts_here(const Source& source, const std::vector<std::filesystem::path>& roots) {
    const ActiveText active = internal::active_text({source}, Language::vulkan450, Stage::compute, roots);
    const Outline outline = internal::outline(active, internal::Keep::line_numbers);
    Excerpts all{.version = version_of(active), .functions = {}};
    for (const Piece& piece : outline.pieces) {
        if (piece.kind != Kind::function || piece.file >= given || defines(piece, "main")) continue;
        const std::string& name = piece.names.front();
        if (std::ranges::find(all.functions, name, &Excerpt::function) == all.functions.end())
            all.functions.push_back(excerpt_of(name, active, outline));
    }
    return all;
}

}  // namespace gloam::shader
