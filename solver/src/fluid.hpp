// The fluid's particles: one array per quantity of particle_fields.hpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "flow_arrays.hpp"

namespace parapet::solver {

// One particle at release: the state.
struct InitialParticle {
  double x, z;     // [m]
  double u, w;     // [m/s]
  double density;  // [kg/m3]
  double mass;     // [kg/m]
};

struct FieldInfo {
  const char* name;
  Lifetime lifetime;
  double first;  // of every particle at release, but for the state
  double ghost;
};

// Arrays are [n + 1]: the last entry is the ghost that pads neighbour rows.
struct Fluid {
  int n = 0;
#define PARAPET_ARRAY(name, ...) std::vector<double> name;
  PARAPET_PARTICLE_FIELDS(PARAPET_ARRAY)
  struct Sums {
    PARAPET_GRADIENT_SUMS(PARAPET_ARRAY)
  } sums;
#undef PARAPET_ARRAY
#define PARAPET_RECORDS(name, Type, ...) std::vector<Type> name;
  PARAPET_PARTICLE_RECORDS(PARAPET_RECORDS)
#undef PARAPET_RECORDS
  std::vector<std::int32_t> id;  // of the particle at release

  void assign(std::span<const InitialParticle> particles);
  InitialParticle particle(int i) const;
  // Reorders what survives a sorting: new particle k is old order[k].
  void permute(std::span<const std::int32_t> order);
  // Removes the particles of these ascending indices, keeping the order of the others.
  void remove(std::span<const std::int32_t> indices);

  // Brings the records of [begin, end) up to date with the arrays; the ghost's with end = n + 1.
  void pack(int begin, int end);
#define PARAPET_PACK(name, ...) void pack_##name(int begin, int end);
  PARAPET_PARTICLE_RECORDS(PARAPET_PACK)  // pack_motion, pack_state, pack_shift: one kind alone
#undef PARAPET_PACK

  FluidView view() const;
  GradientSums gradient_sums();
  ShiftedRates rates();

  // Calls visit(FieldInfo, array) for every quantity.
  template <class Visit>
  void for_each_field(const Visit& visit) {
    visit_fields(*this, visit);
  }
  template <class Visit>
  void for_each_field(const Visit& visit) const {
    visit_fields(*this, visit);
  }

 private:
  template <class Self, class Visit>
  static void visit_fields(Self& self, const Visit& visit) {
#define PARAPET_VISIT(name, lifetime, first, ghost) \
  visit(FieldInfo{#name, Lifetime::lifetime, first, ghost}, self.name);
    PARAPET_PARTICLE_FIELDS(PARAPET_VISIT)
#undef PARAPET_VISIT
#define PARAPET_VISIT(name, lifetime, first, ghost) \
  visit(FieldInfo{"sums." #name, Lifetime::lifetime, first, ghost}, self.sums.name);
    PARAPET_GRADIENT_SUMS(PARAPET_VISIT)
#undef PARAPET_VISIT
  }
  void set_ghost();

  std::vector<double> scratch_;
  std::vector<std::int32_t> scratch_id_;
};

}  // namespace parapet::solver
