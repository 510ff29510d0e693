// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>
#include <algorithm>
#include <bit>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <stdexcept>

#include "numeric/numbers.hpp"
#include "pass/internal/work.hpp"
#include "subject/interpreted_kernel.hpp"

namespace gloam::pass::internal {
namespace {

using namespace subject;

using module::BindingType;
using Kind = PassSlot::Kind;

std::string size_text(glm::ivec2 size) {
    return fmt::format("{} x {}", size.x, size.y);
}

// bool is uint in memory.
module::Type in_memory(module::Type type) {
    if (type.scalar == module::Scalar::bool_) type.scalar = module::Scalar::uint_;
    for (module::Member& member : type.members) member.type = in_memory(member.type);
    return type;
}

class Binder {
  public:
    Binder(const PassInterface& pass, const PassInputs& inputs, const PassOptions& options)
        : pass_(pass), inputs_(inputs), options_(options), given_(pass.slots.size()) {}

    PassWork run() {
        for (const auto& [name, value] : inputs_) take(name, value);
        make_bindings();
        const auto& constants = pass_.declared.push_constants;
        work_.push_constants.resize(constants ? constants->size : 0);
        for (std::size_t i = 0; i < given_.size(); ++i) bind(pass_.slots[i], given_[i]);
        set_groups();
        for (const Bound& bound : work_.bindings)
            if ((bound.kind == Bound::Kind::storage || bound.kind == Bound::Kind::uniform) &&
                bound.words.empty())
                throw std::invalid_argument(pass_.name +
                                            ": a buffer without elements, expected one at least");
        return std::move(work_);
    }

    PassWork run(const PassBindings& all) {
        make_bindings();
        work_.push_constants = all.push_constants;
        work_.constants = all.constants;
        for (const PassSlot& slot : pass_.slots) {
            if (slot.kind != Kind::image) continue;
            const auto found = all.images.find(pass_.declared.bindings[slot.index].number);
            const Image nothing{
                slot.type, {1, 1}, {}, std::vector<Word>(static_cast<std::size_t>(slot.type.rows))};
            const Image& image = found == all.images.end() ? nothing : found->second;
            require_image(slot, image);
            bind_image(slot, &image);
        }
        for (const auto& [number, words] : all.buffers)
            if (number < work_.bindings.size()) work_.bindings[number].words = words;
        set_groups();
        return std::move(work_);
    }

  private:
    [[noreturn]] void refuse(const std::string& name, const std::string& why) const {
        throw std::invalid_argument(fmt::format("{}: \"{}\" {}", pass_.name, name, why));
    }

    [[nodiscard]] std::string known() const {
        std::vector<std::string> names;
        for (const PassSlot& slot : pass_.slots)
            names.push_back(fmt::format("{} ({})", slot.name, slot.says));
        return names.empty() ? "no inputs" : fmt::format("{}", fmt::join(names, ", "));
    }

    // Whatever is given is known and of the slot's type.
    void take(const std::string& name, const PassValue& value) {
        const auto slot = std::ranges::find_if(pass_.slots, [&name](const PassSlot& one) {
            return one.name == name || (one.other_name == name && !name.empty());
        });
        if (slot == pass_.slots.end()) refuse(name, "is no input, expected among: " + known());
        const PassValue*& given = given_[static_cast<std::size_t>(slot - pass_.slots.begin())];
        if (given != nullptr) refuse(name, "is given twice, by either of its names");
        given = &value;
        if (slot->kind != Kind::image) return require_type(*slot, value);
        if (!value.image())
            refuse(slot->name, fmt::format("is {}, expected {}", module::name_of(value.type()), slot->says));
        require_image(*slot, *value.image());
    }

    [[noreturn]] void refuse_missing(const PassSlot& slot, const std::string& why = "") const {
        refuse(slot.name, fmt::format("({}) is not given{}; the pass takes: {}", slot.says, why, known()));
    }

    void require_image(const PassSlot& slot, const Image& image) const {
        const module::Type& found = image.element;
        if (image.size.x < 1 || image.size.y < 1) refuse(slot.name, "has no pixels, expected 1 x 1 at least");
        const std::size_t words = static_cast<std::size_t>(image.size.x) *
                                  static_cast<std::size_t>(image.size.y) * scalars_of(found).size();
        if (!image.sampling && image.words.size() != words)
            refuse(slot.name, fmt::format("is {} with {} words, expected {}", size_text(image.size),
                                          image.words.size(), words));
        const module::Binding& binding = pass_.declared.bindings[slot.index];
        if (binding.type != BindingType::sampled_image) {
            if (!(found == slot.type))
                refuse(slot.name, fmt::format("is an image of {}, expected {} ({})", module::name_of(found),
                                              slot.says, binding.format));
        } else if (found.scalar != slot.type.scalar || found.columns != 1 || !found.sizes.empty()) {
            refuse(slot.name, fmt::format("is an image of {}, expected one of {} for {}",
                                          module::name_of(found), module::name_of(slot.type), slot.says));
        }
    }

