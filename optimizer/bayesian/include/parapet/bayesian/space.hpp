/// The space of designs: continuous and integer variables, choices, and variables that exist only
/// under some choices.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "parapet/surrogate/gaussian_process.hpp"

namespace parapet::bayesian {

/// What values a variable may take: any between its bounds, whole numbers, or options.
enum class VariableKind { continuous, integer, choice };

/// A variable exists (is active) only when another one, a choice, has one of these options.
struct Condition {
  std::size_t choice = 0;         ///< index of an earlier variable, itself a choice
  std::vector<int> options = {};  ///< option numbers
};

/// One coordinate of a design.
struct Variable {
  std::string name;
  VariableKind kind = VariableKind::continuous;
  double lower = 0.0, upper = 1.0;  ///< of a choice: 0 and the number of options - 1
  std::optional<Condition> active_when = {};
};

/// A design in the variables' own units, [n]. Options are numbered from 0. An inactive variable has
/// no value: in canonical form its place holds NaN.
using Point = std::vector<double>;

/// Whether two canonical points are the same design, to the bit.
bool same_design(const Point& a, const Point& b);

/// Designs of fixed variables, and how they map to the unit cube and to the inputs of a surrogate.
class Space {
 public:
  /// @throws std::invalid_argument for bounds out of order or a condition on a later variable or on
  /// one that is not a choice.
  explicit Space(std::vector<Variable> variables);

  /// Number of variables n.
  std::size_t size() const { return variables_.size(); }
  /// [n], as given.
  const std::vector<Variable>& variables() const { return variables_; }

  /// Canonical form: integers and options rounded, all clipped to the bounds, inactive ones NaN.
  /// A variable whose condition hangs on an inactive choice is inactive too.
  Point canonical(const Point& x) const;

  /// Whether the variable exists under the options that x takes.
  bool active(const Point& x, std::size_t variable) const;

  /// From the unit cube [n] (every variable has a coordinate, used or not) to a canonical point;
  /// each integer and option gets an equal share of [0, 1].
  Point from_unit(const std::vector<double>& u) const;

  /// Coordinates in the unit cube: the middle of its share for integers and options, 0.5 for
  /// inactive.
  std::vector<double> to_unit(const Point& x) const;

  /// Columns for a Gaussian process: u for continuous and integer variables, one column per option
  /// of a choice (1/sqrt 2 for the one taken, so that two options are at distance 1). An inactive
  /// variable's column is 0.5 whatever the point says, so two designs that differ only there are
  /// one input; what its existence changes is carried by the choice's columns. One length scale per
  /// variable.
  surrogate::Layout layout(int n_levels = 1) const;

  /// The columns of one design [n_features], as layout() describes them.
  Eigen::RowVectorXd features(const Point& x) const;
  Eigen::MatrixXd features(const std::vector<Point>& xs) const;  ///< [m, n_features]

  /// All combinations of options that differ in what is active or chosen: [n_combinations][n], NaN
  /// for variables that are not choices (and for inactive choices). At most `limit` of them.
  std::vector<Point> choice_combinations(std::size_t limit = 256) const;

 private:
  std::vector<Variable> variables_;
};

}  // namespace parapet::bayesian
