#include "did_you_mean.hpp"

#include <algorithm>
#include <numeric>

namespace footprint_collision_predictor::tools {
namespace {

/// Number of letters to insert, delete or replace (Levenshtein).
std::size_t typingErrors(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string didYouMean(const std::string& given, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t fewest = given.size() / 2 + 1;  // more than half of it wrong is another word
  for (const auto& candidate : candidates) {
    const std::size_t errors = typingErrors(given, candidate);
    if (errors >= fewest) continue;
    fewest = errors;
    best = candidate;
  }
  return best;
}

}  // namespace footprint_collision_predictor::tools
