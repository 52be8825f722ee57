/// The fluid's particles: one array per quantity of particle_fields.hpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "parapet/flow/flow_arrays.hpp"

namespace parapet::solver {

/// One particle at release: the state.
struct InitialParticle {
  double x, z;     ///< [m]
  double u, w;     ///< [m/s]
  double density;  ///< [kg/m3]
  double mass;     ///< [kg/m]
};

/// A block of fluid [x0, x0 + length] x [z0, z0 + height] on a regular lattice whose cells fill it
/// exactly, about `spacing` apart [m]; at rest, with one density [kg/m3]. Particles count along z
/// first.
std::vector<InitialParticle> lattice_block(double x0, double z0, double length, double height,
                                           double spacing, double density);

/// One line of the table of quantities.
struct FieldInfo {
  const char* name;  ///< of the member
  Lifetime lifetime;
  double first;  ///< of every particle at release, but for the state
  double ghost;  ///< of the ghost, always
};

/// Room for the sums of the gradient pass over n particles, in the arrays that `view` points at.
/// They are read right after the pass, so a flow keeps those of a few particles at a time.
class GradientSumArrays {
 public:
  explicit GradientSumArrays(int n);                            ///< zeros
  GradientSumArrays(GradientSumArrays&&) = default;             ///< the view goes with the arrays
  GradientSumArrays& operator=(GradientSumArrays&&) = default;  ///< likewise
  GradientSums view;                                            ///< valid as long as this

 private:
  std::vector<double> values_;
};

/// The particles. Members are one std::vector<double> of [n + 1] for each line of
/// PARAPET_PARTICLE_FIELDS (x, z, u, w, density, mass, pressure, volume and so on) in
/// particle_fields.hpp, which says what they are. The last entry is the ghost that pads neighbour
/// rows.
struct Fluid {
  int n = 0;  ///< number of particles
#define PARAPET_ARRAY(name, ...) std::vector<double> name;
  PARAPET_PARTICLE_FIELDS(PARAPET_ARRAY)
#undef PARAPET_ARRAY
#define PARAPET_RECORDS(name, Type, ...) std::vector<Type> name;
  PARAPET_PARTICLE_RECORDS(PARAPET_RECORDS)
#undef PARAPET_RECORDS
  std::vector<std::int32_t> id;  ///< [n + 1] number of the particle at release

  /// Makes these the particles; whatever there was is lost.
  void assign(std::span<const InitialParticle> particles);
  InitialParticle particle(int i) const;  ///< its state
  /// Reorders what survives a sorting: new particle k is old order[k].
  void permute(std::span<const std::int32_t> order);
  /// Removes the particles of these ascending indices, keeping the order of the others.
  void remove(std::span<const std::int32_t> indices);

  /// A copy for storing: without the records and without what only the step reads that has worked
  /// it out. expand() makes it whole again.
  Fluid compact() const;
  void expand();  ///< @pre compact

  /// Brings the records of [begin, end) up to date with the arrays; the ghost's with end = n + 1.
  void pack(int begin, int end);
  // pack_motion, pack_state, pack_shift: one kind of record alone
#define PARAPET_PACK(name, ...) void pack_##name(int begin, int end);
  PARAPET_PARTICLE_RECORDS(PARAPET_PACK)
#undef PARAPET_PACK

  FluidView view() const;  ///< valid until the number of particles changes
  ShiftedRates rates();    ///< likewise

  /// Calls visit(FieldInfo, array) for every quantity.
  template <class Visit>
  void for_each_field(const Visit& visit) {
    visit_fields(*this, visit);
  }
  /// The same; the arrays cannot be changed.
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
  }
  void set_ghost();

  std::vector<double> scratch_;
  std::vector<std::int32_t> scratch_id_;
};

}  // namespace parapet::solver
