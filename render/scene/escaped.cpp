#include "render/scene/escaped.h"

#include <fmt/format.h>

#include <cstddef>

namespace firstlight::render {
namespace {

/// How many bytes at the beginning of `text` are a control character; 0: none. Those from U+0080 on take two in UTF-8.
std::size_t control_at(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x20 || byte(0) == 0x7f) return 1;
  return text.size() > 1 && byte(0) == 0xc2 && byte(1) >= 0x80 && byte(1) < 0xa0 ? 2 : 0;
}

std::string escape_all_but(std::string_view text, std::string_view kept) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = kept.find(text[0]) == std::string_view::npos ? control_at(text) : 0;
    if (length == 0) {
      out += text[0];
    } else if (text[0] == '\n' || text[0] == '\t') {
      out += text[0] == '\n' ? "\\n" : "\\t";
    } else {
      for (const char c : text.substr(0, length)) out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

}  // namespace

std::string escaped(std::string_view text) { return escape_all_but(text, ""); }

std::string escaped_lines(std::string_view text) { return escape_all_but(text, "\n\t"); }

}  // namespace firstlight::render
