#pragma once

#include "parser/text/lexer.h"

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace firstlight::parser {

/// Text that a scene reads with #read, token by token.
class DataReader {
 public:
  DataReader(const SourceFile& source, Symbols& symbols) : lexer_(source, symbols) {}
  const Token& peek() {
    if (!next_) next_ = lexer_.next();
    return *next_;
  }
  Token take() {
    const Token token = peek();
    next_.reset();
    return token;
  }

 private:
  Lexer lexer_;
  std::optional<Token> next_;
};

/// A file that a scene writes with #write. It is written beside its place and put there by finish(): nobody sees half
/// of it, and without finish() what was there before stays.
class DataWriter {
 public:
  /// Appends to a copy of what is at `path` already, if `append`.
  DataWriter(std::filesystem::path path, bool append);
  ~DataWriter();
  DataWriter(const DataWriter&) = delete;
  DataWriter& operator=(const DataWriter&) = delete;

  bool is_open() const { return stream_ != nullptr; }
  bool write(std::string_view text);
  bool finish();
  const std::filesystem::path& path() const { return path_; }

 private:
  void discard();

  std::filesystem::path path_, draft_;
  std::FILE* stream_ = nullptr;
  bool is_own_ = true;  // nothing of others is in it
};

/// A file that #fopen has declared: a reader or a writer.
class DataFile {
 public:
  std::unique_ptr<DataReader> reader;
  std::unique_ptr<DataWriter> writer;
};

}  // namespace firstlight::parser
