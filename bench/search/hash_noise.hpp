// Noise that repeats: the same design has the same noise, a neighbour has another.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace parapet::bench::search {

// A standard normal number that is a function of the bits of u and of the stream's name.
double hash_normal(const std::vector<double>& u, const std::string& stream);

// 64 well mixed bits of a number (splitmix64, Steele, Lea and Flood, OOPSLA 2014).
std::uint64_t mix(std::uint64_t bits);

}  // namespace parapet::bench::search
