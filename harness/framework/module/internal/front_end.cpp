// SPDX-License-Identifier: MIT
#include "module/internal/front_end.hpp"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <algorithm>
#include <sstream>
#include <string_view>

#include "base/text.hpp"

namespace gloam::module::internal {
namespace {

// The text behind the mark of an error; nullopt for another line.
std::optional<std::string> error_of(const std::string& line) {
    for (const std::string_view mark : {"ERROR: ", "INTERNAL ERROR: ", "UNIMPLEMENTED: "})
        if (line.starts_with(mark)) return line.substr(mark.size());
    return std::nullopt;
}

// Whether the message only counts the errors.
bool is_summary(const std::string& message) {
    return message.find("No code generated.") != std::string::npos ||
           message.find("compilation terminated") != std::string::npos;
}

// Replaces "'#include' : reason for header name: x" by its reason.
std::string without_include_token(std::string message) {
    constexpr std::string_view token = "'#include' : ";
    const auto begin = message.find(token);
    const auto end = message.rfind(" for header name: ");
    if (begin == std::string::npos || end == std::string::npos || end < begin) return message;
    return message.erase(end).erase(begin, token.size());
}

// Replaces the compiler's key of an overload, "f(vi2;f1;" or "g(", by "f()".
std::string without_keys(std::string message) {
    constexpr std::string_view key_letters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-[];";
    for (auto at = message.find('('); at != std::string::npos; at = message.find('(', at + 1)) {
        const auto end = std::min(message.find_first_not_of(key_letters, at + 1), message.size());
        const bool closes = end < message.size() && message[end] == ')';
        if (!closes && (end == at + 1 || message[end - 1] == ';'))
            message.erase(at + 1, end - at - 1).insert(at + 1, 1, ')');
    }
    return message;
}

std::string tidied(const std::string& message) {
    std::string text = without_include_token(message);
    if (text.find("Linking ") != std::string::npos) text = without_keys(text);
    const auto two_blanks = [](char a, char b) { return a == ' ' && b == ' '; };
    text.erase(std::unique(text.begin(), text.end(), two_blanks), text.end());
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
}

// Has the ":line: " that follows a file.
bool has_place(std::string_view message) {
    for (auto at = message.find(':'); at != std::string_view::npos; at = message.find(':', at + 1)) {
        const auto end = message.find_first_not_of("0123456789", at + 1);
        if (end != std::string_view::npos && end > at + 1 && message.substr(end, 2) == ": ") return true;
    }
    return false;
}

constexpr const char* preamble = "#extension GL_GOOGLE_include_directive : enable\n";
constexpr int version_when_missing = 110;

// glslang's process-wide tables, from the first use to the end of the program.
class Process {
  public:
    Process() { glslang::InitializeProcess(); }
    ~Process() { glslang::FinalizeProcess(); }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
};

// Called before a shader is constructed, so that Process exists before any shader.
EShLanguage language_of(source::Stage stage) {
    static const Process process;
    if (stage == source::Stage::vertex) return EShLangVertex;
    return stage == source::Stage::fragment ? EShLangFragment : EShLangCompute;
}

// With this flag glslang does not add a spurious syntax error after the first real one.
EShMessages messages_of(Client client) {
    unsigned rules = EShMsgCascadingErrors;
    if (client != Client::none) rules |= unsigned{EShMsgSpvRules} | unsigned{EShMsgVulkanRules};
    return static_cast<EShMessages>(rules);
}

void set_client(glslang::TShader& shader, EShLanguage language) {
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
}

// The errors of glslang's log as "file:line: message" lines. `file`: for messages without a place.
std::string error_lines(const std::string& log, const std::string& file) {
    std::vector<std::string> errors;
    bool in_error = false;
    std::istringstream stream(log);
    for (std::string line; std::getline(stream, line);) {
        if (const auto error = error_of(line)) {
            in_error = !is_summary(*error);
            if (in_error) errors.push_back(*error);
        } else if (in_error && line.starts_with(' ')) {
            errors.back() += line;  // the rest of a message of several lines
        } else {
            in_error = false;
        }
    }
    if (errors.empty()) return file + ": the compiler gave no reason";
    std::string text;
    for (const std::string& error : errors) {
        if (!text.empty()) text += "\n";
        if (!has_place(error)) text.append(file).append(": ");
        text += tidied(error);
    }
    return base::for_terminal(text);  // it quotes the shader
}

}  // namespace

Strings::Strings(const std::vector<source::Source>& pieces) {
    for (const source::Source& piece : pieces) {
        texts_.push_back(piece.text.c_str());
        lengths_.push_back(static_cast<int>(piece.text.size()));
        shown_.push_back(base::one_line(piece.name));  // a message ends with its line
    }
    for (const std::string& name : shown_) names_.push_back(name.c_str());
}

void Strings::give_to(glslang::TShader& shader) const {
    shader.setStringsWithLengthsAndNames(texts_.data(), lengths_.data(), names_.data(),
                                         static_cast<int>(texts_.size()));
}

Parse::Parse(source::Stage stage, Client client, std::string name, std::vector<source::Source> pieces,
             const std::vector<std::filesystem::path>& roots)
    : language_(language_of(stage)),
      messages_(messages_of(client)),
      name_(std::move(name)),
      pieces_(std::move(pieces)),
      strings_(pieces_),
      shader_(language_) {
    strings_.give_to(shader_);
    shader_.setPreamble(preamble);
    if (client != Client::none) set_client(shader_, language_);
    Includer includer(include_folders(roots, pieces_));
    const bool accepted =
        shader_.parse(GetDefaultResources(), version_when_missing, false, messages_, includer);
    if (!accepted) throw source::CompileError(error_lines(shader_.getInfoLog(), name_));
}

const glslang::TIntermediate& Parse::link(Unreached unreached) {
    program_.addShader(&shader_);
    const EShMessages more = unreached == Unreached::kept ? EShMsgKeepUncalled : EShMsgDefault;
    if (!program_.link(static_cast<EShMessages>(messages_ | more)))
        throw source::CompileError(error_lines(program_.getInfoLog(), name_));
    return *program_.getIntermediate(language_);
}

std::string preprocessed(const source::Source& source, source::Stage stage,
                         const std::vector<std::filesystem::path>& roots) {
    Includer includer(include_folders(roots, {source}));
    return preprocessed(std::vector<source::Source>{source}, stage, Client::vulkan, includer);
}

std::string preprocessed(const std::vector<source::Source>& pieces, source::Stage stage, Client client,
                         glslang::TShader::Includer& includer) {
    const EShLanguage language = language_of(stage);
    glslang::TShader shader(language);
    const Strings strings(pieces);
    strings.give_to(shader);
    shader.setPreamble(preamble);
    if (client != Client::none) set_client(shader, language);
    std::string result;
    if (!shader.preprocess(GetDefaultResources(), version_when_missing, ENoProfile, false, false,
                           messages_of(client), &result, includer))
        throw source::CompileError(error_lines(shader.getInfoLog(), pieces.front().name));
    // The preprocessor also prints the preamble, before the line that must be the first.
    return result.substr(std::min(result.find("#version"), result.size()));
}

Spirv to_spirv(const source::Source& source, source::Stage stage,
               const std::vector<std::filesystem::path>& roots, Unreached unreached, bool lines) {
    Parse parse(stage, Client::vulkan, source.name, {source}, roots);
    Spirv module;
    spv::SpvBuildLogger logger;
    glslang::SpvOptions options;
    options.generateDebugInfo = lines;
    options.disableOptimizer = true;  // ours runs after it, with the passes that the caller chose
    glslang::GlslangToSpv(parse.link(unreached), module, &logger, &options);
    const std::string messages = logger.getAllMessages();
    for (const char* failure : {"error: ", "Missing functionality: "})
        if (messages.find(failure) != std::string::npos)
            throw source::CompileError(source.name + ": " + messages);
    return module;
}

}  // namespace gloam::module::internal
