#pragma once

#include "parser/text/source.h"
#include "parser/text/token.h"
#include "parser/text/value.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace firstlight::parser {

class DataReader;
class Interpreter;

/// `#fopen`, `#read`, `#write`, `#fclose`: the files of numbers and strings that a scene reads and writes.
/// Source   [POV-Ray 3.7 manual, "File I/O Directives"]
class DataFiles {
 public:
  static constexpr std::uint64_t kMostWritten = 1u << 30;  // bytes, by all of a scene's #write; with what it appends to
  static constexpr std::size_t kMostFiles = 1000;          // that a scene writes

  explicit DataFiles(Interpreter& in) : in_(in) {}

  void run_fopen(const Token& word);
  void run_fclose(const Token& word);
  void run_read(const Token& word);
  void run_write(const Token& word);

  /// Puts a file that was written in its place.
  void close(DataFile& file, const Location& at);
  void close_all();
  /// Leaves no file half written.
  void discard_all();

 private:
  std::shared_ptr<DataFile> take_data_file(const Token& word, Token& name);
  const SourceFile* open_for_reading(const std::string& path, const Location& at);
  void check_place(const std::string& path, const std::string& name, bool append, const Location& at);
  void count_written(std::uint64_t bytes, const Location& at);
  std::optional<Value> parse_datum(DataReader& data);
  double parse_data_number(DataReader& data);

  Interpreter& in_;
  std::vector<std::weak_ptr<DataFile>> written_files_;
  std::uint64_t written_bytes_ = 0;
  std::set<std::string> made_files_;
};

}  // namespace firstlight::parser
