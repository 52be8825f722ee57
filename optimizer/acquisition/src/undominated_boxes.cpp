/// The undominated region as disjoint boxes.
#include <algorithm>
#include <cmath>
#include <span>

#include "parapet/acquisition/boxes.hpp"

namespace parapet::acquisition {
namespace {

/// Bounds of a box in m objectives: m lower ones, then m upper ones.
using Bounds = std::vector<double>;

struct Region {
  const Objectives& reference;
  const Objectives& ideal;
};

/// A box in all objectives but the last, and where in the last one it begins.
struct OpenBox {
  Bounds bounds;
  double from;
};

Bounds extended(const Bounds& bounds, double from, double to) {
  const std::size_t m = bounds.size() / 2;
  Bounds result;
  result.reserve(bounds.size() + 2);
  const auto half = bounds.begin() + static_cast<Bounds::difference_type>(m);
  result.insert(result.end(), bounds.begin(), half);
  result.push_back(from);
  result.insert(result.end(), half, bounds.end());
  result.push_back(to);
  return result;
}

/// Boxes in the first m objectives. A sweep along the last of them: between two neighbouring values
/// of the points the boxes of the other objectives stay the same; those that also stay when the
/// sweep passes a point are not cut there.
std::vector<Bounds> boxes_below(std::vector<const double*> points, const Region& region,
                                std::size_t m) {
  const auto last = static_cast<Eigen::Index>(m) - 1;
  const double begin = region.ideal[last], end = region.reference[last];
  if (!(begin < end)) return {};
  if (m == 1) {
    double upper = end;
    for (const double* p : points) upper = std::min(upper, p[0]);
    if (!(begin < upper)) return {};
    return {{begin, upper}};
  }
  std::stable_sort(points.begin(), points.end(),
                   [last](const double* a, const double* b) { return a[last] < b[last]; });
  std::vector<Bounds> closed;
  std::vector<OpenBox> open;
  double from = begin;
  for (std::size_t passed = 0; from < end;) {
    while (passed < points.size() && !(points[passed][last] > from)) ++passed;
    const std::vector<const double*> below(points.begin(),
                                           points.begin() + static_cast<std::ptrdiff_t>(passed));
    std::vector<OpenBox> next;
    for (Bounds& bounds : boxes_below(below, region, m - 1)) {
      const auto same = std::find_if(open.begin(), open.end(),
                                     [&](const OpenBox& box) { return box.bounds == bounds; });
      double since = from;
      if (same != open.end()) {
        since = same->from;
        open.erase(same);
      }
      next.push_back({std::move(bounds), since});
    }
    for (const OpenBox& box : open) closed.push_back(extended(box.bounds, box.from, from));
    open = std::move(next);
    from = passed < points.size() ? std::min(points[passed][last], end) : end;
  }
  for (const OpenBox& box : open) closed.push_back(extended(box.bounds, box.from, end));
  return closed;
}

}  // namespace

std::vector<Box> undominated_boxes(const std::vector<Objectives>& points,
                                   const Objectives& reference, const Objectives& ideal) {
  const Eigen::Index m = reference.size();
  math::check_objectives("the reference point", reference, std::max<Eigen::Index>(1, m));
  math::check_objectives("the ideal point", ideal, m);
  std::vector<Objectives> front;
  for (const Objectives& p : points) {
    math::check_objectives("a point of the front", p, m);
    if ((p.array() < reference.array()).all()) front.push_back(p);
  }
  std::vector<const double*> rows;
  for (const std::size_t i : math::non_dominated(front)) rows.push_back(front[i].data());

  std::vector<Box> boxes;
  for (const Bounds& bounds : boxes_below(rows, {reference, ideal}, static_cast<std::size_t>(m))) {
    boxes.push_back({Eigen::Map<const Objectives>(bounds.data(), m),
                     Eigen::Map<const Objectives>(bounds.data() + m, m)});
  }
  return boxes;
}

}  // namespace parapet::acquisition
