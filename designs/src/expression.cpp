#include <muParser.h>

#include <algorithm>
#include <cmath>

#include "findings.hpp"
#include "formula_grammar.hpp"
#include "study_parts.hpp"
#include "words.hpp"

namespace parapet::designs {
namespace {

/// A parser with the design's values bound to their names.
class BoundExpression {
 public:
  BoundExpression(const std::string& expression, const Design& design) : values_(design) {
    for (auto& [name, value] : values_) parser_.DefineVar(name, &value);
    parser_.SetExpr(expression);
  }

  double value() { return parser_.Eval(); }
  bool uses_any() { return !parser_.GetUsedVar().empty(); }

 private:
  Design values_;
  mu::Parser parser_;
};

ExpressionProblem parser_problem(const std::string& expression, const mu::ParserError& error,
                                 const std::vector<std::string>& names) {
  const std::string known = "a formula of " + joined(names);
  const std::size_t character = static_cast<std::size_t>(std::max(error.GetPos(), 0)) + 1;
  const std::string place =
      " at character " + std::to_string(std::min(character, expression.size() + 1));
  if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN) {
    return {"unknown symbol \"" + error.GetToken() + "\"" + place +
                did_you_mean(error.GetToken(), names),
            known};
  }
  std::string message = error.GetMsg();
  message = message.substr(0, message.find(" at position"));  // counted from 0, past the end
  while (!message.empty() && (message.back() == '.' || message.back() == '\n')) message.pop_back();
  return {"cannot be read" + place + ": " + message, known};
}

}  // namespace

ExpressionProblem expression_problem(const std::string& expression,
                                     const std::vector<std::string>& names) {
  // muParser takes more than anybody means: a = 0.1 as an assignment, 0,5 as a list of which the
  // last entry counts, a <= 0.1 as 0 or 1.
  ExpressionProblem unmeant = grammar_problem(expression);
  const bool is_comma = unmeant.problem.find("comma") != std::string::npos;
  Design design;
  for (const std::string& name : names) design[name] = 1.0;
  try {
    BoundExpression bound(expression, design);
    bound.value();
    if (!unmeant.problem.empty()) return unmeant;
    if (!bound.uses_any()) {
      return {"does not depend on any variable", "a formula of " + joined(names)};
    }
  } catch (const mu::ParserError& error) {
    return is_comma ? unmeant : parser_problem(expression, error, names);
  }
  return {};
}

double evaluate_expression(const std::string& expression, const Design& design) {
  const auto fail = [&](const std::string& problem, const std::string& allowed) {
    return InputError({{"", "", "\"" + expression + "\"", problem, allowed}});
  };
  try {
    const double value = BoundExpression(expression, design).value();
    if (std::isfinite(value)) return value;
  } catch (const mu::ParserError& error) {
    std::vector<std::string> names;
    for (const auto& [name, value] : design) names.push_back(name);
    const ExpressionProblem found = parser_problem(expression, error, names);
    throw fail(found.problem, found.allowed);
  }
  std::string values;
  for (const auto& [name, value] : design) {
    values += (values.empty() ? "" : ", ") + name + " = " + Json(value).dump();
  }
  throw fail("has no finite value at " + values, "a formula with a value for every design");
}

}  // namespace parapet::designs
