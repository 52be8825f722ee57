// The pages of the suite, an index and one for each case: texts from validation/pages with every
// figure taken from the scorecards.
#include <fmt/format.h>

#include <map>
#include <optional>
#include <stdexcept>

#include "case.hpp"
#include "embedded.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parapet/validation/suite.hpp"

namespace parapet::validation {
namespace {

using Cards = std::map<std::string, Scorecard, std::less<>>;

Cards read_cards(const std::filesystem::path& folder) {
  Cards cards;
  for (const Case& c : all_cases()) {
    const std::filesystem::path file = folder / (std::string(c.name) + ".json");
    if (!std::filesystem::exists(file)) continue;
    try {
      const auto json = nlohmann::ordered_json::parse(records::read_file(file));
      cards.emplace(c.name, scorecard_from_json(json));
    } catch (const nlohmann::json::exception& error) {
      throw std::invalid_argument(file.string() + ": " + error.what());
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(file.string() + ": " + error.what());
    }
  }
  return cards;
}

std::string measures_table(const Scorecard& card) {
  std::string text = "| measured | value | limit | verdict |\n|---|---:|---|---|\n";
  for (const Measure& m : card.measures) {
    std::string limit = limit_text(m);
    if (!m.reason.empty()) limit += fmt::format("{}{}", limit.empty() ? "" : ": ", m.reason);
    const Verdict verdict = m.verdict();
    std::string judged = verdict == Verdict::measured ? "" : to_string(verdict);
    if (verdict == Verdict::missed) {
      judged = m.explanation.empty() ? "**missed**" : fmt::format("**missed**: {}", m.explanation);
    }
    text +=
        fmt::format("| {} | {} | {} | {} |\n", m.what, value_text(m.value, m.unit), limit, judged);
  }
  if (!card.failure.empty()) text += "\n**The case failed:** " + card.failure + "\n";
  return text;
}

std::string summary_table(const Cards& cards) {
  std::string text = "| case | limits met | missed |\n|---|---:|---:|\n";
  int met = 0, missed = 0;
  for (const Case& c : all_cases()) {
    const auto found = cards.find(c.name);
    if (found == cards.end()) {
      text += fmt::format("| {} | not run | |\n", c.title);
      continue;
    }
    const Scorecard& card = found->second;
    met += card.count(Verdict::met);
    missed += card.count(Verdict::missed);
    text += fmt::format(
        "| [{}]({}.md) | {} | {} |\n", c.title, c.name, card.count(Verdict::met),
        card.failure.empty() ? fmt::format("{}", card.count(Verdict::missed)) : "case failed");
  }
  return text + fmt::format("| **all** | **{}** | **{}** |\n", met, missed);
}

// Every limit that is missed, with its explanation.
std::string missed_table(const Cards& cards) {
  std::string text = "| case | measured | value | limit | why |\n|---|---|---:|---|---|\n";
  for (const Case& c : all_cases()) {
    const auto found = cards.find(c.name);
    if (found == cards.end()) continue;
    for (const Measure& m : found->second.measures) {
      if (m.verdict() != Verdict::missed) continue;
      text += fmt::format("| [{}]({}.md) | {} | {} | {} | {} |\n", c.name, c.name, m.what,
                          value_text(m.value, m.unit), limit_text(m), m.explanation);
    }
  }
  return text;
}

// "key" of this card or "case.key" of another: the value with its unit.
std::string value_of(const Cards& cards, const Scorecard* own, const std::string& name) {
  const std::size_t dot = name.find('.');
  const Scorecard* card = own;
  if (dot != std::string::npos) {
    const auto found = cards.find(name.substr(0, dot));
    card = found == cards.end() ? nullptr : &found->second;
  }
  const std::string key = dot == std::string::npos ? name : name.substr(dot + 1);
  const Measure* measure = card ? card->find(key) : nullptr;
  if (!measure)
    throw std::invalid_argument("a page asks for the figure \"" + name +
                                "\", which no scorecard has");
  return value_text(measure->value, measure->unit);
}

std::string filled(std::string_view text, const Cards& cards, const Scorecard* own) {
  std::string out;
  for (std::size_t from = 0;;) {
    const std::size_t open = text.find("{{", from);
    if (open == std::string_view::npos) return out + std::string(text.substr(from));
    const std::size_t close = text.find("}}", open);
    if (close == std::string_view::npos) throw std::invalid_argument("a page has {{ without }}");
    out += text.substr(from, open - from);
    const std::string name(text.substr(open + 2, close - open - 2));
    if (name == "summary") {
      out += summary_table(cards);
    } else if (name == "missed") {
      out += missed_table(cards);
    } else if (name == "table" && own) {
      out += measures_table(*own);
    } else {
      out += value_of(cards, own, name);
    }
    from = close + 2;
  }
}

}  // namespace

std::vector<Page> pages(const std::filesystem::path& folder) {
  const Cards cards = read_cards(folder);
  std::vector<Page> list{{"README.md", filled(embedded_text("introduction.md"), cards, nullptr)}};
  for (const Case& c : all_cases()) {
    const auto found = cards.find(c.name);
    if (found == cards.end()) continue;
    const std::string body =
        found->second.failure.empty()
            ? filled(embedded_text(std::string(c.name) + ".md"), cards, &found->second)
            : measures_table(found->second);
    list.push_back({std::string(c.name) + ".md",
                    fmt::format("# {}\n\n`parapet validate {}` - [all cases](README.md)\n\n{}",
                                c.title, c.name, body)});
  }
  return list;
}

}  // namespace parapet::validation
