/// A study of two objectives made by hand, in memory: what is judged and reported without a file.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>

#include "parapet/study/loaded_study.hpp"

namespace parapet::test {

/// Retention is to be maximised and the launch length (reach_m) minimised, under two scenarios; the
/// force has a limit of 100 N/m. A deflector has an angle, or there is none.
class TradeOff : public testing::Test {
 protected:
  TradeOff();

  /// A design without an angle has no deflector.
  static records::EvaluationRecord record(double height, std::optional<double> angle,
                                          double retention, double reach, double force,
                                          double spacing);

  void add(double height, std::optional<double> angle, double retention, double reach,
           double force = 50.0, double spacing = 0.01);

  /// The front 0001 (0.95, 0.30), 0002 (0.90, 0.12), 0003 (0.60, 0.10), 0004 (0.50, 0.02), and
  /// designs that must never be taken: dominated, infeasible, coarse.
  void add_front();

  /// A line of confirmations.jsonl: the pick, or a design near to it.
  void confirm(const std::string& pick, const std::string& role, const std::string& stage,
               double retention, double reach, double force);

  /// What pareto.json holds: estimates at the observed values, s.d. 0.01, and these probabilities
  /// of designs of the front.
  void estimate(const std::map<std::string, double>& probabilities);

  study::LoadedStudy study_;
};

}  // namespace parapet::test
