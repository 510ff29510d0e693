// SPDX-License-Identifier: MIT
#include <glslang/MachineIndependent/localintermediate.h>

#include <algorithm>
#include <set>

#include "shader/compile.hpp"
#include "shader/internal/front_end.hpp"
#include "shader/internal/version_line.hpp"

namespace gloam::shader {
namespace {

using Text = std::basic_string_view<char>;

Text view(const glslang::TString& text) {
    return {text.data(), text.size()};
}

Scalar scalar_of(glslang::TBasicType type) {
    switch (type) {
        case glslang::EbtVoid:
            return Scalar::void_;
        case glslang::EbtBool:
            return Scalar::bool_;
        case glslang::EbtInt:
            return Scalar::int_;
        case glslang::EbtUint:
            return Scalar::uint_;
        case glslang::EbtFloat:
            return Scalar::float_;
        case glslang::EbtStruct:
            return Scalar::structure;
        default:
            return Scalar::unsupported;
    }
}

Type type_of(const glslang::TType& type);

std::string array_sizes(const glslang::TType& type) {
    std::string text;
    for (int i = 0; i < type.getArraySizes()->getNumDims(); ++i) {
        const unsigned size = type.getArraySizes()->getDimSize(i);
        text.append("[").append(size == 0 ? "" : std::to_string(size)).append("]");
    }
    return text;
}

std::string unsupported_text(const glslang::TType& type) {
    if (type.isArray()) {
        glslang::TType element;
        element.shallowCopy(type);
        element.clearArraySizes();
        const Type plain = type_of(element);
        return (plain.scalar == Scalar::structure ? plain.name : to_glsl(plain)) + array_sizes(type);
    }
    if (type.getBasicType() == glslang::EbtSampler) return std::string(view(type.getSampler().getString()));
    const glslang::TString text = type.getCompleteString(true, false, false);
    return std::string(view(text).substr(std::min(text.find_first_not_of(' '), text.size())));
}

Type type_of(const glslang::TType& type) {
    Type result;
    result.scalar = type.isArray() ? Scalar::unsupported : scalar_of(type.getBasicType());
    if (result.scalar == Scalar::unsupported) {
        result.name = unsupported_text(type);
    } else if (result.scalar == Scalar::structure) {
        result.name = view(type.getTypeName());
        for (const glslang::TTypeLoc& member : *type.getStruct())
            result.members.push_back({std::string(view(member.type->getFieldName())), type_of(*member.type)});
    } else if (type.isMatrix()) {
        result.columns = type.getMatrixCols();
        result.rows = type.getMatrixRows();
    } else {
        result.rows = type.getVectorSize();
    }
    return result;
}

Direction direction_of(glslang::TStorageQualifier storage) {
    if (storage == glslang::EvqOut) return Direction::out;
    if (storage == glslang::EvqInOut) return Direction::inout;
    return Direction::in;
}

// The compiler's key of an overload is "name(types;".
std::string plain_name(Text key) {
    return std::string(key.substr(0, key.find('(')));
}

// Finds the nodes of definitions and of calls, in the order of the text.
class Collector final : public glslang::TIntermTraverser {
  public:
    bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
        if (node->getOp() == glslang::EOpFunction) define(*node);
        if (node->getOp() == glslang::EOpFunctionCall && node->isUserDefined()) call(*node);
        return true;
    }

    std::vector<Function> take() {
        std::vector<Function> functions;
        for (auto& [key, function] : found_)
            if (function.defined || !defined_.contains(key)) functions.push_back(std::move(function));
        return functions;
    }

  private:
    void define(const glslang::TIntermAggregate& node) {
        Function function{plain_name(view(node.getName())), type_of(node.getType()), {}, true};
        for (const TIntermNode* parameter : node.getSequence().front()->getAsAggregate()->getSequence()) {
            const glslang::TIntermSymbol& symbol = *parameter->getAsSymbolNode();
            function.parameters.push_back({std::string(view(symbol.getName())), type_of(symbol.getType()),
                                           direction_of(symbol.getType().getQualifier().storage)});
        }
        std::string key(view(node.getName()));
        defined_.insert(key);
        found_.emplace_back(std::move(key), std::move(function));
    }

    // The front end has already converted every argument to the type of its parameter.
    void call(const glslang::TIntermAggregate& node) {
        std::string key(view(node.getName()));
        if (!called_.insert(key).second) return;
        Function function{plain_name(key), type_of(node.getType()), {}, false};
        const auto& directions = node.getQualifierList();
        for (std::size_t i = 0; i < node.getSequence().size(); ++i)
            function.parameters.push_back({{},
                                           type_of(node.getSequence()[i]->getAsTyped()->getType()),
                                           direction_of(directions.at(i))});
        found_.emplace_back(std::move(key), std::move(function));
    }

    std::vector<std::pair<std::string, Function>> found_;
    std::set<std::string> defined_;
    std::set<std::string> called_;
};

}  // namespace

std::vector<Function> functions(const Source& source, const CompileOptions& options) {
    internal::require_vulkan_version(source);
    const internal::Parse parse(options.stage, internal::Client::vulkan, source.name, {source},
                                options.include_roots);
    Collector collector;
    if (TIntermNode* root = parse.tree().getTreeRoot()) root->traverse(&collector);
    return collector.take();
}

}  // namespace gloam::shader
