// SPDX-License-Identifier: MIT
// The functions of one GLSL file for Python, as words; python/gloam/__init__.py makes numpy arrays of them.
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "audit/audit.hpp"
#include "audit/own_domain.hpp"
#include "base/version.hpp"
#include "judge/explain.hpp"
#include "judge/run.hpp"
#include "module/include.hpp"
#include "subject/own_function.hpp"

namespace py = pybind11;

namespace gloam::python {
namespace {

using subject::Word;
using Words = py::array_t<Word, py::array::c_style | py::array::forcecast>;
using RangeOf = std::map<std::string, std::pair<double, double>>;

// A parameter or an output: numpy's type of its scalars, and the shape of one value.
struct Variable {
    std::string name;
    std::string glsl;
    std::string dtype;
    std::vector<std::size_t> shape;
    bool is_input = false;
};

std::string dtype_of(const module::Type& type) {
    if (type.scalar == module::Scalar::bool_) return "bool";
    if (type.scalar == module::Scalar::structure) return "words";  // its scalars may differ
    if (module::is_float(type.scalar)) return "float" + std::to_string(module::bits_of(type.scalar));
    return type.scalar == module::Scalar::int_ ? "int32" : "uint32";
}

Variable variable_of(const std::string& name, const module::Type& type, bool is_input) {
    Variable all{.name = name, .glsl = module::to_glsl(type), .dtype = dtype_of(type), .is_input = is_input};
    if (all.dtype == "words") {
        all.shape = {subject::scalars_of(type).size()};
        return all;
    }
    all.shape.assign(type.sizes.begin(), type.sizes.end());
    if (type.columns > 1) all.shape.push_back(static_cast<std::size_t>(type.columns));
    if (type.rows > 1) all.shape.push_back(static_cast<std::size_t>(type.rows));
    return all;
}

struct RunSettings {
    std::size_t inputs;
    std::uint64_t seed;
};

// A function of a file, compiled.
class Function {
  public:
    Function(std::shared_ptr<const subject::Lab> lab, subject::OwnFunction own)
        : lab_(std::move(lab)),
          own_(std::move(own)),
          kernel_(lab_->kernel(own_.file, own_.function.name, question({}).signature)) {}

    [[nodiscard]] std::string declaration() const { return module::to_glsl(own_.function); }

    // The inputs in order, then the outputs in order.
    [[nodiscard]] std::vector<Variable> variables() const {
        std::vector<Variable> inputs;
        std::vector<Variable> outputs;
        if (own_.function.result.scalar != module::Scalar::void_)
            outputs.push_back(variable_of("result", own_.function.result, false));
        for (const module::Parameter& p : own_.function.parameters) {
            if (p.type.scalar == module::Scalar::sampler) continue;
            if (p.direction != source::Direction::out) inputs.push_back(variable_of(p.name, p.type, true));
            if (p.direction != source::Direction::in) outputs.push_back(variable_of(p.name, p.type, false));
        }
        inputs.insert(inputs.end(), outputs.begin(), outputs.end());
        return inputs;
    }

    // A row of words for each input.
    [[nodiscard]] Words run(const Words& inputs) const {
        if (inputs.ndim() != 2 || static_cast<std::size_t>(inputs.shape(1)) != kernel_.input_words())
            throw std::invalid_argument(declaration() + ": expected rows of " +
                                        std::to_string(kernel_.input_words()) + " words");
        const auto count = static_cast<std::size_t>(inputs.shape(0));
        const std::span<const Word> words(inputs.data(), count * kernel_.input_words());
        subject::KernelCore::Result result;
        {
            const py::gil_scoped_release others;
            result = kernel_.run(words, count, images());
            lab_->require_silent_validation();
        }
        Words outputs({count, kernel_.output_words()});
        std::ranges::copy(result.outputs, outputs.mutable_data());
        return outputs;
    }

    // `reference`: from the words of an input to the outputs as numbers; none: Vulkan's rules judge.
    [[nodiscard]] judge::Answer judge(
        const RangeOf& ranges, const RunSettings& run, const judge::Budget& budget,
        const std::function<std::vector<double>(std::vector<Word>)>& reference) const {
        judge::Question asked = question(ranges);
        asked.budget = budget;
        if (reference)
            asked.reference = [&reference](const subject::ImageSet&, std::span<const Word> words,
                                           std::vector<double>& outputs) {
                const py::gil_scoped_acquire python;
                try {
                    outputs = reference({words.begin(), words.end()});
                } catch (const py::error_already_set& error) {
                    throw std::runtime_error(std::string("the reference failed: ") + error.what());
                }
            };
        const py::gil_scoped_release others;
        return judge::run(*lab_, asked, {.inputs = run.inputs, .seed = run.seed});
    }

    [[nodiscard]] std::string audit(const RangeOf& ranges, const RunSettings& run) const {
        const py::gil_scoped_release others;
        return audit::to_text(
            audit::audit(*lab_, own_, ranges_from(ranges), {.inputs = run.inputs, .seed = run.seed}));
    }

    [[nodiscard]] std::string explain(const std::vector<Word>& words, std::size_t most) const {
        return judge::to_text(
            judge::explain(lab_->compile_options(), *kernel_.module().source, words, images()), most);
    }

    // The values that its parameters have where no range is given: "x: 0 to 1 (comment)".
    [[nodiscard]] std::vector<std::string> domain(const RangeOf& ranges) const {
        std::vector<std::string> lines;
        for (const audit::OrdinaryValues& one : ordinary(ranges))
            lines.push_back(one.parameter + ": " + one.text + " (" + one.reason + ")");
        return lines;
    }

