#include "app/boost_text.h"

#include "app/pov_switches.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace firstlight::app {
namespace {

using priority::Boost;
using Words = std::span<const std::string_view>;

constexpr int kLargestBy = 1000;
constexpr std::size_t kLongestName = 64;
constexpr std::string_view kBlanks = " \t\r\n\f\v";

/// Takes the next word as a whole number.
bool take(Words& words, std::string_view what, int& number, std::string& error) {
  if (words.empty()) {
    error = fmt::format("expected {}, found the end", what);
    return false;
  }
  const auto value = parse<int>(words[0]);
  if (!value) {
    error = fmt::format("expected {}, found '{}'", what, words[0]);
    return false;
  }
  number = *value;
  words = words.subspan(1);
  return true;
}

bool read_region(Words& words, priority::Rectangle& region, std::string& error) {
  return take(words, "the left edge of the region in pixels", region.left, error) &&
         take(words, "the upper edge of the region in pixels", region.top, error) &&
         take(words, "the right edge of the region in pixels", region.right, error) &&
         take(words, "the lower edge of the region in pixels", region.bottom, error);
}

bool is_name(std::string_view word) {
  return !word.empty() && word.size() <= kLongestName && std::ranges::all_of(word, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
  });
}

std::string free_name(const std::string& wanted, std::span<const Boost> present) {
  const auto is_free = [&](const std::string& name) {
    return std::ranges::find(present, name, &Boost::name) == present.end();
  };
  if (is_free(wanted)) return wanted;
  int number = 2;
  while (!is_free(fmt::format("{}-{}", wanted, number))) ++number;
  return fmt::format("{}-{}", wanted, number);
}

bool read_subject(Words& words, Boost& boost, std::string& error) {
  const std::string_view kind = words.empty() ? std::string_view("the end") : words[0];
  if (!words.empty()) words = words.subspan(1);
  if (kind == "region") {
    boost.kind = Boost::Kind::region;
    return read_region(words, boost.region, error);
  }
  if (kind == "light") {
    boost.kind = Boost::Kind::light;
    return take(words, "the number of a light, the first being 0", boost.light, error);
  }
  if (kind == "object") {
    boost.kind = Boost::Kind::object;
    if (words.empty()) {
      error = "expected the identifier of an object, found the end";
      return false;
    }
    boost.object = words[0];
    words = words.subspan(1);
    return true;
  }
  error = fmt::format("expected region, object or light, found {}",
                      kind == "the end" ? "the end" : fmt::format("'{}'", kind));
  return false;
}

bool read_tail(Words words, Boost& boost, std::string& error) {
  while (!words.empty()) {
    const std::string_view word = words[0];
    words = words.subspan(1);
    if (word == "by") {
      if (!take(words, "a whole number after 'by'", boost.by, error)) return false;
      if (boost.by < -kLargestBy || boost.by > kLargestBy) {
        error = fmt::format("a boost is by {} at most, found {}", kLargestBy, boost.by);
        return false;
      }
    } else if (word == "as") {
      if (words.empty() || !is_name(words[0]) || words[0] == "all") {
        error = fmt::format("expected a name of letters and digits after 'as'{}",
                            words.empty() ? "" : fmt::format(", found '{}'", words[0]));
        return false;
      }
      boost.name = words[0];
      words = words.subspan(1);
    } else {
      error = fmt::format("expected 'by', 'as' or the end, found '{}'", word);
      return false;
    }
  }
  return true;
}

std::string subject_text(const Boost& boost) {
  switch (boost.kind) {
    case Boost::Kind::region:
      return fmt::format("region {} {} {} {}", boost.region.left, boost.region.top, boost.region.right,
                         boost.region.bottom);
    case Boost::Kind::object:
      return "object " + boost.object;
    case Boost::Kind::light:
      return fmt::format("light {}", boost.light);
  }
  return {};
}

std::string usual_name(const Boost& boost) {
  switch (boost.kind) {
    case Boost::Kind::region:
      return "region";
    case Boost::Kind::object:
      return boost.object;
    case Boost::Kind::light:
      return fmt::format("light{}", boost.light);
  }
  return {};
}

}  // namespace

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(kBlanks); at < text.size(); at = text.find_first_not_of(kBlanks, at)) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

std::optional<Boost> parse_boost(std::string_view text, std::span<const Boost> present, std::string& error) {
  const std::vector<std::string_view> words = words_of(text);
  Words rest = words;
  Boost boost;
  if (!read_subject(rest, boost, error) || !read_tail(rest, boost, error)) return std::nullopt;
  if (boost.name.empty()) boost.name = free_name(usual_name(boost), present);
  return boost;
}

std::string boost_text(const Boost& boost) {
  return fmt::format("{}: {} by {}", boost.name, subject_text(boost), boost.by);
}

std::string boost_help() {
  return "  region X0 Y0 X1 Y1         pixels from the upper left to the lower right one, both included\n"
         "  object NAME                what the scene calls so: the rays that leave it\n"
         "  light N                    the shadow feelers to a light; the first is 0\n"
         "  then perhaps               by N (1 if not given; less than 0: later), as NAME\n";
}

}  // namespace firstlight::app
