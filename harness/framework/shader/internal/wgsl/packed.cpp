// SPDX-License-Identifier: MIT
#include "shader/internal/translation.hpp"

#include <algorithm>

#include "shader/internal/compiler_process.hpp"
#include "shader/internal/declarations.hpp"
#include "shader/internal/front_end.hpp"
#include "shader/internal/outline.hpp"
#include "shader/wgsl.hpp"

namespace gloam::shader::internal::wgsl {
namespace {

// Whole lines.
std::string lines_of(const std::string& comment) {
    return comment.empty() || comment.ends_with('\n') ? comment : comment + "\n";
}

std::string comment_of(const Comments& comments, const std::string& block, const std::string& name) {
    if (!block.empty()) return lines_of(comments.behind(block, name));
    return lines_of(comments.above(name)) + lines_of(comments.behind("", name));
}

std::string comment_above(const Comments& comments, const shader::Function& function) {
    Piece piece;
    piece.names = {function.name};
    for (const Parameter& parameter : function.parameters) {
        const shader::Type& type = parameter.type;
        piece.parameter_types.push_back(type.name.empty() ? to_glsl(type) : type.name);
        piece.parameter_types.push_back(parameter.name);
    }
    return lines_of(comments.above_function(piece));
}

// The functions alone.
std::string module_of_functions(const Source& packed, WgslOptions options) {
    const std::string text = preprocessed(packed, Stage::compute, {});
    const Source whole{packed.name, completed(text, declarations(text))};
    options.entry_point = false;
    return to_wgsl(to_spirv(whole, Stage::compute, {}, {.unreached = Unreached::kept}), options);
}

}  // namespace

std::string packed_text(const Source& packed, Stage stage) {
    const CompileOptions compiled{.stage = stage};
    const Outline glsl = outline(packed.text);
    const Comments comments(glsl);
    WgslOptions options{
        .functions = functions_here(packed, compiled),
        .comment_above =
            [&comments](const shader::Function& function) { return comment_above(comments, function); },
        .comment_of = [&comments](const std::string& block,
                                  const std::string& name) { return comment_of(comments, block, name); }};
    for (const std::string& licence : glsl.licences) options.head += licence + "\n";
    options.head += "// WGSL, translated from GLSL.\n";
    for (const std::string& head : glsl.heads) options.head += "\n" + head + "\n";
    options.head += "\n";
    const bool whole =
        std::ranges::any_of(options.functions, [](const shader::Function& f) { return f.name == "main"; });
    try {
        return whole ? to_wgsl(compile_here(packed, compiled), options)
                     : module_of_functions(packed, options);
    } catch (const NotTranslated& error) {
        throw NotTranslated(std::string("gloam does not translate to WGSL yet: ") + error.what());
    } catch (const WgslError& error) {
        throw WgslError(std::string("WGSL cannot express ") + error.what());
    }
}

}  // namespace gloam::shader::internal::wgsl
