// Dictionaries, of the language after 3.7. Their word is none of 3.7's, so it counts only where nothing has its name.
#include "parser/directive/containers.h"

#include "parser/directive/interpreter.h"
#include "parser/expression/string_expression.h"

#include <utility>

namespace firstlight::parser {

// `.Key` or `["Key"]`
std::string Containers::parse_key() {
  if (in_.raw_next().is(Punctuation::period)) {
    in_.take_raw();
    const Token& key = in_.take_raw();
    if (key.kind != TokenKind::identifier && key.kind != TokenKind::keyword) {
      in_.fail(key.location, "expected a key after '.', found " + describe(key));
    }
    return std::string(key.text);
  }
  in_.expect(Punctuation::left_bracket, "before the key");
  std::string key = parse_string(in_);
  in_.expect(Punctuation::right_bracket, "behind the key");
  return key;
}

Scopes::Slot Containers::pick_entry(const std::shared_ptr<Dictionary>& dictionary, const Token& name, Pick purpose) {
  const std::string key = parse_key();
  const auto found = dictionary->entries.find(key);
  if (found != dictionary->entries.end()) return found->second;
  if (purpose == Pick::target) return add_entry(*dictionary, key, name.location);
  if (purpose == Pick::test) return std::make_shared<Value>();
  in_.fail(name.location, "'" + std::string(name.text) + "' has no entry '" + key + "'");
}

Scopes::Slot Containers::add_entry(Dictionary& dictionary, const std::string& key, const Location& at) {
  if (dictionary.entries.size() >= kMostElements) {
    in_.fail(at, "the dictionary is too large (limit " + std::to_string(kMostElements) + " entries)");
  }
  return dictionary.entries[key] = std::make_shared<Value>();
}

// `{ .Key: value, ["key"]: value }`, which may be left out.
Value Containers::parse_dictionary(const Token& word) {
  auto dictionary = std::make_shared<Dictionary>();
  const Interpreter::Hold hold(in_);
  if (!in_.peek().is(Punctuation::left_brace)) return dictionary;
  in_.open_block(word);
  while (in_.peek().is(Punctuation::period) || in_.peek().is(Punctuation::left_bracket)) {
    in_.unsettle();
    const Location at = in_.raw_next().location;
    const Scopes::Slot entry = add_entry(*dictionary, parse_key(), at);
    in_.expect(Punctuation::colon, "behind the key");
    Value value = in_.declarations().parse_argument(false).value;
    check_depth(1, value, at);
    *entry = std::move(value);
    if (in_.peek().is(Punctuation::comma)) in_.take();
  }
  in_.close_block();
  return dictionary;
}

}  // namespace firstlight::parser
