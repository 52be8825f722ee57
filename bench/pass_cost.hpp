// Arithmetic and memory traffic of each neighbour sum, counted by hand from the source.
#pragma once

#include <string_view>

namespace parapet::bench {

struct PassCost {
  std::string_view name;
  double fluid_flops, wall_flops;  // per pair
  double fluid_bytes, wall_bytes;  // per pair: every load and store that the code asks for
  double slot_bytes;               // per row slot that can come from nowhere but memory
  double particle_bytes;           // per particle likewise: each array once
};

// By the name of the pass; aborts for an unknown one.
const PassCost& pass_cost(std::string_view name);

}  // namespace parapet::bench
