// Dictionaries, of the language after 3.7. Their word is none of 3.7's, so it counts only where nothing has its name.
#include "parser/directive/interpreter.h"
#include "parser/expression/string_expression.h"

#include <utility>

namespace firstlight::parser {

// `.Key` or `["Key"]`
std::string Interpreter::parse_key() {
  if (raw_next().is(Punctuation::period)) {
    take_raw();
    const Token& key = take_raw();
    if (key.kind != TokenKind::identifier && key.kind != TokenKind::keyword) {
      fail(key.location, "expected a key after '.', found " + describe(key));
    }
    return std::string(key.text);
  }
  expect(Punctuation::left_bracket, "before the key");
  std::string key = parse_string(*this);
  expect(Punctuation::right_bracket, "behind the key");
  return key;
}

Scopes::Slot Interpreter::pick_entry(const std::shared_ptr<Dictionary>& dictionary, const Token& name, Pick purpose) {
  const std::string key = parse_key();
  const auto found = dictionary->entries.find(key);
  if (found != dictionary->entries.end()) return found->second;
  if (purpose == Pick::target) return add_entry(*dictionary, key, name.location);
  if (purpose == Pick::test) return std::make_shared<Value>();
  fail(name.location, "'" + std::string(name.text) + "' has no entry '" + key + "'");
}

Scopes::Slot Interpreter::add_entry(Dictionary& dictionary, const std::string& key, const Location& at) {
  if (dictionary.entries.size() >= kMostElements) {
    fail(at, "the dictionary is too large (limit " + std::to_string(kMostElements) + " entries)");
  }
  return dictionary.entries[key] = std::make_shared<Value>();
}

// `{ .Key: value, ["key"]: value }`, which may be left out.
Value Interpreter::parse_dictionary(const Token& word) {
  auto dictionary = std::make_shared<Dictionary>();
  const Hold hold(*this);
  if (!peek().is(Punctuation::left_brace)) return dictionary;
  open_block(word);
  while (peek().is(Punctuation::period) || peek().is(Punctuation::left_bracket)) {
    unsettle();
    const Location at = raw_next().location;
    const Scopes::Slot entry = add_entry(*dictionary, parse_key(), at);
    expect(Punctuation::colon, "behind the key");
    Value value = parse_argument(false).value;
    check_depth(1, value, at);
    *entry = std::move(value);
    if (peek().is(Punctuation::comma)) take();
  }
  close_block();
  return dictionary;
}

}  // namespace firstlight::parser
