// Particles far from any wall, each a neighbour of all others, for the sums against double loops.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "parapet/flow/flow.hpp"
#include "parapet/flow/pass_table.hpp"

namespace parapet::solver {

constexpr double cloud_dx = 0.01, cloud_h = 1.33 * cloud_dx;
constexpr double cloud_levelling = 0.003;  // diffusivity of the masses [m2/s]

struct Rates {
  std::vector<double> density, mass, exchange_x, exchange_z;
};

// Five particles placed by hand plus 40 at random, far from any wall.
struct Cloud {
  mutable Fluid fluid;  // its records are packed when they are looked at
  std::vector<std::int32_t> begin, end, index;
  std::vector<double> none = std::vector<double>(8, 0.0);

  Cloud() {
    std::vector<InitialParticle> particles = {{0.0, 0.0, 1.0, 0.5, 1000.0, 0.1},
                                              {0.01, 0.0, 1.2, 0.4, 1003.0, 0.12},
                                              {0.0, 0.012, 0.7, 0.6, 998.0, 0.08},
                                              {-0.009, 0.001, 1.1, 0.2, 1001.0, 0.11},
                                              {0.001, -0.011, 0.9, 0.9, 1002.0, 0.09}};
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-0.03, 0.03), speed(-1.0, 1.0);
    for (int k = 0; k < 40; ++k) {
      particles.push_back({place(random), place(random), speed(random), speed(random),
                           1000.0 + 5.0 * speed(random), 0.1});
    }
    fluid.assign(particles);
    for (int i = 0; i < fluid.n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      fluid.pressure[k] = 1225.0 * (fluid.density[k] - 1000.0);
      fluid.volume[k] = fluid.mass[k] / fluid.density[k];
      fluid.pair_viscosity[k] = 1.0 + i;
      fluid.shift_u[k] = 0.01 * i;
      fluid.shift_w[k] = -0.02 * i;
      fluid.tic[k] = i % 3 == 0 ? -1.0 : 1.0;
      fluid.density_grad_x[k] = 3.0 * i;
      fluid.density_grad_z[k] = 50.0 - i;
    }
    // everybody but oneself
    for (int first = 0; first < fluid.n; first += lanes) {
      begin.push_back(static_cast<std::int32_t>(index.size()));
      for (int k = 0; k + 1 < fluid.n; ++k) {
        for (int i = first; i < first + lanes; ++i) {
          index.push_back(i < fluid.n ? k + (k >= i) : fluid.n);
        }
      }
      end.push_back(static_cast<std::int32_t>(index.size()));
    }
  }

  Rates rates(const PassTable& passes = best_passes()) const {
    Rates r;
    for (auto* a : {&r.density, &r.mass, &r.exchange_x, &r.exchange_z})
      a->resize(static_cast<std::size_t>(fluid.n));
    passes.density_rate(arrays(),
                        {r.density.data(), r.mass.data(), r.exchange_x.data(), r.exchange_z.data()},
                        0, fluid.n);
    return r;
  }

  FlowArrays arrays() const {
    FlowConstants c{};
    c.kernel = make_kernel(cloud_h, cloud_dx);
    c.smoothing_length = cloud_h;
    c.sound_speed = 35.0;
    c.reference_density = 1000.0;
    c.density_diffusion = 0.1;
    c.even_volume = cloud_dx * cloud_dx;
    c.mass_diffusivity = cloud_levelling;
    c.no_slip = true;
    fluid.pack(0, fluid.n + 1);
    FlowArrays a{c, fluid.view(), {}, {}};
    a.rows.begin = begin.data();
    a.rows.wall_begin = end.data();
    a.rows.end = end.data();
    a.rows.index = index.data();
    return a;
  }

  // Calls body(j, r_ij, F V_j) for every neighbour of i within the support.
  template <class Body>
  void for_neighbors(std::size_t i, const Body& body) const {
    const Kernel k = make_kernel(cloud_h, cloud_dx);
    for (std::size_t j = 0; j < static_cast<std::size_t>(fluid.n); ++j) {
      const Vec2 r{fluid.x[i] - fluid.x[j], fluid.z[i] - fluid.z[j]};
      const double q = norm(r) / cloud_h;
      if (j == i || q >= 2.0) continue;
      const double t = 1.0 - 0.5 * q;
      body(j, r, -k.f_scale * t * t * t * fluid.volume[j]);
    }
  }
};

}  // namespace parapet::solver
