// #fopen, #read, #write, #fclose. [POV-Ray 3.7 manual, "File I/O Directives"]
#include "parser/directive/data_file.h"
#include "parser/directive/interpreter.h"
#include "parser/expression/expression.h"
#include "parser/expression/string_expression.h"
#include "parser/expression/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

namespace firstlight::parser {

namespace {

/// `sint16be` and its like: how #write stores a number in bytes.
struct BinaryForm {
  Keyword word;
  double low, high;
  int bytes;
  bool big_endian;
};

const BinaryForm* find_binary(Keyword word) {
  static constexpr BinaryForm kForms[] = {
      {Keyword::sint8, -128.0, 127.0, 1, false},
      {Keyword::uint8, 0.0, 255.0, 1, false},
      {Keyword::sint16be, -32768.0, 32767.0, 2, true},
      {Keyword::sint16le, -32768.0, 32767.0, 2, false},
      {Keyword::uint16be, 0.0, 65535.0, 2, true},
      {Keyword::uint16le, 0.0, 65535.0, 2, false},
      {Keyword::sint32be, -2147483648.0, 2147483647.0, 4, true},
      {Keyword::sint32le, -2147483648.0, 2147483647.0, 4, false},
  };
  const auto* const found =
      std::find_if(std::begin(kForms), std::end(kForms), [word](const BinaryForm& form) { return form.word == word; });
  return found == std::end(kForms) ? nullptr : found;
}

// Rounded, and held within the form's range.
std::string bytes_of(const Numbers& numbers, const BinaryForm& form) {
  std::string result;
  for (std::size_t i = 0; i < numbers.size; ++i) {
    const double number = numbers.values[i] == numbers.values[i] ? numbers.values[i] : 0.0;
    const auto whole = static_cast<std::int64_t>(std::floor(std::clamp(number, form.low, form.high) + 0.5));
    for (int byte = 0; byte < form.bytes; ++byte) {
      const int place = form.big_endian ? form.bytes - 1 - byte : byte;
      result += static_cast<char>((static_cast<std::uint64_t>(whole) >> (8 * place)) & 0xff);
    }
  }
  return result;
}

// A number as it is; a vector in its brackets, and a blank.
std::string text_of(const Numbers& numbers) {
  if (numbers.size == 1) return fmt::format("{:g}", numbers.values[0]);
  std::string result = "<";
  for (std::size_t i = 0; i < numbers.size; ++i) result += fmt::format("{}{:g}", i == 0 ? "" : ",", numbers.values[i]);
  return result + "> ";
}

bool accept_comma(DataReader& data) {
  const bool found = data.peek().is(Punctuation::comma);
  if (found) data.take();
  return found;
}

}  // namespace

void Interpreter::run_fopen(const Token& word) {
  const Token name = take_identifier(word);
  const Scopes::Binding* before = scopes_.find(name.symbol);
  if (before != nullptr && !std::holds_alternative<std::shared_ptr<DataFile>>(*before->slot)) {
    fail(name.location, "expected a name that is not declared yet after '#fopen', found " +
                            std::string(kind_name(*before->slot)) + " '" + std::string(name.text) + "'");
  }
  const Token& at = peek();
  const std::string path = parse_path(*this);
  const Token& mode = peek();
  if (!mode.is(Keyword::read) && !mode.is(Keyword::write) && !mode.is(Keyword::append)) {
    fail(mode.location, "expected 'read', 'write' or 'append' after the name of the file, found " + describe_next());
  }
  take();
  if (before != nullptr) close_data_file(*std::get<std::shared_ptr<DataFile>>(*before->slot), name.location);
  auto file = std::make_shared<DataFile>();
  if (mode.is(Keyword::read)) {
    file->reader = std::make_unique<DataReader>(*open_for_reading(path, at.location), symbols_);
  } else {
    const SourceFiles::Result place = files_.place_for_writing(path);
    if (place.status != SourceFiles::Status::found) {
      fail(at.location, "'" + place.path +
                            "' may not be written: a scene may write files where its permissions allow, " +
                            "which is the current folder and below unless others are given");
    }
    check_place(place.path, path, mode.is(Keyword::append), at.location);
    file->writer = std::make_unique<DataWriter>(place.path, mode.is(Keyword::append));
    if (!file->writer->is_open()) fail(at.location, "'" + path + "' cannot be written");
    std::erase_if(written_files_, [](const std::weak_ptr<DataFile>& old) { return old.expired(); });
    written_files_.push_back(file);
  }
  *scopes_.target(name.symbol, false) = std::move(file);
}

const SourceFile* Interpreter::open_for_reading(const std::string& path, const Location& at) {
  return found_file(files_.read_data(path, *frames_.back().file->source), path, at).file;
}

void Interpreter::run_fclose(const Token& word) {
  const Token name = take_identifier(word);
  const Scopes::Binding* binding = scopes_.find(name.symbol);
  const auto* file = binding != nullptr ? std::get_if<std::shared_ptr<DataFile>>(binding->slot.get()) : nullptr;
  if (file == nullptr) {
    warn(name.location, "'" + std::string(name.text) + "' is no open file, so '#fclose' changes nothing");
    return;
  }
  close_data_file(**file, name.location);
  scopes_.remove(name.symbol);
}

// Whether a file may be written there: what others have made stays, and a scene cannot fill a disk.
void Interpreter::check_place(const std::string& path, const std::string& name, bool append, const Location& at) {
  if (!made_files_.contains(path) && !files_.may_replace(path)) {
    fail(at, "'" + name +
                 "' is there already and is not what a scene has written, so it is not replaced: permissions of "
                 "'--permissions' allow it");
  }
  made_files_.insert(path);
  if (made_files_.size() > kMostFiles) {
    fail_finally(at, "this scene writes too many files (limit " + std::to_string(kMostFiles) + ")");
  }
  std::error_code error;
  const std::uintmax_t before = append ? std::filesystem::file_size(path, error) : 0;
  if (!error) count_written(before, at);
}

void Interpreter::count_written(std::uint64_t bytes, const Location& at) {
  written_bytes_ += bytes;
  if (written_bytes_ <= kMostWritten) return;
  fail_finally(at, "this scene writes too much (limit " + std::to_string(kMostWritten >> 20) + " MiB)");
}

void Interpreter::close_data_file(DataFile& file, const Location& at) {
  if (!file.writer) return;
  const std::string path = file.writer->path().string();
  const bool written = file.writer->finish();
  file.writer.reset();
  files_.forget(path);
  if (!written) fail(at, "'" + path + "' cannot be written");
}

void Interpreter::close_data_files() {
  for (const std::weak_ptr<DataFile>& file : written_files_) {
    if (const auto open = file.lock()) close_data_file(*open, peek().location);
  }
}

void Interpreter::discard_data_files() {
  for (const std::weak_ptr<DataFile>& file : written_files_) {
    if (const auto open = file.lock()) open->writer.reset();
  }
}

// `(Name`
std::shared_ptr<DataFile> Interpreter::take_data_file(const Token& word, Token& name) {
  expect(Punctuation::left_paren, "after", word.text);
  name = peek();
  const Value* value = peek_value();
  const auto* file = value != nullptr ? std::get_if<std::shared_ptr<DataFile>>(value) : nullptr;
  if (file == nullptr) fail(name.location, "expected a file that '#fopen' has opened, found " + describe_next());
  std::shared_ptr<DataFile> result = *file;
  const bool reads = word.is(Keyword::read);
  if (reads ? !result->reader : !result->writer) {
    fail(name.location, "'" + std::string(name.text) + "' is not open for " + (reads ? "reading" : "writing"));
  }
  take_binding();
  return result;
}

void Interpreter::run_read(const Token& word) {
  Token handle;
  const std::shared_ptr<DataFile> file = take_data_file(word, handle);
  bool ended = false;
  // The names are taken as they stand: an element that has no value yet may get one.
  const auto skip_raw_comma = [this] {
    unsettle();
    if (raw_next().is(Punctuation::comma)) take_raw();
  };
  skip_raw_comma();
  while (!raw_next().is(Punctuation::right_paren)) {
    const Target target = parse_target(word);
    if (!ended) {
      std::optional<Value> value = parse_datum(*file->reader);
      // POV-Ray looks for a comma and finds the end; behind a comma it does not look on.
      ended = !value || (!accept_comma(*file->reader) && file->reader->peek().is_end());
      if (value) store(target, std::move(*value));
    }
    skip_raw_comma();
  }
  take_raw();
  // What is behind the last value of a file is not there: `defined` tells.
  if (ended) scopes_.remove(handle.symbol);
}

// A number, a vector or a string; nothing at the end of the file.
std::optional<Value> Interpreter::parse_datum(DataReader& data) {
  const Token first = data.peek();
  if (first.is_end()) return std::nullopt;
  if (first.kind == TokenKind::string) return unescape(*this, data.take());
  Numbers numbers;
  if (!first.is(Punctuation::less)) {
    numbers.values[0] = parse_data_number(data);
    return numbers;
  }
  data.take();
  numbers.size = 0;
  while (numbers.size < 2 || (numbers.size < 5 && !data.peek().is(Punctuation::greater))) {
    numbers.values[numbers.size++] = parse_data_number(data);
    accept_comma(data);
  }
  const Token closing = data.take();
  if (!closing.is(Punctuation::greater)) {
    fail(closing.location, "expected '>' to close the vector, found " + describe(closing));
  }
  if (numbers.size == 5) {  // POV-Ray keeps these as colours
    numbers.is_color = true;
    for (double& value : numbers.values) value = static_cast<float>(value);
  }
  return numbers;
}

double Interpreter::parse_data_number(DataReader& data) {
  while (data.peek().is(Punctuation::plus)) data.take();
  const bool negative = data.peek().is(Punctuation::dash);
  if (negative) data.take();
  const Token token = data.take();
  if (token.kind != TokenKind::number) {
    fail(token.location, "expected a number, a vector or a string in the file, found " + describe(token));
  }
  return negative ? -token.number : token.number;
}

void Interpreter::run_write(const Token& word) {
  Token handle;
  const std::shared_ptr<DataFile> file = take_data_file(word, handle);
  const BinaryForm* binary = nullptr;
  while (!peek().is(Punctuation::right_paren)) {
    const Token& at = peek();
    if (at.is(Punctuation::comma)) {
      take();
      binary = nullptr;
      continue;
    }
    std::string text;
    if (const BinaryForm* form = at.kind == TokenKind::keyword ? find_binary(at.keyword) : nullptr) {
      take();
      binary = form;
    } else if (at_string(*this)) {
      text = parse_string(*this);
      binary = nullptr;
    } else if (at_expression(*this) && word_kind(at.keyword) != WordKind::color) {
      const Numbers numbers = parse_sum(*this, 1);
      text = binary != nullptr ? bytes_of(numbers, *binary) : text_of(numbers);
    } else {
      fail(at.location, "expected a number, a vector or a string to write, found " + describe_next());
    }
    count_written(text.size(), at.location);
    if (!file->writer->write(text)) fail(at.location, "the file cannot be written");
  }
  take();
}

}  // namespace firstlight::parser
