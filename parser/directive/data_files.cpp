// #fopen, #read, #write, #fclose. [POV-Ray 3.7 manual, "File I/O Directives"]
#include "parser/directive/data_files.h"

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

void DataFiles::run_fopen(const Token& word) {
  const Token name = in_.take_identifier(word);
  const Scopes::Binding* before = in_.scopes().find(name.symbol);
  if (before != nullptr && !std::holds_alternative<std::shared_ptr<DataFile>>(*before->slot)) {
    in_.fail(name.location, "expected a name that is not declared yet after '#fopen', found " +
                                std::string(kind_name(*before->slot)) + " '" + std::string(name.text) + "'");
  }
  const Token& at = in_.peek();
  const std::string path = parse_path(in_);
  const Token& mode = in_.peek();
  if (!mode.is(Keyword::read) && !mode.is(Keyword::write) && !mode.is(Keyword::append)) {
    in_.fail(mode.location,
             "expected 'read', 'write' or 'append' after the name of the file, found " + in_.describe_next());
  }
  in_.take();
  if (before != nullptr) close(*std::get<std::shared_ptr<DataFile>>(*before->slot), name.location);
  auto file = std::make_shared<DataFile>();
  if (mode.is(Keyword::read)) {
    file->reader = std::make_unique<DataReader>(*open_for_reading(path, at.location), in_.symbols());
  } else {
    const SourceFiles::Result place = in_.files().place_for_writing(path);
    if (place.status != SourceFiles::Status::found) {
      in_.fail(at.location, "'" + place.path +
                                "' may not be written: a scene may write files where its permissions allow, " +
                                "which is the current folder and below unless others are given");
    }
    check_place(place.path, path, mode.is(Keyword::append), at.location);
    file->writer = std::make_unique<DataWriter>(place.path, mode.is(Keyword::append));
    if (!file->writer->is_open()) in_.fail(at.location, "'" + path + "' cannot be written");
    std::erase_if(written_files_, [](const std::weak_ptr<DataFile>& old) { return old.expired(); });
    written_files_.push_back(file);
  }
  *in_.scopes().target(name.symbol, false) = std::move(file);
}

const SourceFile* DataFiles::open_for_reading(const std::string& path, const Location& at) {
  return in_.found_file(in_.files().read_data(path, in_.frame().file->source()), path, at).file;
}

void DataFiles::run_fclose(const Token& word) {
  const Token name = in_.take_identifier(word);
  const Scopes::Binding* binding = in_.scopes().find(name.symbol);
  const auto* file = binding != nullptr ? std::get_if<std::shared_ptr<DataFile>>(binding->slot.get()) : nullptr;
  if (file == nullptr) {
    in_.warn(name.location, "'" + std::string(name.text) + "' is no open file, so '#fclose' changes nothing");
    return;
  }
  close(**file, name.location);
  in_.scopes().remove(name.symbol);
}

// Whether a file may be written there: what others have made stays, and a scene cannot fill a disk.
void DataFiles::check_place(const std::string& path, const std::string& name, bool append, const Location& at) {
  if (!made_files_.contains(path) && !in_.files().may_replace(path)) {
    in_.fail(at, "'" + name +
                     "' is there already and is not what a scene has written, so it is not replaced: permissions of "
                     "'--permissions' allow it");
  }
  made_files_.insert(path);
  if (made_files_.size() > kMostFiles) {
    in_.fail_finally(at, "this scene writes too many files (limit " + std::to_string(kMostFiles) + ")");
  }
  std::error_code error;
  const std::uintmax_t before = append ? std::filesystem::file_size(path, error) : 0;
  if (!error) count_written(before, at);
}

void DataFiles::count_written(std::uint64_t bytes, const Location& at) {
  written_bytes_ += bytes;
  if (written_bytes_ <= kMostWritten) return;
  in_.fail_finally(at, "this scene writes too much (limit " + std::to_string(kMostWritten >> 20) + " MiB)");
}

void DataFiles::close(DataFile& file, const Location& at) {
  if (!file.writer) return;
  const std::string path = file.writer->path().string();
  const bool written = file.writer->finish();
  file.writer.reset();
  in_.files().forget(path);
  if (!written) in_.fail(at, "'" + path + "' cannot be written");
}

void DataFiles::close_all() {
  for (const std::weak_ptr<DataFile>& file : written_files_) {
    if (const auto open = file.lock()) close(*open, in_.peek().location);
  }
}