  private:
    [[nodiscard]] subject::Ranges ranges_from(const RangeOf& ranges) const {
        subject::Ranges all;
        for (const auto& [name, range] : ranges) {
            if (std::ranges::find(own_.function.parameters, name, &module::Parameter::name) ==
                own_.function.parameters.end())
                throw std::invalid_argument(declaration() + ": a range for \"" + name +
                                            "\", which is no input");
            all[name] = {range.first, range.second};
            if (!all[name].is_valid())
                throw std::invalid_argument("the range of " + name + ": expected finite floats (LOW, HIGH)");
        }
        return all;
    }
    [[nodiscard]] std::vector<audit::OrdinaryValues> ordinary(const RangeOf& ranges) const {
        return audit::ordinary_values(own_, ranges_from(ranges));
    }
    [[nodiscard]] judge::Question question(const RangeOf& ranges) const {
        judge::Question asked = judge::question_of(*lab_, own_, ranges_from(ranges));
        asked.domain = audit::ordinary_domain(own_.function, ordinary(ranges));
        return asked;
    }
    // Random content for samplers and prototypes, always the same.
    [[nodiscard]] subject::ImageSet images() const {
        const std::vector<subject::ImageScenario> scenarios = question({}).scenarios;
        if (scenarios.empty()) return {};
        numeric::Random random(1);
        return scenarios.front().make(scenarios.front().size, random);
    }

    std::shared_ptr<const subject::Lab> lab_;
    subject::OwnFunction own_;
    subject::KernelCore kernel_;
};

// A GLSL file on a device.
class File {
  public:
    File(const std::filesystem::path& path, const std::vector<std::filesystem::path>& roots,
         const std::string& device, const std::string& variant, const std::vector<std::string>& defines)
        : name_(path.filename().string()) {
        std::vector<std::filesystem::path> all_roots{path.parent_path()};
        all_roots.insert(all_roots.end(), roots.begin(), roots.end());
        subject::LabOptions options{.device = device,
                                    .file = std::make_shared<const subject::OwnFile>(
                                        path, module::read_text(path), std::move(all_roots), defines)};
        if (!variant.empty()) options.variant = module::variant(variant);
        functions_ = subject::own_functions(options);
        lab_ = std::make_shared<const subject::Lab>(std::move(options));
    }

    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const subject::OwnFunction& own : functions_.found) names.push_back(own.name);
        return names;
    }
    [[nodiscard]] std::map<std::string, std::string> left_out() const {
        std::map<std::string, std::string> reasons;
        for (const subject::Skipped& one : functions_.left_out) reasons[one.name] = one.why;
        return reasons;
    }
    [[nodiscard]] std::string device() const { return lab_->info().name; }

    [[nodiscard]] Function function(const std::string& name) const {
        const auto found = std::ranges::find(functions_.found, name, &subject::OwnFunction::name);
        if (found != functions_.found.end()) return {lab_, *found};
        for (const subject::Skipped& one : functions_.left_out)
            if (one.name.starts_with(name + "("))
                throw std::invalid_argument(name_ + ": " + one.name + ": " + one.why);
        std::string known;
        for (const std::string& one : names()) known += (known.empty() ? "" : ", ") + one;
        throw std::invalid_argument(name_ + ": no function " + name +
                                    "; it has: " + (known.empty() ? "none" : known));
    }

  private:
    std::string name_;
    subject::OwnFunctions functions_;
    std::shared_ptr<const subject::Lab> lab_;
};

std::string text_of(const judge::Answer& answer) {
    std::ostringstream text;
    text << answer;
    return text.str();
}

}  // namespace
}  // namespace gloam::python

PYBIND11_MODULE(_gloam, module) {
    using namespace gloam;
    using python::File;
    using python::Function;
    module.attr("__version__") = base::version();
    py::class_<python::Variable>(module, "Variable")
        .def_readonly("name", &python::Variable::name)
        .def_readonly("glsl", &python::Variable::glsl)
        .def_readonly("dtype", &python::Variable::dtype)
        .def_readonly("shape", &python::Variable::shape)
        .def_readonly("is_input", &python::Variable::is_input);
    py::class_<judge::Answer>(module, "Answer")
        .def("__bool__", &judge::Answer::passed)
        .def("__str__", &python::text_of)
        .def_property_readonly("passed", &judge::Answer::passed)
        .def_property_readonly("inputs", &judge::Answer::inputs)
        .def_property_readonly("outside", &judge::Answer::outside)
        .def_property_readonly("worst_ulp",
                               [](const judge::Answer& a) { return a.worst ? a.worst->error.ulp : 0.0; });
    py::class_<Function>(module, "Function")
        .def_property_readonly("declaration", &Function::declaration)
        .def_property_readonly("variables", &Function::variables)
        .def("run", &Function::run)
        .def("judge",
             [](const Function& f, const python::RangeOf& ranges, std::size_t inputs, std::uint64_t seed,
                double ulp, double absolute,
                const std::function<std::vector<double>(std::vector<python::Word>)>& reference) {
                 return f.judge(ranges, {inputs, seed}, {.ulp = ulp, .absolute = absolute}, reference);
             })
        .def("audit", [](const Function& f, const python::RangeOf& ranges, std::size_t inputs,
                         std::uint64_t seed) { return f.audit(ranges, {inputs, seed}); })
        .def("explain", &Function::explain)
        .def("domain", &Function::domain);
    py::class_<File>(module, "File")
        .def(py::init([](const std::string& path, const std::vector<std::string>& roots,
                         const std::string& device, const std::string& variant,
                         const std::vector<std::string>& defines) {
            return File(path, {roots.begin(), roots.end()}, device, variant, defines);
        }))
        .def_property_readonly("device", &File::device)
        .def_property_readonly("names", &File::names)
        .def_property_readonly("left_out", &File::left_out)
        .def("function", &File::function);
}
