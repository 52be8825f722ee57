/// Designs worth looking at: all allowed by the constraints that need no evaluation.
#pragma once

#include <cstddef>
#include <vector>

#include "parapet/bayesian/problem.hpp"
#include "random.hpp"

namespace parapet::bayesian {

/// Whether the constraints that need no evaluation allow a design.
bool allowed(const Problem& problem, const Point& x, double tolerance);

class Candidates {
 public:
  /// The problem must outlive this. The same seed and stream give the same designs.
  Candidates(const Problem& problem, double tolerance, std::uint64_t seed, std::uint64_t stream);

  /// Up to n designs spread over the space: shifted Sobol' points that are allowed. Where hardly
  /// any are, designs around the ones found; where none is, a search for one. Empty: nothing is
  /// allowed.
  std::vector<Point> spread(std::size_t n);

  /// n designs around an allowed one: a step of about `reach` (share of each range) in some of the
  /// variables, now and then another option. A step that leaves the allowed region is cut short.
  std::vector<Point> around(const Point& center, double reach, std::size_t n);

 private:
  std::vector<double> step(const std::vector<double>& from, double reach);
  std::vector<Point> search_for_one();
  double excess(const Point& x) const;

  const Problem& problem_;
  double tolerance_;
  Random random_;
};

}  // namespace parapet::bayesian
