#include "parser/value.h"

#include <array>

namespace firstlight::parser {

std::string_view kind_name(const Value& value) {
  if (const auto* numbers = std::get_if<Numbers>(&value)) {
    static constexpr std::array<std::string_view, 6> kNames = {"",       "float",     "2D vector",
                                                               "vector", "4D vector", "color"};
    return kNames[numbers->size];
  }
  static constexpr auto kNames = std::to_array<std::string_view>(
      {"empty array element", "number", "string", "array", "macro", "object", "texture", "pigment", "finish",
       "interior", "material", "color_map", "camera", "transform", "unsupported value"});
  static_assert(kNames.size() == std::variant_size_v<Value>);
  return kNames[value.index()];
}

std::size_t kind_of(const Value& value) {
  const auto* numbers = std::get_if<Numbers>(&value);
  return numbers ? std::variant_size_v<Value> + numbers->size : value.index();
}

Value copy_of(const Value& value) {
  const auto* array = std::get_if<std::shared_ptr<Array>>(&value);
  if (array == nullptr) return value;
  auto copy = std::make_shared<Array>(**array);
  if (copy->depth > 1) {
    for (Value& element : copy->elements) element = copy_of(element);
  }
  return copy;
}

}  // namespace firstlight::parser
