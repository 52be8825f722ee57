#include "connected.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace parapet::solver {
namespace {

// Bodies as trees whose roots have the smallest index.
class Bodies {
 public:
  explicit Bodies(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    parent_[high] = low;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

std::vector<std::size_t> main_body(std::span<const Vec2> places, std::span<const double> masses,
                                   double reach) {
  const std::size_t n = places.size();
  using Cell = std::pair<long, long>;
  const auto cell_of = [&](Vec2 p) {
    return Cell{std::lround(std::floor(p.x / reach)), std::lround(std::floor(p.z / reach))};
  };
  std::map<Cell, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < n; ++i) cells[cell_of(places[i])].push_back(i);
  Bodies bodies(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Cell own = cell_of(places[i]);
    for (long dx = -1; dx <= 1; ++dx) {
      for (long dz = -1; dz <= 1; ++dz) {
        const auto near = cells.find({own.first + dx, own.second + dz});
        if (near == cells.end()) continue;
        for (const std::size_t j : near->second) {
          if (j < i && norm(places[i] - places[j]) <= reach) bodies.join(i, j);
        }
      }
    }
  }
  std::vector<double> mass(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) mass[bodies.root(i)] += masses[i];
  std::vector<std::size_t> body;
  if (n == 0) return body;
  const auto heaviest =
      static_cast<std::size_t>(std::max_element(mass.begin(), mass.end()) - mass.begin());
  for (std::size_t i = 0; i < n; ++i) {
    if (bodies.root(i) == heaviest) body.push_back(i);
  }
  return body;
}

}  // namespace parapet::solver
