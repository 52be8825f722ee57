// The scorecards as a person reads them on a terminal.
#include <fmt/format.h>

#include <algorithm>

#include "parapet/validation/suite.hpp"

namespace parapet::validation {

std::string scorecard_text(const std::vector<Scorecard>& cards) {
  std::string text;
  int met = 0, missed = 0, failed = 0;
  for (const Scorecard& card : cards) {
    met += card.count(Verdict::met);
    missed += card.count(Verdict::missed);
    failed += card.failure.empty() ? 0 : 1;
    text += fmt::format("\n{}: {}\n", card.name, card.title);
    std::size_t what = 0, value = 0;
    for (const Measure& m : card.measures) {
      what = std::max(what, m.what.size());
      value = std::max(value, value_text(m.value, m.unit).size());
    }
    for (const Measure& m : card.measures) {
      const Verdict verdict = m.verdict();
      text += fmt::format("  {:<8}  {:<{}}  {:>{}}  {}\n",
                          verdict == Verdict::measured ? "" : to_string(verdict), m.what, what,
                          value_text(m.value, m.unit), value, limit_text(m));
      if (verdict == Verdict::missed && !m.explanation.empty()) {
        text += fmt::format("            {}\n", m.explanation);
      }
    }
    if (!card.failure.empty()) text += fmt::format("  FAILED    {}\n", card.failure);
  }
  text += fmt::format("\n{} limits met, {} missed", met, missed);
  if (failed > 0) text += fmt::format(", {} cases failed", failed);
  return text + "\n";
}

}  // namespace parapet::validation
