#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

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
                                 const std::vector<std::string>& names, const std::string& known) {
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

/// Calls f(begin, length) for each name; the e of 1e-3 is none.
template <typename F>
void for_each_name(const std::string& expression, const F& f) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const auto digit = [](char c) { return (c >= '0' && c <= '9') || c == '.'; };
  std::size_t at = 0;
  while (at < expression.size()) {
    const std::size_t begin = at;
    if (letter(expression[at])) {
      while (at < expression.size() && (letter(expression[at]) || digit(expression[at]))) ++at;
      f(begin, at - begin);
    } else if (digit(expression[at])) {
      while (at < expression.size() && digit(expression[at])) ++at;
      if (at < expression.size() && (expression[at] == 'e' || expression[at] == 'E')) ++at;
    } else {
      ++at;
    }
  }
}

}  // namespace

std::vector<std::string> names_in(const std::string& expression) {
  std::vector<std::string> names;
  for_each_name(expression, [&](std::size_t begin, std::size_t length) {
    std::string name = expression.substr(begin, length);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  });
  return names;
}

std::string with_names_replaced(const std::string& expression,
                                const std::map<std::string, std::string>& replacements) {
  std::string result;
  std::size_t written = 0;
  for_each_name(expression, [&](std::size_t begin, std::size_t length) {
    const auto found = replacements.find(expression.substr(begin, length));
    if (found == replacements.end()) return;
    result.append(expression, written, begin - written).append("(" + found->second + ")");
    written = begin + length;
  });
  return result.append(expression, written);
}

ExpressionProblem expression_problem(const std::string& expression,
                                     const std::vector<std::string>& names, std::string known) {
  if (known.empty()) known = "a formula of " + joined(names);
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
      return {"does not depend on any variable", known};
    }
  } catch (const mu::ParserError& error) {
    return is_comma ? unmeant : parser_problem(expression, error, names, known);
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
    const ExpressionProblem found =
        parser_problem(expression, error, names, "a formula of " + joined(names));
    throw fail(found.problem, found.allowed);
  }
  std::string values;
  for (const auto& [name, value] : design) {
    values += (values.empty() ? "" : ", ") + name + " = " + Json(value).dump();
  }
  throw fail("has no finite value at " + values, "a formula with a value for every design");
}

struct Formula::Parser {
  std::vector<double> values;
  mu::Parser parser;
};

Formula::Formula(const std::string& expression, const std::vector<std::string>& names)
    : parser_(std::make_unique<Parser>()) {
  parser_->values.assign(names.size(), 1.0);
  try {
    for (std::size_t k = 0; k < names.size(); ++k) {
      parser_->parser.DefineVar(names[k], &parser_->values[k]);
    }
    parser_->parser.SetExpr(expression);
    parser_->parser.Eval();
  } catch (const mu::ParserError& error) {
    const ExpressionProblem found =
        parser_problem(expression, error, names, "a formula of " + joined(names));
    throw InputError({{"", "", "\"" + expression + "\"", found.problem, found.allowed}});
  }
}

Formula::~Formula() = default;
Formula::Formula(Formula&&) noexcept = default;
Formula& Formula::operator=(Formula&&) noexcept = default;

double Formula::value(const std::vector<double>& values) {
  if (values.size() != parser_->values.size()) {
    throw std::invalid_argument("a formula of " + std::to_string(parser_->values.size()) +
                                " values is given " + std::to_string(values.size()));
  }
  std::copy(values.begin(), values.end(), parser_->values.begin());
  try {
    return parser_->parser.Eval();
  } catch (const mu::ParserError&) {  // such as a division by 0, where muParser reports it
    return std::numeric_limits<double>::quiet_NaN();
  }
}

}  // namespace parapet::designs
