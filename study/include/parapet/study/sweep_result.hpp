/// A sweep's rows held against the published figures, and the file that keeps both.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/records/sweep_row.hpp"

namespace parapet::study {

/// How a computed value stands to a published one.
struct Agreement {
  /// Whether a computed value agrees with the published one.
  enum class Verdict { none, agrees, misses };
  Verdict verdict = Verdict::none;  ///< none: nothing published, or a bare value without a range
  std::optional<double> published;  ///< the published value, if a single one is stated
  std::optional<double> lower, upper;
  double distance = 0.0;  ///< out of the range, signed: negative below it; 0 inside
};

/// Compares a value (absent when the simulation has none) with one entry of `published`:
/// {"value": x} and/or {"lower": a, "upper": b}. A range with no computed value is a miss.
Agreement compare(const std::optional<double>& computed, const designs::Json& published);

/// The content of table3.json, format "parapet-sweep-result/1": metrics lie flat in each row (null
/// when absent), `paper` holds the published figures, `agreement` the verdict on each.
/// @param provenance stored as it is; null leaves it out
designs::Json sweep_json(const std::string& name, const std::string& source, double spacing,
                         const std::vector<records::SweepRowResult>& rows,
                         const designs::Json& provenance = nullptr);

}  // namespace parapet::study
