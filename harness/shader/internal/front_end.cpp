// SPDX-License-Identifier: MIT
#include "shader/internal/front_end.hpp"

#include <glslang/Public/ResourceLimits.h>

#include <algorithm>
#include <sstream>

#include "shader/internal/includer.hpp"

namespace gloam::shader::internal {
namespace {

// glslang's process-wide tables, from first use to the end of the program.
class Process {
  public:
    Process() { glslang::InitializeProcess(); }
    ~Process() { glslang::FinalizeProcess(); }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
};

// Called before a shader is constructed, so that the process exists before any shader does.
EShLanguage language_of(Stage stage) {
    static const Process process;
    switch (stage) {
        case Stage::vertex:
            return EShLangVertex;
        case Stage::fragment:
            return EShLangFragment;
        case Stage::compute:
            break;
    }
    return EShLangCompute;
}

EShMessages messages_of(Client client) {
    return client == Client::vulkan ? static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules)
                                    : EShMsgDefault;
}

void set_client(glslang::TShader& shader, EShLanguage language) {
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
}

// "'#include' : reason for header name: x" reads better as its reason.
std::string tidied(std::string message) {
    constexpr std::string_view start = "'#include' : ";
    const auto at = message.find(start);
    const auto end = message.rfind(" for header name: ");
    if (at == std::string::npos || end == std::string::npos || end < at) return message;
    return message.substr(0, at) + message.substr(at + start.size(), end - at - start.size());
}

// Messages that say only that there were others.
bool is_summary(std::string_view message) {
    return message.ends_with("No code generated.") || message.ends_with("compilation terminated ") ||
           message.ends_with("compilation terminated");
}

}  // namespace

std::string error_lines(const std::string& log, const std::string& fallback) {
    constexpr std::string_view marks[] = {"ERROR: ", "INTERNAL ERROR: ", "UNIMPLEMENTED: "};
    std::vector<std::string> errors;
    std::istringstream stream(log);
    bool in_error = false;
    for (std::string line; std::getline(stream, line);) {
        const auto mark =
            std::find_if(std::begin(marks), std::end(marks), [&](auto m) { return line.starts_with(m); });
        const auto text = line.find_first_not_of(' ');
        if (mark != std::end(marks)) {
            const std::string message = tidied(line.substr(mark->size()));
            in_error = !is_summary(message);
            if (in_error)
                errors.push_back(message.starts_with("Linking ") ? fallback + ": " + message : message);
        } else if (in_error && text != std::string::npos && !line.starts_with("WARNING: ")) {
            errors.back() += " " + line.substr(text);  // the rest of a message of several lines
        } else {
            in_error = false;
        }
    }
    if (errors.empty()) return fallback + ": the compiler gave no reason";
    std::string text;
    for (std::string& error : errors) {
        error.erase(error.find_last_not_of(' ') + 1);
        text += (text.empty() ? "" : "\n") + error;
    }
    return text;
}

Parse::Parse(Stage stage, Client client, std::string name, std::vector<Source> pieces,
             const std::vector<std::filesystem::path>& roots)
    : language_(language_of(stage)),
      messages_(messages_of(client)),
      name_(std::move(name)),
      pieces_(std::move(pieces)),
      shader_(language_) {
    std::vector<const char*> texts;
    std::vector<int> lengths;
    std::vector<const char*> names;
    for (const Source& piece : pieces_) {
        texts.push_back(piece.text.c_str());
        lengths.push_back(static_cast<int>(piece.text.size()));
        names.push_back(piece.name.c_str());
    }
    shader_.setStringsWithLengthsAndNames(texts.data(), lengths.data(), names.data(),
                                          static_cast<int>(texts.size()));
    shader_.setPreamble("#extension GL_GOOGLE_include_directive : enable\n");
    if (client == Client::vulkan) set_client(shader_, language_);
    Includer includer(roots);
    constexpr int version_when_missing = 110;
    const bool accepted =
        shader_.parse(GetDefaultResources(), version_when_missing, false, messages_, includer);
    if (!accepted) throw CompileError(error_lines(shader_.getInfoLog(), name_));
}

const glslang::TIntermediate& Parse::link() {
    program_.addShader(&shader_);
    if (!program_.link(messages_)) throw CompileError(error_lines(program_.getInfoLog(), name_));
    return *program_.getIntermediate(language_);
}

}  // namespace gloam::shader::internal
