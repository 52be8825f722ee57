#include "scrambled_sobol.hpp"

#include "hash_noise.hpp"

namespace parapet::bench::search {

ScrambledSobol::ScrambledSobol(int dimension, std::uint64_t seed) : sequence_(dimension) {
  for (int j = 0; j < dimension; ++j) {
    shift_.push_back(mix(mix(seed) + static_cast<std::uint64_t>(j)) >> 12);
  }
}

std::vector<double> ScrambledSobol::next() {
  std::vector<double> u = sequence_.next();
  for (std::size_t j = 0; j < u.size(); ++j) {
    const auto bits = static_cast<std::uint64_t>(u[j] * 0x1p52) ^ shift_[j];
    u[j] = (static_cast<double>(bits) + 0.5) * 0x1p-52;  // the half keeps 0 out
  }
  return u;
}

}  // namespace parapet::bench::search
