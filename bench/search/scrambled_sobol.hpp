// Sobol' points that differ from seed to seed.
#pragma once

#include <cstdint>
#include <vector>

#include "parapet/optimizer/sobol.hpp"

namespace parapet::bench::search {

// A Sobol' sequence whose bits are exclusive-ored with random ones, the same for all points: the
// random digital shift, which keeps how the points fill the cube (Owen, in Monte Carlo and
// Quasi-Monte Carlo Methods 1994, 299-317, section 3).
class ScrambledSobol {
 public:
  ScrambledSobol(int dimension, std::uint64_t seed);

  // [dimension], in (0, 1).
  std::vector<double> next();

 private:
  optimizer::SobolSequence sequence_;
  std::vector<std::uint64_t> shift_;  // [dimension], 52 bits
};

}  // namespace parapet::bench::search
