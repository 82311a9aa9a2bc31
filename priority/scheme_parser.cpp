// The text of an order:
//
//   order     = mixture { "," mixture }              the first decides, the next order what is equal
//   mixture   = [ "-" ] part { ( "+" | "-" ) part }  weighted
//   part      = [ number "*" ] criterion
//   criterion = name [ "(" arguments ")" ] | "(" order ")"
#include "priority/mixture.h"
#include "priority/schemes.h"

#include <fmt/format.h>

namespace firstlight::priority {
namespace {

constexpr int kDeepest = 32;             // parentheses in parentheses
constexpr std::size_t kMost = 64;        // criteria in an order
constexpr std::size_t kLongest = 65536;  // bytes

class Parser {
 public:
  Parser(std::string_view text, const SchemeInput& input) : text_(text), input_(input) {
    for (const SchemeRow& row : schemes()) names_.push_back(row.name);
  }

  SchemePtr whole() {
    const Piece first = text_.next();
    const SchemePtr scheme = order();
    if (!text_.at_end()) text_.fail_expected("',', '+', '-' or the end of the scheme");
    if (has_recursive_ && criteria_ > 1)
      text_.fail(first, "'recursive' is no order of waiting rays and cannot be mixed");
    return has_recursive_ ? nullptr : scheme;
  }

 private:
  SchemePtr order() {
    std::vector<SchemePtr> members;
    do members.push_back(mixture());
    while (text_.accept(','));
    return has_recursive_ ? nullptr : make_lexicographic(std::move(members));
  }

  SchemePtr mixture() {
    std::vector<WeightedMember> members;
    double sign = text_.accept('-') ? -1.0 : 1.0;
    for (;;) {
      double weight = 1.0;
      if (text_.at_number()) {
        weight = text_.number("a weight");
        text_.expect('*', "after the weight");
      }
      members.push_back({criterion(), sign * weight});
      if (text_.accept('+')) {
        sign = 1.0;
      } else if (text_.accept('-')) {
        sign = -1.0;
      } else {
        break;
      }
    }
    if (has_recursive_) return nullptr;
    if (members.size() == 1 && members.front().weight > 0.0) return members.front().scheme;
    return make_weighted(std::move(members));
  }

  SchemePtr criterion() {
    if (text_.accept('(')) {
      if (++depth_ > kDeepest) text_.fail(text_.next(), "too many parentheses in each other");
      const SchemePtr scheme = order();
      text_.expect(')', "to close the parenthesis");
      --depth_;
      return scheme;
    }
    const Piece name = text_.name(names_);
    if (++criteria_ > kMost) text_.fail(name, fmt::format("more than {} schemes in one order", kMost));
    const SchemeRow* const row = find_scheme(name.text);
    if (row == nullptr) {
      text_.fail(name, fmt::format("there is no scheme '{}'{}; known are {}", name.text,
                                   nearest_hint(name.text, names_), scheme_names()));
    }
    if (row->make == nullptr) {
      has_recursive_ = true;
      return nullptr;
    }
    if (!text_.next_is('(')) {
      try {
        return row->make(input_, nullptr);
      } catch (const MissingArguments& missing) {
        text_.fail(name, fmt::format("'{}' needs {}", name.text, missing.what));
      }
    }
    if (row->arguments.empty()) text_.fail(text_.next(), fmt::format("'{}' takes no arguments", name.text));
    text_.accept('(');
    SchemePtr scheme = row->make(input_, &text_);
    text_.expect(')', fmt::format("to close '{}'", name.text));
    return scheme;
  }

  SchemeText text_;
  const SchemeInput& input_;
  std::vector<std::string_view> names_;
  int depth_ = 0;
  std::size_t criteria_ = 0;
  bool has_recursive_ = false;
};

}  // namespace

SchemePtr parse_scheme(std::string_view text, const SchemeInput& input) {
  if (text.size() > kLongest) throw SchemeError{kLongest, 1, "the text of the scheme is too long"};
  return Parser(text, input).whole();
}

}  // namespace firstlight::priority
