#include "fluid.hpp"

#include <algorithm>

namespace parapet::solver {
namespace {

constexpr double far_away = 1e6;  // [m] no kernel reaches the ghost

}  // namespace

std::vector<std::vector<double>*> Fluid::arrays() {
  return {&x,
          &z,
          &u,
          &w,
          &density,
          &mass,
          &pressure,
          &volume,
          &viscosity,
          &shear_rate,
          &quadrature,
          &pair_viscosity,
          &viscous_ax,
          &viscous_az,
          &lambda,
          &closeness,
          &shift_u,
          &shift_w,
          &tic,
          &density_rate,
          &mass_rate,
          &exchange_x,
          &exchange_z,
          &density_grad_x,
          &density_grad_z};
}

void Fluid::assign(std::span<const InitialParticle> particles) {
  n = static_cast<int>(particles.size());
  const std::size_t size = particles.size() + 1;
  for (auto* array : arrays()) {
    array->assign(size, 0.0);
  }
  for (auto& sum : sums) sum.assign(size, 0.0);
  lambda.assign(size, 1.0);  // until the first step has looked at the neighbours
  closeness.assign(size, 2.0);
  id.assign(size, 0);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const InitialParticle& p = particles[i];
    x[i] = p.x;
    z[i] = p.z;
    u[i] = p.u;
    w[i] = p.w;
    density[i] = p.density;
    mass[i] = p.mass;
    id[i] = static_cast<std::int32_t>(i);
  }
  set_ghost();
}

void Fluid::set_ghost() {
  const auto g = static_cast<std::size_t>(n);
  for (auto* array : arrays()) {
    array->resize(g + 1);
    (*array)[g] = 0.0;
  }
  id.resize(g + 1);
  for (auto* records : {&motion, &state, &shift}) records->resize(g + 1);
  x[g] = z[g] = far_away;
  density[g] = 1.0;
  pack(n, n + 1);
}

void Fluid::permute(std::span<const std::int32_t> order) {
  const std::size_t count = order.size();
  scratch_.resize(count + 1);
  for (auto* array :
       {&x, &z, &u, &w, &density, &mass,

        &viscous_ax, &viscous_az, &lambda, &closeness, &viscosity, &pair_viscosity, &quadrature,
        &shear_rate, &shift_u, &shift_w, &tic, &density_grad_x, &density_grad_z}) {
    for (std::size_t k = 0; k < count; ++k) {
      scratch_[k] = (*array)[static_cast<std::size_t>(order[k])];
    }
    std::copy(scratch_.begin(), scratch_.begin() + static_cast<std::ptrdiff_t>(count),
              array->begin());
  }
  scratch_id_.resize(count);
  for (std::size_t k = 0; k < count; ++k) scratch_id_[k] = id[static_cast<std::size_t>(order[k])];
  std::copy(scratch_id_.begin(), scratch_id_.end(), id.begin());
}

void Fluid::remove(std::span<const std::int32_t> indices) {
  const std::vector<std::vector<double>*> all = arrays();
  std::size_t next = 0, kept = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
    if (next < indices.size() && indices[next] == static_cast<std::int32_t>(i)) {
      ++next;
      continue;
    }
    for (auto* array : all) {
      (*array)[kept] = (*array)[i];
    }
    id[kept++] = id[i];
  }
  n = static_cast<int>(kept);
  set_ghost();
}

FluidView Fluid::view() const {
  return {n,
          x.data(),
          z.data(),
          u.data(),
          w.data(),
          density.data(),
          pressure.data(),
          volume.data(),
          pair_viscosity.data(),
          density_grad_x.data(),
          density_grad_z.data(),
          shift_u.data(),
          shift_w.data(),
          tic.data(),
          motion.data(),
          state.data(),
          shift.data()};
}

void Fluid::pack_motion(int begin, int end) {
  for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
    motion[i] = {{x[i], z[i], u[i], w[i]}};
  }
}

void Fluid::pack_state(int begin, int end) {
  for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
    state[i] = {{volume[i], density[i], pressure[i], pair_viscosity[i]}};
  }
}

void Fluid::pack_shift(int begin, int end) {
  for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
    shift[i] = {{shift_u[i], shift_w[i], density_grad_x[i], density_grad_z[i]}};
  }
}

void Fluid::pack(int begin, int end) {
  pack_motion(begin, end);
  pack_state(begin, end);
  pack_shift(begin, end);
}

GradientSums Fluid::gradient_sums() {
  auto& s = sums;
  return {s[0].data(),  s[1].data(),  s[2].data(),  s[3].data(),  s[4].data(),  s[5].data(),
          s[6].data(),  s[7].data(),  s[8].data(),  s[9].data(),  s[10].data(), s[11].data(),
          s[12].data(), s[13].data(), s[14].data(), s[15].data(), s[16].data(), s[17].data()};
}

}  // namespace parapet::solver
