// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "catalogue/description.hpp"
#include "judge/question.hpp"

// The entry of an equation in the catalogue states what a person must decide; one call of add() a function:
//
//     add(entries, "TSSAO-5", &reference::gloam_blend,
//         {uniform(0, 1).and_special(), ...},     // domain: one Values for each in or inout parameter
//         {.ulp = 3},                             // budget: measured; see judge::Budget
//         {0, 1e9},                               // codomain: holds for every input whatever, NaN included
//         [](double history, ...) { return ...; });  // inputs for which the budget is promised: all
//
// The rest is read. Its title, formula, source, function and file stand in the comment of the GLSL function
// (catalogue/description.hpp). The signature is that of the reference, with float in place of double; what
// the reference takes as T& is an out parameter. Degenerate inputs, and images of exact 0 and 1, are added to
// those of every entry (check/domain.hpp, check/question.hpp). The scenarios, the last argument, provide
// images for a function that reads images (catalogue/inputs.hpp); its reference then takes (const
// subject::ImageSet&, arguments...).
namespace gloam::catalogue {

// What a method converges to, before the remap.
struct KnownResults {
    std::map<std::string, double> values;  // by projection and view: "perspective wall 0.25"
    std::string none;                      // why no value is known
};

struct Entry {
    Description description;
    judge::Question question;
    KnownResults known{};  // of methods
};

using Entries = std::vector<Entry>;

namespace detail {

// The type that GLSL has for a type of a reference.
template <class T>
using InFloat = subject::InFloat<std::remove_cvref_t<T>>;

template <class P>
inline constexpr bool is_out = std::is_lvalue_reference_v<P> && !std::is_const_v<std::remove_reference_t<P>>;
template <class P>
using Parameter = std::conditional_t<is_out<P>, subject::Out<InFloat<P>>, InFloat<P>>;

// The GLSL signature of a reference: of a function, or of an object that is called like one. The images that
// a reference reads are no parameter.
template <class Callable>
struct GlslOf : GlslOf<decltype(&Callable::operator())> {};
template <class R, class... P>
struct GlslOf<R (*)(P...)> {
    using type = InFloat<R>(Parameter<P>...);
};
template <class R, class... P>
struct GlslOf<R (*)(const subject::ImageSet&, P...)> : GlslOf<R (*)(P...)> {};
template <class R, class C, class... P>
struct GlslOf<R (C::*)(P...) const> : GlslOf<R (*)(P...)> {};

}  // namespace detail

// Adds an entry: the question with this domain and its degenerate inputs. What add() does for any reference
// is here, so that it is compiled once.
judge::Question& add_question(Entries& entries, std::string id, judge::Question question,
                              const subject::Domain& domain);

// Adds an entry. `promised`: called with the exact values of all inputs; nullptr: all.
template <class Reference, class Promised = std::nullptr_t>
judge::Question& add(Entries& entries, std::string id, Reference reference, const subject::Domain& domain,
                     judge::Budget budget = {}, judge::Codomain codomain = {}, Promised promised = nullptr,
                     std::vector<subject::ImageScenario> scenarios = {}) {
    using Signature = typename detail::GlslOf<Reference>::type;
    judge::Question question{.signature = subject::SignatureOf<Signature>::describe(),
                             .reference = judge::make_reference<Signature>(reference),
                             .budget = budget,
                             .codomain = codomain,
                             .scenarios = std::move(scenarios)};
    if constexpr (!std::same_as<Promised, std::nullptr_t>)
        question.promised = judge::make_predicate<Signature>(promised);
    return add_question(entries, std::move(id), std::move(question), domain);
}

// The entries of each file, in the order of glsl/gloam.
void append_numeric(Entries& entries);
void append_sampling(Entries& entries);
void append_geometry(Entries& entries);
void append_geometry_camera(Entries& entries);
void append_occlusion(Entries& entries);
void append_occlusion_slices(Entries& entries);
void append_occlusion_volumes(Entries& entries);
void append_occlusion_gathers(Entries& entries);
void append_methods(Entries& entries);
void append_occlusion_scalable(Entries& entries);
void append_temporal(Entries& entries);
void append_filter(Entries& entries);
void append_filter_edges(Entries& entries);
void append_shading(Entries& entries);
void append_frame(Entries& entries);
void append_builtins(Entries& entries);

// The results of a method by name. Throws std::logic_error for one that the table lacks.
[[nodiscard]] const KnownResults& known_results(const std::string& method);

// Adds the inputs with the largest errors that a search has found to the domains of their equations. Throws
// std::logic_error for an input whose equation is not among the entries.
void add_worst_inputs(Entries& entries);

}  // namespace gloam::catalogue
