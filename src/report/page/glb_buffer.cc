#include "report/page/glb_buffer.h"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace clevis::report {
namespace {

constexpr int kFloat = 5126, kUnsignedInt = 5125, kUnsignedByte = 5121;

std::size_t components(std::string_view type) {
  if (type == "SCALAR") return 1;
  return static_cast<std::size_t>(type.back() - '0');  // VEC3, VEC4
}

void add_number(std::string& text, std::uint32_t number) {
  char bytes[sizeof number];
  std::memcpy(bytes, &number, sizeof number);
  text.append(bytes, sizeof number);
}

void add_chunk(std::string& text, std::uint32_t kind, std::string content,
               char filling) {
  content.resize((content.size() + 3) / 4 * 4, filling);
  add_number(text, static_cast<std::uint32_t>(content.size()));
  add_number(text, kind);
  text += content;
}

}  // namespace

int GlbBuffer::add_accessor(const void* data, std::size_t bytes,
                            std::size_t count, int component, const char* type,
                            Use use) {
  nlohmann::ordered_json view = {
      {"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes}};
  if (use != Use::kAnimation) view["target"] = static_cast<int>(use);
  views_.push_back(view);
  bytes_.append(static_cast<const char*>(data), bytes);
  bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
  accessors_.push_back({{"bufferView", views_.size() - 1},
                        {"componentType", component},
                        {"count", count},
                        {"type", type}});
  return static_cast<int>(accessors_.size()) - 1;
}

int GlbBuffer::add(const std::vector<float>& numbers, const char* type,
                   Use use) {
  return add_accessor(numbers.data(), numbers.size() * sizeof(float),
                      numbers.size() / components(type), kFloat, type, use);
}

int GlbBuffer::add(const std::vector<std::uint32_t>& numbers, Use use) {
  return add_accessor(numbers.data(), numbers.size() * sizeof(std::uint32_t),
                      numbers.size(), kUnsignedInt, "SCALAR", use);
}

int GlbBuffer::add_colours(const std::vector<std::uint8_t>& bytes) {
  const int accessor =
      add_accessor(bytes.data(), bytes.size(), bytes.size() / 4, kUnsignedByte,
                   "VEC4", Use::kVertices);
  accessors_[static_cast<std::size_t>(accessor)]["normalized"] = true;
  return accessor;
}

void GlbBuffer::add_bounds(int accessor, const std::vector<float>& numbers,
                           int items) {
  const auto n = static_cast<std::size_t>(items);
  std::vector<float> low(numbers.begin(), numbers.begin() + items), high = low;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    low[i % n] = std::min(low[i % n], numbers[i]);
    high[i % n] = std::max(high[i % n], numbers[i]);
  }
  accessors_[static_cast<std::size_t>(accessor)]["min"] = low;
  accessors_[static_cast<std::size_t>(accessor)]["max"] = high;
}

std::string GlbBuffer::file(nlohmann::ordered_json json) const {
  if (!bytes_.empty()) {
    json["buffers"] = nlohmann::ordered_json::array(
        {{{"byteLength", (bytes_.size() + 3) / 4 * 4}}});
    json["bufferViews"] = views_;
    json["accessors"] = accessors_;
  }
  std::string chunks;
  using nlohmann::ordered_json;
  add_chunk(chunks, 0x4E4F534A,  // "JSON"
            json.dump(-1, ' ', false, ordered_json::error_handler_t::replace),
            ' ');
  if (!bytes_.empty()) add_chunk(chunks, 0x004E4942, bytes_, '\0');  // "BIN"
  std::string text = "glTF";
  add_number(text, 2);
  add_number(text, static_cast<std::uint32_t>(12 + chunks.size()));
  return text + chunks;
}

}  // namespace clevis::report
