#include "parser/directive/data_file.h"

#include "parser/text/own_work.h"

#include <system_error>
#include <utility>

namespace firstlight::parser {

namespace fs = std::filesystem;

namespace {

constexpr int kMostDrafts = 100;  // that others may have left beside a file

}  // namespace

DataWriter::DataWriter(fs::path path, bool append) : path_(std::move(path)) {
  // "x": only a file that is not there yet, so that no link can lead elsewhere.
  for (int i = 0; i < kMostDrafts && stream_ == nullptr; ++i) {
    draft_ = path_;
    draft_ += ".part" + std::to_string(i);
    stream_ = std::fopen(draft_.c_str(), "wbx");
  }
  std::error_code error;
  is_own_ = !append || !fs::exists(path_, error) || is_own_work(path_);
  if (stream_ == nullptr || !append || !fs::exists(path_, error)) return;
  std::FILE* before = std::fopen(path_.c_str(), "rb");
  bool copied = before != nullptr;
  char block[4096];
  while (copied) {
    const std::size_t size = std::fread(block, 1, sizeof block, before);
    if (size == 0) break;
    copied = std::fwrite(block, 1, size, stream_) == size;
  }
  if (before != nullptr) {
    copied = copied && std::ferror(before) == 0;
    std::fclose(before);
  }
  if (!copied) discard();
}

DataWriter::~DataWriter() { discard(); }

void DataWriter::discard() {
  if (stream_ == nullptr) return;
  std::fclose(stream_);
  stream_ = nullptr;
  std::error_code ignored;
  fs::remove(draft_, ignored);
}

bool DataWriter::write(std::string_view text) {
  return std::fwrite(text.data(), 1, text.size(), stream_) == text.size();
}

bool DataWriter::finish() {
  if (stream_ == nullptr) return true;
  bool written = std::ferror(stream_) == 0 && std::fflush(stream_) == 0;
  if (written && is_own_) mark_own_work(fileno(stream_));
  written = std::fclose(stream_) == 0 && written;
  stream_ = nullptr;
  std::error_code error;
  if (written) fs::rename(draft_, path_, error);
  if (written && !error) return true;
  fs::remove(draft_, error);
  return false;
}

}  // namespace firstlight::parser
