#include "opening_text.hpp"

#include <fmt/format.h>

#include "markdown.hpp"
#include "parapet/reports/page_one.hpp"

namespace parapet::reports {
namespace {

/// One line for each quantity, or all on one where there would be too many.
std::string quantities(const std::vector<PageOneLine>& lines, std::size_t most,
                       const std::string& heading, bool bold) {
  std::vector<std::string> words;
  for (const PageOneLine& line : lines) {
    const std::string text = bold ? "**" + line.text + "**" : line.text;
    words.push_back(
        fmt::format("{}: {}{}{}", line.label, text, line.asked.empty() ? "" : ", ", line.asked));
  }
  if (words.empty()) return "";
  if (words.size() <= most) {
    std::string text;
    for (const std::string& one : words) text += "- " + one + "\n";
    return text;
  }
  return "- " + heading + fmt::format("{}\n", fmt::join(words, "; "));
}

std::string item(const std::string& words) {
  return words.empty() ? "" : "- " + words + "\n";
}

/// The head of a sentence, up to its colon, in bold.
std::string strong_head(const std::string& words) {
  const std::size_t colon = words.find(':');
  if (colon == std::string::npos) return words;
  return "**" + words.substr(0, colon) + "**" + words.substr(colon);
}

}  // namespace

std::string opening_section(const Recommendation& advice) {
  const PageOne page = page_one(advice);
  std::string text = "# " + page.title + "\n\n";
  if (!page.instead.empty()) return text + page.instead + "\n\n";
  text += fmt::format("**{}** (design {}).\n\n", page.arrangement, page.design);
  if (!page.sketch.empty()) {
    text += fmt::format("```\n{}\n```\n\n", fmt::join(page.sketch, "\n"));
  }
  text += "What a repeat of it would give, with 95 % intervals:\n\n";
  text += quantities(page.performance, 3, "objectives: ", true);
  text += quantities(page.limits, 1, "limits: ", false);
  text += quantities(page.loads, 0, "", false);
  text += item(page.probability_words) + item(page.chosen) + item(page.ties) + item(page.bounds);
  return text + item(page.grid) + item(strong_head(page.verdict_words)) + "\n";
}

}  // namespace parapet::reports
