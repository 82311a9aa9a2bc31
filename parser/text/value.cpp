#include "parser/text/value.h"

#include <algorithm>
#include <array>

namespace firstlight::parser {

std::string_view kind_name(const Value& value) {
  if (const auto* numbers = std::get_if<Numbers>(&value)) {
    static constexpr std::array<std::string_view, 6> kNames = {"",       "float",     "2D vector",
                                                               "vector", "4D vector", "color"};
    return kNames[numbers->size];
  }
  static constexpr auto kNames = std::to_array<std::string_view>({"empty array element",
                                                                  "number",
                                                                  "string",
                                                                  "array",
                                                                  "macro",
                                                                  "object",
                                                                  "texture",
                                                                  "pigment",
                                                                  "finish",
                                                                  "interior",
                                                                  "material",
                                                                  "color_map",
                                                                  "normal",
                                                                  "density",
                                                                  "media",
                                                                  "pigment_map",
                                                                  "normal_map",
                                                                  "slope_map",
                                                                  "texture_map",
                                                                  "density_map",
                                                                  "camera",
                                                                  "transform",
                                                                  "function",
                                                                  "spline",
                                                                  "dictionary",
                                                                  "file",
                                                                  "fog",
                                                                  "rainbow",
                                                                  "sky_sphere"});
  static_assert(kNames.size() == std::variant_size_v<Value>);
  return kNames[value.index()];
}

std::size_t kind_of(const Value& value) {
  const auto* numbers = std::get_if<Numbers>(&value);
  return numbers ? std::variant_size_v<Value> + numbers->size : value.index();
}

bool picks_part(const Value& value, const Token& next) {
  const bool bracket = next.is(Punctuation::left_bracket);
  if (std::holds_alternative<std::shared_ptr<Array>>(value)) return bracket;
  return std::holds_alternative<std::shared_ptr<Dictionary>>(value) && (bracket || next.is(Punctuation::period));
}

std::uint32_t depth_of(const Value& value) {
  std::uint32_t deepest = 0;
  if (const auto* array = std::get_if<std::shared_ptr<Array>>(&value)) {
    for (const Value& element : (*array)->elements) deepest = std::max(deepest, depth_of(element));
    return deepest + 1;
  }
  if (const auto* dictionary = std::get_if<std::shared_ptr<Dictionary>>(&value)) {
    for (const auto& [key, entry] : (*dictionary)->entries) deepest = std::max(deepest, depth_of(*entry));
    return deepest + 1;
  }
  return 0;
}

std::size_t bytes_of(const Value& value) {
  constexpr std::size_t kEntry = 128;  // of a map, about
  std::size_t bytes = 0;
  if (const auto* text = std::get_if<std::string>(&value)) return text->size();
  if (const auto* array = std::get_if<std::shared_ptr<Array>>(&value)) {
    for (const Value& element : (*array)->elements) bytes += sizeof(Value) + bytes_of(element);
  } else if (const auto* dictionary = std::get_if<std::shared_ptr<Dictionary>>(&value)) {
    for (const auto& [key, entry] : (*dictionary)->entries) {
      bytes += kEntry + key.size() + sizeof(Value) + bytes_of(*entry);
    }
  }
  return bytes;
}

Value copy_of(const Value& value) {
  if (const auto* array = std::get_if<std::shared_ptr<Array>>(&value)) {
    auto copy = std::make_shared<Array>(**array);
    for (Value& element : copy->elements) {
      if (depth_of(element) > 0) element = copy_of(element);
    }
    return copy;
  }
  if (const auto* dictionary = std::get_if<std::shared_ptr<Dictionary>>(&value)) {
    auto copy = std::make_shared<Dictionary>();
    for (const auto& [key, entry] : (*dictionary)->entries) {
      copy->entries.emplace(key, std::make_shared<Value>(copy_of(*entry)));
    }
    return copy;
  }
  return value;
}

}  // namespace firstlight::parser