    void require_type(const PassSlot& slot, const PassValue& value) const {
        if (value.image()) refuse(slot.name, fmt::format("is an image, expected {}", slot.says));
        module::Type expected = slot.type;
        if (slot.is_unbounded() && !value.type().sizes.empty())
            expected.sizes.front() = value.type().sizes.front();
        if (in_memory(value.type()) != in_memory(expected))
            refuse(slot.name, fmt::format("is {}, expected {}", module::name_of(value.type()), slot.says));
    }

    // The size of what is not given: as asked, or that of the images that are given.
    [[nodiscard]] glm::ivec2 size_for(const std::string& output) const {
        if (options_.size.x > 0 && options_.size.y > 0) return options_.size;
        std::string first;
        glm::ivec2 size(0);
        for (const auto& [name, value] : inputs_) {
            if (!value.image()) continue;
            if (first.empty()) size = value.image()->size;
            if (value.image()->size != size)
                refuse(output,
                       fmt::format("has no size: \"{}\" is {}, \"{}\" is {}; expected PassOptions::size",
                                   first, size_text(size), name, size_text(value.image()->size)));
            if (first.empty()) first = name;
        }
        if (first.empty()) refuse(output, "has no size: no image is given; expected PassOptions::size");
        return size;
    }

    void make_bindings() {
        for (const module::Binding& binding : pass_.declared.bindings) {
            if (work_.bindings.size() <= binding.number) work_.bindings.resize(binding.number + 1);
            if (!binding.block) continue;
            std::size_t bytes = binding.block->size;
            for (std::size_t i = 0; i < given_.size(); ++i)
                if (const PassSlot& slot = pass_.slots[i];
                    slot.kind == Kind::buffer_member && &pass_.declared.bindings[slot.index] == &binding)
                    bytes = std::max(
                        bytes, slot.member.offset + (slot.is_unbounded()
                                                         ? elements_of(slot, given_[i]) * slot.member.stride
                                                         : slot.member.size));
            Bound& buffer = work_.bindings[binding.number];
            buffer.kind =
                binding.type == BindingType::uniform_buffer ? Bound::Kind::uniform : Bound::Kind::storage;
            buffer.words.resize((bytes + 3) / sizeof(Word));
            buffer.fresh.resize(buffer.words.size());
        }
    }

    // Of an unbounded array.
    [[nodiscard]] static std::size_t elements_of(const PassSlot& slot, const PassValue* value) {
        const bool given = slot.is_unbounded() && value != nullptr && !value->type().sizes.empty();
        return given ? value->type().sizes.front() : 0;
    }

    void bind(const PassSlot& slot, const PassValue* value) {
        if (slot.kind == Kind::image) return bind_image(slot, value ? &*value->image() : nullptr);
        if (slot.kind == Kind::buffer_member) return bind_member(slot, value);
        if (slot.kind == Kind::push_constant) {
            if (value == nullptr) refuse_missing(slot);
            store(slot, *value, work_.push_constants);
        } else if (value != nullptr) {  // a constant has a default
            work_.constants.push_back({pass_.declared.constants[slot.index].id, value->words().front()});
        }
    }

    static void store(const PassSlot& slot, const PassValue& value, std::span<std::byte> bytes) {
        const std::vector<std::size_t> places = places_of(slot.member, elements_of(slot, &value));
        for (std::size_t i = 0; i < places.size(); ++i)
            std::memcpy(bytes.subspan(places[i], sizeof(Word)).data(), &value.words()[i], sizeof(Word));
    }

    void bind_member(const PassSlot& slot, const PassValue* value) {
        const module::Binding& binding = pass_.declared.bindings[slot.index];
        Bound& buffer = work_.bindings[binding.number];
        if (value != nullptr) return store(slot, *value, std::as_writable_bytes(std::span(buffer.words)));
        if (slot.is_unbounded()) refuse_missing(slot, ", and nothing else says how many elements it has");
        if (binding.reads) refuse_missing(slot, binding.writes ? ", and its block is not `writeonly`" : "");
        for (const std::size_t place : places_of(slot.member, 0)) buffer.fresh[place / sizeof(Word)] = true;
    }

