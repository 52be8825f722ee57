/// Page one of a recommendation: what an engineer reads before signing. recommendation.md, the top
/// of report.html and the key "page_one" of recommendation.json are all written from it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parapet/reports/recommendation.hpp"

namespace parapet::reports {

/// A quantity with what a repeat of the built design would give of it.
struct PageOneLine {
  std::string label;               ///< "launch length"
  std::string text;                ///< "0.091 ± 0.017 m", "0.998 (0.991 to 1)", "0.1876 m"
  std::string asked;               ///< "to be maximized", "at most 0.1 m"; empty for a load
  std::optional<double> mean;      ///< in the unit of its key
  std::optional<double> lower_95;  ///< empty: not known
  std::optional<double> upper_95;
  std::optional<double> probability;  ///< of a limit: that a repeat meets it
};

/// The page. Sentences are whole; texts that nothing is to be said of are empty.
struct PageOne {
  std::string title;                     ///< "Recommended arrangement: NAME"
  std::string design;                    ///< id; empty when there is none to show
  std::string arrangement;               ///< its variables in words
  std::vector<std::string> sketch;       ///< lines of a drawing in characters; may be empty
  std::string instead;                   ///< why nothing is recommended
  std::vector<PageOneLine> performance;  ///< the objectives
  std::vector<PageOneLine> limits;       ///< the constraints on metrics
  std::vector<PageOneLine> loads;        ///< design force and moment of each barrier
  std::optional<double> probability;     ///< that a repeat meets every limit
  std::string probability_words;
  std::string chosen;   ///< the rule in a few words, with its share of the draws
  std::string ties;     ///< designs that cannot be told from it
  std::string bounds;   ///< variables at the ends of their ranges
  std::string grid;     ///< what is known of the particle spacing's part
  std::string verdict;  ///< "confirmed", "narrow", "untested", "refuted" or "none" (nothing picked)
  std::string verdict_words;
};

/// At most this many lines of Markdown.
constexpr int page_one_lines = 25;

/// The page of a recommendation. Texts of the spec are taken as they stand in it: of one that is
/// safe for Markdown the page is safe too.
PageOne page_one(const Recommendation& recommendation);

}  // namespace parapet::reports
