/// The names that an expression may use, and terms written out.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "findings.hpp"
#include "parapet/designs/study_spec.hpp"
#include "study_metrics.hpp"

namespace parapet::designs {

/// An expression with its terms written out, and the metrics that it hangs on.
struct WrittenOut {
  std::string formula;
  std::vector<std::string> metrics;
  std::map<std::string, double> values_when_absent;  ///< of these metrics, those of terms included
};

/// Where an expression stands.
struct ExpressionPlace {
  std::string goal;        ///< pointer of the objective, constraint or term
  std::string expression;  ///< pointer of the expression itself
};

/// The symbols of a study's expressions: design variables, metrics and terms.
class Symbols {
 public:
  /// All must outlive it.
  Symbols(const Metrics& metrics, const std::vector<Variable>& variables,
          const std::vector<Term>& terms);

  /// Reads an expression with its `values_when_absent`; adds what is wrong with it, or with the
  /// values that it gives for metrics that do not exist. The formula is empty then.
  WrittenOut read(const std::string& expression, const std::map<std::string, double>& absent,
                  const ExpressionPlace& place, Findings& findings) const;

 private:
  const Term* term(const std::string& name) const;
  std::string allowed_words() const;

  const Metrics& metrics_;
  const std::vector<Term>& terms_;
  std::vector<std::string> variables_;
};

/// Keeps a text that grows with every term of terms from filling the memory.
constexpr std::size_t longest_formula = 20000;

}  // namespace parapet::designs
