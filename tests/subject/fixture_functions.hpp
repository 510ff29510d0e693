// SPDX-License-Identifier: MIT
#pragma once

#include "backend/gl/device.hpp"
#include "subject/own_function.hpp"
#include "support/lab.hpp"

#include "support/test.hpp"

// The functions of a file of the fixtures, and their answers on the shared device.
namespace gloam::test {

// As `gloam check FILE` takes them.
inline subject::LabOptions options_of(const std::string& name, const module::Variant& variant = {}) {
    const std::filesystem::path fixtures = FIXTURES;
    return {.device = variable("GLOAM_TEST_DEVICE"),
            .cache_directory = cache_directory(),
            .variant = variant,
            .file = std::make_shared<const subject::OwnFile>(
                fixtures / name, module::read_text(fixtures / name), std::vector{fixtures})};
}

inline subject::OwnFunction function_of(const std::string& file, const std::string& name) {
    return subject::own_functions(options_of(file), {name}).found.at(0);
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

}  // namespace gloam::test
