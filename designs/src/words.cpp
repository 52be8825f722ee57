#include "words.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "parapet/math/units.hpp"

namespace parapet::designs {
namespace {

// Units that people write although Parapet does not take them.
constexpr std::array<std::string_view, 9> foreign_units{"_degrees", "_rad", "_kpa", "_hpa", "_mm",
                                                        "_cm",      "_km",  "_ms",  "_min"};

std::string_view stem(std::string_view word) {
  for (const std::string_view unit : foreign_units) {
    if (word.ends_with(unit)) return word.substr(0, word.size() - unit.size());
  }
  return math::without_unit(word);
}

/// Edits (insert, delete, replace, swap neighbours) that turn one word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), previous(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({previous[j] + 1, row[j - 1] + 1, replace});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    std::swap(before, previous);
    std::swap(previous, row);
  }
  return previous[b.size()];
}

}  // namespace

std::string last_key(const std::string& pointer) {
  std::string rest = pointer;
  while (!rest.empty()) {
    const std::size_t slash = rest.rfind('/');
    if (slash == std::string::npos) return rest;
    std::string token = rest.substr(slash + 1);
    if (token.find_first_not_of("0123456789") != std::string::npos) return token;
    rest.erase(slash);
  }
  return "";
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance =
        std::min(edit_distance(word, candidate), edit_distance(stem(word), stem(candidate)) + 1);
    if (distance < best_distance && distance < std::max(word.size(), candidate.size())) {
      best_distance = distance;
      best = candidate;
    }
  }
  if (!best.empty() || word.size() < 4) return best;
  for (const std::string& candidate : candidates) {  // a beginning is near too
    const bool begins = candidate.starts_with(word) && candidate[word.size()] == '_';
    if (begins && (best.empty() || candidate.size() < best.size())) best = candidate;
  }
  return best;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string best = nearest_word(word, candidates);
  return best.empty() ? "" : "; did you mean \"" + best + "\"?";
}

}  // namespace parapet::designs
