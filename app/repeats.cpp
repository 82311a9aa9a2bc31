#include "app/repeats.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace firstlight::app {

using render::Diagnostic;

bool Repeats::is_new(const Diagnostic& diagnostic) {
  if (diagnostic.severity != Diagnostic::Severity::warning) return true;
  auto found = entries_.find(diagnostic.message);
  if (found == entries_.end()) {
    if (entries_.size() == kMostTexts) return true;
    found = entries_.emplace(diagnostic.message, Entry{diagnostic, 0, {}, entries_.size()}).first;
  }
  Entry& entry = found->second;
  ++entry.times;
  return entry.places.size() < kMostPlaces &&
         entry.places.emplace(diagnostic.file, diagnostic.line, diagnostic.column).second;
}

render::Diagnostics Repeats::counts() const {
  std::vector<const Entry*> entries;
  for (const auto& [text, entry] : entries_) {
    if (entry.times > entry.places.size()) entries.push_back(&entry);
  }
  std::ranges::sort(entries, {}, &Entry::number);
  render::Diagnostics notes;
  for (const Entry* entry : entries) {
    Diagnostic note = entry->first;
    note.severity = Diagnostic::Severity::note;
    note.message = fmt::format("this warning came {} times{}", entry->times,
                               entry->places.size() > 1 ? ", here and at other places" : "");
    note.source_line.clear();
    notes.push_back(std::move(note));
  }
  return notes;
}

}  // namespace firstlight::app
