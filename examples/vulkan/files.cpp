// SPDX-License-Identifier: MIT
#include "files.hpp"

#include <bit>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace {

std::string read_all(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) throw std::runtime_error(file.string() + ": cannot read the file");
    return bytes;
}

// The numbers behind "key":, one or a list; empty where there are none.
std::vector<float> numbers_of(const std::string& json, const std::string& key) {
    const std::size_t at = json.find("\"" + key + "\"");
    if (at == std::string::npos) return {};
    std::size_t begin = json.find(':', at) + 1;
    begin = json.find_first_not_of(" \n\r\t", begin);
    const bool list = begin < json.size() && json[begin] == '[';
    std::string text = json.substr(list ? begin + 1 : begin);
    text = text.substr(0, text.find_first_of(list ? "]" : ",}"));
    for (char& c : text)
        if (c == ',') c = ' ';
    std::istringstream stream(text);
    std::vector<float> numbers;
    for (double number; stream >> number;) numbers.push_back(static_cast<float>(number));
    return numbers;
}

std::vector<std::uint32_t> words_of(const std::vector<float>& values) {
    std::vector<std::uint32_t> words;
    for (const float value : values) words.push_back(std::bit_cast<std::uint32_t>(value));
    return words;
}

}  // namespace

Picture read_pfm(const std::filesystem::path& file) {
    const std::string bytes = read_all(file);
    std::istringstream head(bytes);
    std::string kind;
    float scale = 0.0F;
    Picture picture;
    head >> kind >> picture.width >> picture.height >> scale;
    picture.channels = kind == "PF" ? 3 : 1;
    const std::size_t row = std::size_t{picture.width} * picture.channels;
    const auto begin = static_cast<std::size_t>(head.tellg()) + 1;
    if (!head || scale >= 0.0F || bytes.size() != begin + 4 * row * picture.height)
        throw std::runtime_error(file.string() + ": expected a little-endian portable float map");
    picture.values.resize(row * picture.height);
    for (std::uint32_t y = 0; y < picture.height; ++y)  // its rows are from the bottom up
        std::memcpy(&picture.values[row * (picture.height - 1 - y)], &bytes[begin + 4 * row * y], 4 * row);
    return picture;
}

void write_pfm(const std::filesystem::path& file, const Picture& picture) {
    std::ofstream stream(file, std::ios::binary);
    stream << (picture.channels == 3 ? "PF\n" : "Pf\n") << picture.width << " " << picture.height
           << "\n-1.0\n";
    const std::size_t row = std::size_t{picture.width} * picture.channels;
    for (std::uint32_t y = picture.height; y-- > 0;)
        stream.write(reinterpret_cast<const char*>(&picture.values[row * y]),
                     static_cast<std::streamsize>(4 * row));
    if (!stream.flush()) throw std::runtime_error(file.string() + ": cannot write the file");
}

View read_view(const std::filesystem::path& file) {
    const std::string json = read_all(file);
    const std::vector<float> projection = numbers_of(json, "proj_vk");
    const std::vector<float> change = numbers_of(json, "previous_from_current");
    if (projection.size() != 16)
        throw std::runtime_error(file.string() + ": expected \"proj_vk\", 16 numbers");
    const std::vector<float> world = numbers_of(json, "view");
    View view{{"p00_p11", words_of({projection[0], projection[5]})}};
    view["p22_p32"] = words_of({projection[10], projection[14]});
    if (world.size() == 16) {
        view["view_from_world"] = words_of(world);
        view["view_from_world"].resize(12);  // the rotation alone
    }
    // There is no guard band, and the view is never that of the frame before.
    for (const char* pair : {"border", "band"}) view[pair] = {0, 0};
    for (const char* flag : {"still", "settled"}) view[flag] = {0};
    if (change.size() == 16) view["previous_from_current"] = words_of(change);
    return view;
}

std::vector<std::uint32_t> read_words(const std::filesystem::path& file) {
    const std::string bytes = read_all(file);
    std::vector<std::uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), 4 * words.size());
    return words;
}
