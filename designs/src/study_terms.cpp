#include "study_terms.hpp"

#include <algorithm>
#include <set>

#include "study_parts.hpp"
#include "words.hpp"

namespace parapet::designs {
namespace {

template <typename T>
bool has(const std::vector<T>& list, const T& wanted) {
  return std::find(list.begin(), list.end(), wanted) != list.end();
}

/// Adds a term's values to those of what uses it; two must not differ.
void merge(const Term& term, WrittenOut& into, const std::string& pointer, Findings& findings) {
  for (const auto& [metric, value] : term.values_when_absent) {
    const auto [known, added] = into.values_when_absent.try_emplace(metric, value);
    if (added || known->second == value) continue;
    findings.add(pointer + "/values_when_absent",
                 "gives " + metric + " the value " + rounded(known->second) + ", and the term " +
                     term.name + " the value " + rounded(value),
                 "one value for each metric");
  }
}

/// The members of `terms` as they are given.
struct Given {
  std::string expression;
  std::map<std::string, double> values_when_absent;
};

Given given_term(const Json& json) {
  if (json.is_string()) return {json.get<std::string>(), {}};
  Given given{.expression = json.at("expression").get<std::string>(), .values_when_absent = {}};
  if (json.contains("values_when_absent")) {
    given.values_when_absent = json.at("values_when_absent").get<std::map<std::string, double>>();
  }
  return given;
}

/// Reads terms one after the other, each after those that it uses.
class TermReader {
 public:
  TermReader(const Json& json, const Metrics& metrics, const std::vector<Variable>& variables,
             Findings& findings)
      : json_(json), metrics_(metrics), variables_(variables), findings_(findings) {}

  std::vector<Term> read() {
    for (const auto& [name, value] : json_.items()) read(name);
    std::sort(terms_.begin(), terms_.end(),
              [](const Term& a, const Term& b) { return a.name < b.name; });
    return std::move(terms_);
  }

 private:
  static std::string place(const std::string& name) { return child_pointer("/terms", name); }

  bool is_free(const std::string& name) {
    const bool variable = std::any_of(variables_.begin(), variables_.end(),
                                      [&](const Variable& one) { return one.name == name; });
    if (!variable && !metrics_.knows(name)) return true;
    findings_.add(place(name), variable ? "has the name of a variable" : "has the name of a metric",
                  "a name of its own");
    return false;
  }

  void read(const std::string& name) {
    if (!begun_.insert(name).second || !is_free(name)) return;
    const Given given = given_term(json_.at(name));
    under_way_.push_back(name);
    bool sound = true;
    for (const std::string& used : names_in(given.expression)) {
      if (!json_.contains(used)) continue;
      if (const auto first = std::find(under_way_.begin(), under_way_.end(), used);
          first != under_way_.end()) {
        std::vector<std::string> ring(first, under_way_.end());
        ring.push_back(used);
        std::string words;
        for (const std::string& one : ring) words += (words.empty() ? "" : " -> ") + one;
        findings_.add(place(name), "uses itself: " + words, "terms that do not hang on each other");
        sound = false;
        continue;
      }
      read(used);
      sound = sound && std::any_of(terms_.begin(), terms_.end(),
                                   [&](const Term& one) { return one.name == used; });
    }
    under_way_.pop_back();
    if (!sound) return;  // the term that it uses was found wrong
    const bool is_object = json_.at(name).is_object();
    const ExpressionPlace at{.goal = place(name),
                             .expression = place(name) + (is_object ? "/expression" : "")};
    const WrittenOut out = Symbols(metrics_, variables_, terms_)
                               .read(given.expression, given.values_when_absent, at, findings_);
    if (out.formula.empty()) return;
    terms_.push_back({.name = name,
                      .expression = given.expression,
                      .formula = out.formula,
                      .metrics = out.metrics,
                      .values_when_absent = out.values_when_absent});
  }

  const Json& json_;
  const Metrics& metrics_;
  const std::vector<Variable>& variables_;
  Findings& findings_;
  std::set<std::string> begun_;
  std::vector<std::string> under_way_;  // each uses the next
  std::vector<Term> terms_;             // sound ones so far
};

}  // namespace

Symbols::Symbols(const Metrics& metrics, const std::vector<Variable>& variables,
                 const std::vector<Term>& terms)
    : metrics_(metrics), terms_(terms) {
  for (const Variable& variable : variables) variables_.push_back(variable.name);
}

const Term* Symbols::term(const std::string& name) const {
  const auto found =
      std::find_if(terms_.begin(), terms_.end(), [&](const Term& one) { return one.name == name; });
  return found == terms_.end() ? nullptr : &*found;
}

std::string Symbols::allowed_words() const {
  std::vector<std::string> names = variables_;
  for (const Term& one : terms_) names.push_back(one.name);
  return "a formula of " + joined(names) + ", or of metrics of the case";
}

WrittenOut Symbols::read(const std::string& expression, const std::map<std::string, double>& absent,
                         const ExpressionPlace& place, Findings& findings) const {
  std::vector<std::string> names = variables_;
  for (const Term& one : terms_) names.push_back(one.name);
  for (const std::string& key : metrics_.keys()) names.push_back(key);
  const auto [problem, allowed] = expression_problem(expression, names, allowed_words());
  if (!problem.empty()) {
    findings.add(place.expression, problem, allowed);
    return {};
  }
  const std::size_t before = findings.size();
  WrittenOut out{.formula = {}, .metrics = {}, .values_when_absent = absent};
  std::map<std::string, std::string> written;
  for (const std::string& name : names_in(expression)) {
    if (has(variables_, name)) continue;
    if (const Term* used = term(name)) {
      written[name] = used->formula;
      for (const std::string& metric : used->metrics) {
        if (!has(out.metrics, metric)) out.metrics.push_back(metric);
      }
      merge(*used, out, place.goal, findings);
    } else if (metrics_.knows(name) && !has(out.metrics, name)) {
      out.metrics.push_back(name);
    }
  }
  for (const auto& [metric, value] : absent) {
    if (has(out.metrics, metric)) continue;
    findings.add(child_pointer(place.goal + "/values_when_absent", metric),
                 "is not used by the expression" + did_you_mean(metric, out.metrics),
                 out.metrics.empty() ? "no such value" : "one of " + joined(out.metrics));
  }
  for (const std::string& metric : out.metrics) {
    if (!metrics_.may_not_exist(metric) || out.values_when_absent.contains(metric)) continue;
    findings.add(
        child_pointer(place.goal + "/values_when_absent", metric),
        "is missing, and " + metric + " does not exist in every run",
        "a number that counts then, as in {\"expression\": ..., \"values_when_absent\": {\"" +
            metric + "\": 0}}");
  }
  std::string formula = with_names_replaced(expression, written);
  if (formula.size() > longest_formula) {
    findings.add(place.expression,
                 "has " + std::to_string(formula.size()) + " characters with its terms written out",
                 "at most " + std::to_string(longest_formula));
  }
  if (findings.size() == before) out.formula = std::move(formula);
  return out;
}

std::vector<Term> read_terms(const Json& json, const Metrics& metrics,
                             const std::vector<Variable>& variables, Findings& findings) {
  return TermReader(json, metrics, variables, findings).read();
}

}  // namespace parapet::designs
