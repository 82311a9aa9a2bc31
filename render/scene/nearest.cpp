#include "render/scene/nearest.h"

#include <algorithm>
#include <cctype>

namespace firstlight::render {

namespace {

// Twice the number of edits: letters that are put in, left out, replaced, or swapped with their neighbour. A letter of
// another case is half an edit.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1), above(row), above_that(row);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = 2 * j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    above_that.swap(above);
    above.swap(row);
    row[0] = 2 * i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const char x = a[i - 1], y = b[j - 1];
      const bool alike = std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
      const std::size_t replaced = above[j - 1] + (x == y ? 0u : alike ? 1u : 2u);
      row[j] = std::min({replaced, above[j] + 2, row[j - 1] + 2});
      const bool swapped = i > 1 && j > 1 && x == b[j - 2] && a[i - 2] == y;
      if (swapped) row[j] = std::min(row[j], above_that[j - 2] + 2);
    }
  }
  return row.back();
}

bool equal_but_for_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string>& known) {
  const std::size_t most_edits = std::max<std::size_t>(1, (word.size() + 1) / 3);
  std::string best;
  std::size_t fewest = 2 * most_edits + 1;
  for (const std::string& candidate : known) {
    const std::size_t longer = std::max(candidate.size(), word.size()),
                      shorter = std::min(candidate.size(), word.size());
    if (longer - shorter > most_edits) continue;
    const std::size_t edits =
        equal_but_for_case(word, candidate) ? (word == candidate ? 0 : 1) : distance(word, candidate);
    if (edits >= fewest) continue;
    fewest = edits;
    best = candidate;
  }
  return best;
}

}  // namespace firstlight::render
