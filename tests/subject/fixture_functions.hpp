// SPDX-License-Identifier: MIT
#pragma once

#include "backend/gl/device.hpp"
#include "subject/own_function.hpp"
#include "support/lab.hpp"

#include "support/test.hpp"

// The functions of a file of the fixtures, and their answers on the shared device.
namespace gloam::test {

inline subject::LabOptions options_of(const std::string& file, const module::Variant& variant = {}) {
    return options_for(FIXTURES, file, variant);
}

inline subject::OwnFunction function_of(const std::string& file, const std::string& name) {
    return subject::own_functions(options_of(file), {name}).found.at(0);
}

inline std::string reason_of(const std::string& file, const std::string& name) {
    return subject::own_functions(options_of(file), {name}).left_out.at(0).why;
}

inline judge::Answer answer_of(const subject::Lab& lab, const std::string& file, const std::string& name,
                               const subject::Ranges& ranges = {}, std::size_t inputs = 512) {
    return run(lab, judge::question_of(lab, function_of(file, name), ranges), {.inputs = inputs});
}

inline judge::Answer answer_of(const std::string& file, const std::string& name,
                               const subject::Ranges& ranges = {}) {
    return answer_of(subject::Lab(options_of(file), SharedDevice::get()), file, name, ranges);
}

// The question of a function of the fixtures with a reference.
template <class Type, class Reference>
judge::Question question_with(const char* file, const char* function, const subject::Domain& domain,
                              Reference reference, const judge::Budget& budget = {}) {
    return {.file = file,
            .function = function,
            .signature = subject::SignatureOf<Type>::describe(),
            .domain = domain,
            .reference = judge::make_reference<Type>(reference),
            .budget = budget};
}

// What `weight` of wrong.glsl is.
inline double exact_weight(double distance, double radius) {
    if (!(std::abs(distance) < radius)) return 0.0;
    return 1.0 - distance / radius * (distance / radius);
}

// Null where this machine has none.
inline std::shared_ptr<backend::Backend> opengl_device(const std::string& name) {
    try {
        return std::make_shared<backend::gl::Device>(name);
    } catch (const backend::gl::Unavailable& error) {
        std::cerr << error.what() << '\n';
        return nullptr;
    }
}

}  // namespace gloam::test
