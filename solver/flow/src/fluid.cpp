#include "parapet/flow/fluid.hpp"

#include <algorithm>
#include <cmath>

#include "parapet/flow/index.hpp"

namespace parapet::solver {
namespace {

// array[k] = old array[order[k]], by way of `scratch`.
template <class Value>
void reorder(std::vector<Value>& array, std::span<const std::int32_t> order,
             std::vector<Value>& scratch) {
  scratch.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) scratch[k] = array[at(order[k])];
  std::copy(scratch.begin(), scratch.end(), array.begin());
}

}  // namespace

std::vector<InitialParticle> lattice_block(double x0, double z0, double length, double height,
                                           double spacing, double density) {
  const int nx = std::max(1, static_cast<int>(std::round(length / spacing)));
  const int nz = std::max(1, static_cast<int>(std::round(height / spacing)));
  const double dx = length / nx, dz = height / nz;
  std::vector<InitialParticle> particles;
  particles.reserve(static_cast<std::size_t>(nx) * static_cast<std::size_t>(nz));
  for (int ix = 0; ix < nx; ++ix) {
    for (int iz = 0; iz < nz; ++iz) {
      particles.push_back(
          {x0 + (ix + 0.5) * dx, z0 + (iz + 0.5) * dz, 0.0, 0.0, density, density * dx * dz});
    }
  }
  return particles;
}

void Fluid::assign(std::span<const InitialParticle> particles) {
  n = static_cast<int>(particles.size());
  for_each_field([&](const FieldInfo& field, std::vector<double>& array) {
    array.assign(particles.size() + 1, field.first);  // one more for the ghost
  });
  id.resize(particles.size() + 1);
  for (std::size_t i = 0; i < particles.size(); ++i) {
#define PARAPET_RELEASE(name, ...) name[i] = particles[i].name;
    PARAPET_STATE_FIELDS(PARAPET_RELEASE)
#undef PARAPET_RELEASE
    id[i] = static_cast<std::int32_t>(i);
  }
  set_ghost();
}

InitialParticle Fluid::particle(int i) const {
#define PARAPET_READ(name, ...) .name = name[at(i)],
  return {PARAPET_STATE_FIELDS(PARAPET_READ)};
#undef PARAPET_READ
}

void Fluid::set_ghost() {
  const std::size_t g = at(n);
  for_each_field([&](const FieldInfo& field, std::vector<double>& array) {
    array.resize(g + 1);
    array[g] = field.ghost;
  });
  id.resize(g + 1);
  id[g] = 0;
#define PARAPET_RESIZE(name, ...) name.resize(g + 1);
  PARAPET_PARTICLE_RECORDS(PARAPET_RESIZE)
#undef PARAPET_RESIZE
  pack(n, n + 1);
}

void Fluid::permute(std::span<const std::int32_t> order) {
  for_each_field([&](const FieldInfo& field, std::vector<double>& array) {
    if (survives_sorting(field.lifetime)) reorder(array, order, scratch_);
  });
  reorder(id, order, scratch_id_);
}

void Fluid::remove(std::span<const std::int32_t> indices) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0, next = 0; i < at(n); ++i) {
    if (next < indices.size() && indices[next] == static_cast<std::int32_t>(i)) {
      ++next;
    } else {
      kept.push_back(i);
    }
  }
  // every particle moves up or stays
  const auto close_up = [&](auto& array) {
    for (std::size_t k = 0; k < kept.size(); ++k) array[k] = array[kept[k]];
  };
  for_each_field([&](const FieldInfo& field, std::vector<double>& array) {
    if (survives_removal(field.lifetime)) close_up(array);
  });
  close_up(id);
  n = static_cast<int>(kept.size());
  set_ghost();
}

Fluid Fluid::compact() const {
  Fluid copy;
  copy.n = n;
  copy.id = id;
  std::vector<const std::vector<double>*> arrays;
  for_each_field(
      [&](const FieldInfo&, const std::vector<double>& array) { arrays.push_back(&array); });
  auto from = arrays.begin();
  copy.for_each_field([&](const FieldInfo& field, std::vector<double>& array) {
    if (survives_removal(field.lifetime)) array = **from;
    ++from;
  });
  return copy;
}

void Fluid::expand() {
  set_ghost();
  pack(0, n);
}

FluidView Fluid::view() const {
  FluidView view;
  view.n = n;
#define PARAPET_POINT(name, ...) view.name = name.data();
  PARAPET_STATE_FIELDS(PARAPET_POINT)
  PARAPET_DERIVED_FIELDS(PARAPET_POINT)
  PARAPET_PARTICLE_RECORDS(PARAPET_POINT)
#undef PARAPET_POINT
  return view;
}

ShiftedRates Fluid::rates() {
  ShiftedRates view;
#define PARAPET_POINT(name, ...) view.name = name.data();
  PARAPET_RATE_FIELDS(PARAPET_POINT)
#undef PARAPET_POINT
  return view;
}

GradientSumArrays::GradientSumArrays(int n) {
#define PARAPET_COUNT(name) +1
  constexpr int count = 0 PARAPET_GRADIENT_SUMS(PARAPET_COUNT);
#undef PARAPET_COUNT
  values_.resize(at(n) * count);
  double* next = values_.data();
#define PARAPET_POINT(name) \
  view.name = next;         \
  next += n;
  PARAPET_GRADIENT_SUMS(PARAPET_POINT)
#undef PARAPET_POINT
}

#define PARAPET_PACK(name, Type, a, b, c, d)                  \
  void Fluid::pack_##name(int begin, int end) {               \
    for (std::size_t i = at(begin); i < at(end); ++i) {       \
      name[i] = {.a = a[i], .b = b[i], .c = c[i], .d = d[i]}; \
    }                                                         \
  }
PARAPET_PARTICLE_RECORDS(PARAPET_PACK)
#undef PARAPET_PACK

void Fluid::pack(int begin, int end) {
#define PARAPET_PACK(name, ...) pack_##name(begin, end);
  PARAPET_PARTICLE_RECORDS(PARAPET_PACK)
#undef PARAPET_PACK
}

}  // namespace parapet::solver