    // Four words for each texel: what the image lacks is 0, its last component 1.
    static std::vector<Word> widened(const std::vector<Word>& words, std::size_t components, bool integers) {
        std::vector<Word> all;
        for (std::size_t first = 0; first + components <= words.size(); first += components)
            for (std::size_t c = 0; c < texel_words; ++c)
                all.push_back(c < components ? words[first + c]
                              : c < 3        ? 0U
                              : integers     ? 1U
                                             : std::bit_cast<Word>(1.0F));
        return all;
    }

    void bind_image(const PassSlot& slot, const Image* image) {
        const module::Binding& binding = pass_.declared.bindings[slot.index];
        Bound& bound = work_.bindings[binding.number];
        const bool sampled = binding.type == BindingType::sampled_image;
        if (image == nullptr && (sampled || binding.reads))
            refuse_missing(slot, sampled || !binding.writes ? "" : ", and it is not `writeonly`");
        bound.size = image == nullptr ? size_for(slot.name) : image->size;
        bound.integers = binding.texel != "float";
        if (sampled) return bind_sampler(slot, *image, bound);
        bound.kind = Bound::Kind::image;
        bound.format = *format_named(binding.format);
        bound.written = binding.writes;
        const std::size_t texels =
            static_cast<std::size_t>(bound.size.x) * static_cast<std::size_t>(bound.size.y);
        bound.words = widened(image == nullptr ? std::vector<Word>(texels * bound.channels()) : image->words,
                              bound.channels(), bound.integers);
        for (std::size_t w = 0; image == nullptr && w < bound.words.size(); ++w)
            bound.fresh.push_back(w % texel_words < bound.channels());
    }

    void bind_sampler(const PassSlot& slot, const Image& image, Bound& bound) const {
        bound.kind = Bound::Kind::sampler;
        bound.stateless = !bound.integers && !image.sampling && slot.says == "sampler2D";
        Image whole = image;
        whole.words = widened(image.words, static_cast<std::size_t>(image.element.rows), bound.integers);
        if (!bound.integers && !bound.stateless && !slot.says.ends_with("Shadow"))
            require_halves(slot, whole.words);
        try {
            bound.words = sampled_words(whole, slot.says);
        } catch (const std::invalid_argument& error) {
            refuse(slot.name, fmt::format("is {}", error.what()));
        }
    }

    // Devices filter floats of 16 bits.
    void require_halves(const PassSlot& slot, const std::vector<Word>& words) const {
        for (const Word word : words) {
            const auto value = std::bit_cast<float>(word);
            if (value == glm::unpackHalf1x16(glm::packHalf1x16(value)) || value != value) continue;
            refuse(slot.name, fmt::format("holds {}, expected floats of 16 bits for a sampler with a state",
                                          numeric::to_text(value)));
        }
    }

    void set_groups() {
        work_.group_size = pass_.declared.local_size;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (!pass_.declared.local_size_ids.at(axis)) continue;
            const std::uint32_t id = *pass_.declared.local_size_ids.at(axis);
            for (const module::SpecializationConstant& constant : pass_.declared.constants)
                if (constant.id == id) work_.group_size.at(axis) = constant.bits;
            for (const backend::Constant& constant : work_.constants)
                if (constant.id == id) work_.group_size.at(axis) = constant.bits;
        }
        if (std::ranges::count(work_.group_size, 0U) > 0)
            throw std::invalid_argument(pass_.name + ": a side of its work groups is 0, expected 1 at least");
        work_.groups = options_.groups;
        if (work_.groups != std::array<std::uint32_t, 3>{}) return;
        glm::ivec2 size = options_.size;
        const auto written = std::ranges::find(work_.bindings, true, &Bound::written);
        if (written != work_.bindings.end() && size.x <= 0) size = written->size;
        if (size.x < 1 || size.y < 1)
            throw std::invalid_argument(
                pass_.name + ": writes no image, expected PassOptions::groups or PassOptions::size");
        for (const std::size_t axis : {0U, 1U})
            work_.groups.at(axis) =
                (static_cast<std::uint32_t>(size[static_cast<int>(axis)]) + work_.group_size.at(axis) - 1) /
                work_.group_size.at(axis);
        work_.groups[2] = 1;
    }

    const PassInterface& pass_;
    const PassInputs& inputs_;
    const PassOptions& options_;
    std::vector<const PassValue*> given_;  // for each slot; null: nothing is
    PassWork work_;
};

}  // namespace

PassWork bound(const PassInterface& pass, const PassInputs& inputs, const PassOptions& options) {
    return Binder(pass, inputs, options).run();
}

PassWork bound(const PassInterface& pass, const PassBindings& bindings) {
    return Binder(pass, {}, {.groups = bindings.groups}).run(bindings);
}

}  // namespace gloam::pass::internal
