#include "parser/expression/evaluator.h"
#include "parser/expression/expression.h"

#include <array>

namespace firstlight::parser {

namespace {

constexpr std::size_t kFilter = 3, kTransmit = 4;

using Components = std::array<float, 5>;  // red, green, blue, filter, transmit; POV-Ray keeps them in single precision

struct ColorWord {
  std::uint8_t terms;
  bool srgb;
  bool fourth_is_transmit;
};

const ColorWord* find_color_word(Keyword word) {
  static constexpr ColorWord kRgb{3, false, false}, kRgbf{4, false, false}, kRgbt{4, false, true},
      kRgbft{5, false, false};
  static constexpr ColorWord kSrgb{3, true, false}, kSrgbf{4, true, false}, kSrgbt{4, true, true},
      kSrgbft{5, true, false};
  switch (word) {
    case Keyword::rgb:
      return &kRgb;
    case Keyword::rgbf:
      return &kRgbf;
    case Keyword::rgbt:
      return &kRgbt;
    case Keyword::rgbft:
      return &kRgbft;
    case Keyword::srgb:
      return &kSrgb;
    case Keyword::srgbf:
      return &kSrgbf;
    case Keyword::srgbt:
      return &kSrgbt;
    case Keyword::srgbft:
      return &kSrgbft;
    default:
      return nullptr;
  }
}

// The place of the component that `red 0.5` and its like set; 5 for any other word.
std::size_t component_of(Keyword word) {
  switch (word) {
    case Keyword::red:
      return 0;
    case Keyword::green:
      return 1;
    case Keyword::blue:
      return 2;
    case Keyword::filter:
    case Keyword::alpha:
      return kFilter;
    case Keyword::transmit:
      return kTransmit;
    default:
      return 5;
  }
}

// `rgbft <...>` and its like, the word taken.
Components parse_whole(Evaluator& in, const Token& word, const ColorWord& form) {
  if (form.srgb && !in.language().gamma_stated()) {
    in.fail(word.location, "'" + std::string(word.text) + "' needs an 'assumed_gamma' in 'global_settings' before it");
  }
  const Numbers numbers = parse_full_expression(in, form.terms);
  if (numbers.size != form.terms) {
    in.warn(word.location, "'" + std::string(word.text) + "' expects " + std::to_string(int{form.terms}) +
                               " components, found " + std::to_string(int{numbers.size}));
  }
  Components color{};
  for (std::size_t i = 0; i < numbers.size; ++i) color[i] = static_cast<float>(numbers.values[i]);
  if (form.fourth_is_transmit) {
    color[kTransmit] = color[kFilter];
    color[kFilter] = 0.0f;
  }
  if (form.srgb) {
    for (std::size_t i = 0; i < 3; ++i) color[i] = in.language().from_srgb(color[i]);
  }
  return color;
}

}  // namespace

// One whole colour (a word with a vector, or an expression), and before or behind it single components in any order.
render::FilteredColor parse_color(Evaluator& in) {
  Components color{};
  bool whole = false;
  if (in.peek().is(Keyword::color)) in.take();
  for (;;) {
    const Token& word = in.peek();
    const std::size_t component = word.kind == TokenKind::keyword ? component_of(word.keyword) : 5;
    const ColorWord* form = word.kind == TokenKind::keyword ? find_color_word(word.keyword) : nullptr;
    if (component < 5) {
      in.take();
      color[component] = static_cast<float>(parse_float(in));
      whole = true;
    } else if (!whole && form != nullptr) {
      in.take();
      color = parse_whole(in, word, *form);
      whole = true;
    } else if (!whole && !word.is(Keyword::color) && at_expression(in)) {
      const Numbers numbers = parse_full_expression(in, 5);
      if (numbers.size != 5) {
        in.fail(word.location, "expected a color, found a " + std::string(kind_name(numbers)) + " expression");
      }
      for (std::size_t i = 0; i < 5; ++i) color[i] = static_cast<float>(numbers.values[i]);
      whole = true;
    } else {
      break;
    }
  }
  return {render::Rgb(color[0], color[1], color[2]), color[kFilter], color[kTransmit]};
}

}  // namespace firstlight::parser