void DataFiles::discard_all() {
  for (const std::weak_ptr<DataFile>& file : written_files_) {
    if (const auto open = file.lock()) open->writer.reset();
  }
}

// `(Name`
std::shared_ptr<DataFile> DataFiles::take_data_file(const Token& word, Token& name) {
  in_.expect(Punctuation::left_paren, "after", word.text);
  name = in_.peek();
  const Value* value = in_.peek_value();
  const auto* file = value != nullptr ? std::get_if<std::shared_ptr<DataFile>>(value) : nullptr;
  if (file == nullptr)
    in_.fail(name.location, "expected a file that '#fopen' has opened, found " + in_.describe_next());
  std::shared_ptr<DataFile> result = *file;
  const bool reads = word.is(Keyword::read);
  if (reads ? !result->reader : !result->writer) {
    in_.fail(name.location, "'" + std::string(name.text) + "' is not open for " + (reads ? "reading" : "writing"));
  }
  in_.take_binding();
  return result;
}

void DataFiles::run_read(const Token& word) {
  Token handle;
  const std::shared_ptr<DataFile> file = take_data_file(word, handle);
  bool ended = false;
  // The names are taken as they stand: an element that has no value yet may get one.
  const auto skip_raw_comma = [this] {
    in_.unsettle();
    if (in_.raw_next().is(Punctuation::comma)) in_.take_raw();
  };
  skip_raw_comma();
  while (!in_.raw_next().is(Punctuation::right_paren)) {
    const Declarations::Target target = in_.declarations().parse_target(word);
    if (!ended) {
      std::optional<Value> value = parse_datum(*file->reader);
      // POV-Ray looks for a comma and finds the end; behind a comma it does not look on.
      ended = !value || (!accept_comma(*file->reader) && file->reader->peek().is_end());
      if (value) in_.declarations().store(target, std::move(*value));
    }
    skip_raw_comma();
  }
  in_.take_raw();
  // The name of a file is undeclared behind its last value: `defined` tells.
  if (ended) in_.scopes().remove(handle.symbol);
}

// A number, a vector or a string; nothing at the end of the file.
std::optional<Value> DataFiles::parse_datum(DataReader& data) {
  const Token first = data.peek();
  if (first.is_end()) return std::nullopt;
  if (first.kind == TokenKind::string) return unescape(in_, data.take());
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
    in_.fail(closing.location, "expected '>' to close the vector, found " + describe(closing));
  }
  if (numbers.size == 5) {  // POV-Ray keeps these as colours
    numbers.is_color = true;
    for (double& value : numbers.values) value = static_cast<float>(value);
  }
  return numbers;
}

double DataFiles::parse_data_number(DataReader& data) {
  while (data.peek().is(Punctuation::plus)) data.take();
  const bool negative = data.peek().is(Punctuation::dash);
  if (negative) data.take();
  const Token token = data.take();
  if (token.kind != TokenKind::number) {
    in_.fail(token.location, "expected a number, a vector or a string in the file, found " + describe(token));
  }
  return negative ? -token.number : token.number;
}

void DataFiles::run_write(const Token& word) {
  Token handle;
  const std::shared_ptr<DataFile> file = take_data_file(word, handle);
  const BinaryForm* binary = nullptr;
  while (!in_.peek().is(Punctuation::right_paren)) {
    const Token& at = in_.peek();
    if (at.is(Punctuation::comma)) {
      in_.take();
      binary = nullptr;
      continue;
    }
    std::string text;
    if (const BinaryForm* form = at.kind == TokenKind::keyword ? find_binary(at.keyword) : nullptr) {
      in_.take();
      binary = form;
    } else if (at_string(in_)) {
      text = parse_string(in_);
      binary = nullptr;
    } else if (at_expression(in_) && word_kind(at.keyword) != WordKind::color) {
      const Numbers numbers = parse_sum(in_, 1);
      text = binary != nullptr ? bytes_of(numbers, *binary) : text_of(numbers);
    } else {
      in_.fail(at.location, "expected a number, a vector or a string to write, found " + in_.describe_next());
    }
    count_written(text.size(), at.location);
    if (!file->writer->write(text)) in_.fail(at.location, "the file cannot be written");
  }
  in_.take();
}

}  // namespace firstlight::parser
