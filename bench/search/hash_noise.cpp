#include "hash_noise.hpp"

#include <bit>
#include <cmath>
#include <numbers>

namespace parapet::bench::search {

std::uint64_t mix(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15ULL;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ULL;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebULL;
  return bits ^ (bits >> 31);
}

double hash_normal(const std::vector<double>& u, const std::string& stream) {
  std::uint64_t state = 0;
  for (const char c : stream) state = mix(state ^ static_cast<unsigned char>(c));
  for (const double coordinate : u) {
    state = mix(state ^ std::bit_cast<std::uint64_t>(coordinate + 0.0));  // -0 and 0 are one
  }
  // Box and Muller (Ann. Math. Stat. 29 (1958) 610-611) from two uniform numbers in (0, 1)
  const auto uniform = [](std::uint64_t bits) {
    return (static_cast<double>(bits >> 11) + 0.5) * 0x1p-53;
  };
  return std::sqrt(-2.0 * std::log(uniform(mix(state)))) *
         std::cos(2.0 * std::numbers::pi * uniform(mix(state + 1)));
}

}  // namespace parapet::bench::search
