#include "formula_grammar.hpp"

#include <string_view>

namespace parapet::designs {
namespace {

struct Refused {
  std::string problem, allowed;
};

constexpr const char* a_value =
    "a formula such as a + b; its limits stand in the keys lower and upper";
constexpr const char* a_formula =
    "numbers with a decimal point, names, + - * / ^, brackets, functions such as max(a, b), and "
    "a < b ? c : d";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool begins_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Recursive descent; what it reads is a number or a truth.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  void read() {
    require_number(formula());
    skip_blanks();
    if (at_ == text_.size()) return;
    if (text_[at_] == ',') {
      refuse("has a comma" + place() + " outside a function's brackets",
             "a point as the decimal mark; commas only between the arguments of a function");
    }
    if (text_[at_] == '=') refuse("is a comparison, not a value", a_value);
    refuse("has " + shown() + place() + ", which is no part of a formula there", a_formula);
  }

 private:
  enum class Kind { number, truth };

  [[noreturn]] static void refuse(const std::string& problem, const std::string& allowed) {
    throw Refused{problem, allowed};
  }

  std::string place() const { return " at character " + std::to_string(at_ + 1); }

  std::string shown() const {
    const char c = text_[at_];
    if (c >= 32 && c < 127) return std::string("\"") + c + "\"";
    return "a character that is not plain ASCII";
  }

  static void require_number(Kind kind) {
    if (kind != Kind::number) refuse("is a comparison, not a value", a_value);
  }

  void skip_blanks() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != text_.npos) ++at_;
  }

  bool take(std::string_view token) {
    skip_blanks();
    if (!text_.substr(at_).starts_with(token)) return false;
    at_ += token.size();
    return true;
  }

  Kind formula() {
    constexpr int deepest = 100;
    if (++depth_ > deepest) refuse("is nested too deeply", "fewer brackets inside brackets");
    skip_blanks();
    const std::size_t begin = at_;
    Kind kind = any_of();
    if (take("?")) {
      if (kind != Kind::truth) {
        at_ = begin;
        refuse("has a number" + place() + " where a condition is needed",
               "a comparison before the question mark, such as a < b ? c : d");
      }
      require_number(formula());
      if (!take(":")) refuse("has no \":\"" + place() + " after its \"?\"", a_formula);
      require_number(formula());
      kind = Kind::number;
    }
    --depth_;
    return kind;
  }

  Kind any_of() {
    Kind kind = all_of();
    while (take("||")) kind = joined_truths(kind, all_of());
    return kind;
  }

  Kind all_of() {
    Kind kind = comparison();
    while (take("&&")) kind = joined_truths(kind, comparison());
    return kind;
  }

  Kind joined_truths(Kind a, Kind b) const {
    if (a == Kind::truth && b == Kind::truth) return Kind::truth;
    refuse("joins numbers by && or || before character " + std::to_string(at_ + 1),
           "comparisons beside && and ||, such as a < b && b < c");
  }

  Kind comparison() {
    const Kind left = sum();
    for (const char* sign : {"<=", ">=", "==", "!=", "<", ">"}) {
      if (!take(sign)) continue;
      require_operands(left, sum());
      return Kind::truth;
    }
    return left;
  }

  void require_operands(Kind a, Kind b) const {
    if (a == Kind::number && b == Kind::number) return;
    refuse("calculates with a comparison before character " + std::to_string(at_ + 1),
           "numbers beside + - * / ^ and comparisons, or a < b ? c : d");
  }

  Kind sum() {
    const Kind kind = product();
    while (take("+") || take("-")) require_operands(kind, product());
    return kind;
  }

  Kind product() {
    const Kind kind = signed_power();
    while (take("*") || take("/")) require_operands(kind, signed_power());
    return kind;
  }

  Kind signed_power() {
    bool has_sign = false;
    while (take("+") || take("-")) has_sign = true;
    const Kind kind = power();
    if (has_sign) require_operands(kind, Kind::number);
    return kind;
  }

  Kind power() {
    const Kind kind = atom();
    if (!take("^")) return kind;
    if (++depth_ > 100) refuse("is nested too deeply", "fewer powers of powers");
    require_operands(kind, signed_power());
    --depth_;
    return Kind::number;
  }

  Kind atom() {
    skip_blanks();
    if (at_ == text_.size()) refuse("ends too early", a_formula);
    const char c = text_[at_];
    if (is_digit(c) || c == '.') return number();
    if (begins_name(c)) return name();
    if (take("(")) {
      const Kind kind = formula();
      if (take(")")) return kind;
      refuse_in_brackets();
    }
    refuse("has " + shown() + place() + ", which is no part of a formula there", a_formula);
  }

  [[noreturn]] void refuse_in_brackets() {
    skip_blanks();
    if (at_ == text_.size()) refuse("ends before a bracket is closed", a_formula);
    if (text_[at_] == ',') {
      refuse("has a comma" + place() + " outside a function's brackets",
             "a point as the decimal mark; commas only between the arguments of a function");
    }
    if (text_[at_] == '=') refuse("is a comparison, not a value", a_value);
    refuse("has " + shown() + place() + ", which is no part of a formula there", a_formula);
  }

  Kind number() {
    const std::size_t begin = at_;
    const auto digits = [this] {
      const std::size_t from = at_;
      while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
      return at_ - from;
    };
    std::size_t count = digits();
    if (at_ < text_.size() && text_[at_] == '.') {
      ++at_;
      count += digits();
    }
    const std::size_t mantissa_end = at_;
    if (count > 0 && at_ < text_.size() && (text_[at_] == 'e' || text_[at_] == 'E')) {
      ++at_;
      if (at_ < text_.size() && (text_[at_] == '+' || text_[at_] == '-')) ++at_;
      if (digits() == 0) at_ = mantissa_end;
    }
    const bool runs_on = at_ < text_.size() && (begins_name(text_[at_]) || text_[at_] == '.');
    if (count == 0 || runs_on) {
      at_ = begin;
      refuse("cannot be read" + place() + ": not a number",
             "numbers such as 0.5 or 1e-3, without units, and * between factors");
    }
    return Kind::number;
  }

  Kind name() {
    while (at_ < text_.size() && (begins_name(text_[at_]) || is_digit(text_[at_]))) ++at_;
    if (!take("(")) return Kind::number;
    require_number(formula());
    while (take(",")) {
      const std::size_t comma = at_ - 1;
      if (is_digit(text_[comma - 1]) && at_ < text_.size() && is_digit(text_[at_])) {
        at_ = comma;
        refuse("has a comma between two digits" + place() + ", which may be a decimal mark",
               "a point as the decimal mark, or a blank after a comma that separates arguments");
      }
      require_number(formula());
    }
    if (!take(")")) refuse_in_brackets();
    return Kind::number;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

ExpressionProblem grammar_problem(const std::string& formula) {
  try {
    Reader(formula).read();
  } catch (const Refused& refused) {
    return {refused.problem, refused.allowed};
  }
  return {};
}

}  // namespace parapet::designs
