#include "parapet/records/checksum.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>

namespace parapet::records {
namespace {

/// The remainders of all bytes by the reflected polynomial.
constexpr std::array<std::uint32_t, 256> crc_table() {
  constexpr std::uint32_t polynomial = 0x82F63B78U;
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t rest = byte;
    for (int bit = 0; bit < 8; ++bit) rest = (rest >> 1) ^ ((rest & 1U) != 0 ? polynomial : 0U);
    table[byte] = rest;
  }
  return table;
}

constexpr std::string_view crc_mark = ",\"crc32c\":\"";
constexpr std::size_t crc_digits = 8;
constexpr std::string_view crc_ending = "\"}";

// The constants of FIPS 180-4, 4.2.2 and 5.3.3.
constexpr std::array<std::uint32_t, 64> sha_constants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};
constexpr std::size_t sha_block = 64;

using ShaState = std::array<std::uint32_t, 8>;

/// FIPS 180-4, 6.2.2.
void add_block(ShaState& state, std::string_view block) {
  std::array<std::uint32_t, 64> w{};
  for (std::size_t t = 0; t < 16; ++t) {
    for (std::size_t k = 0; k < 4; ++k) {
      w[t] = (w[t] << 8) | static_cast<unsigned char>(block[4 * t + k]);
    }
  }
  for (std::size_t t = 16; t < 64; ++t) {
    const std::uint32_t s0 = std::rotr(w[t - 15], 7) ^ std::rotr(w[t - 15], 18) ^ (w[t - 15] >> 3);
    const std::uint32_t s1 = std::rotr(w[t - 2], 17) ^ std::rotr(w[t - 2], 19) ^ (w[t - 2] >> 10);
    w[t] = w[t - 16] + s0 + w[t - 7] + s1;
  }
  auto [a, b, c, d, e, f, g, h] = state;
  for (std::size_t t = 0; t < 64; ++t) {
    const std::uint32_t s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
    const std::uint32_t t1 = h + s1 + ((e & f) ^ (~e & g)) + sha_constants[t] + w[t];
    const std::uint32_t s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
    const std::uint32_t t2 = s0 + ((a & b) ^ (a & c) ^ (b & c));
    h = g, g = f, f = e, e = d + t1, d = c, c = b, b = a, a = t1 + t2;
  }
  const ShaState sums{a, b, c, d, e, f, g, h};
  for (std::size_t k = 0; k < state.size(); ++k) state[k] += sums[k];
}

}  // namespace

std::uint32_t crc32c(std::string_view bytes) {
  static constexpr std::array<std::uint32_t, 256> table = crc_table();
  std::uint32_t rest = ~0U;
  for (const char c : bytes) {
    rest = (rest >> 8) ^ table[(rest ^ static_cast<unsigned char>(c)) & 0xFFU];
  }
  return ~rest;
}

std::string sha256(std::string_view bytes) {
  ShaState state{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  const std::size_t whole = bytes.size() / sha_block * sha_block;
  for (std::size_t at = 0; at < whole; at += sha_block) {
    add_block(state, bytes.substr(at, sha_block));
  }
  std::string end(bytes.substr(whole));
  end += '\x80';
  end.append((2 * sha_block - 8 - end.size()) % sha_block, '\0');
  const std::uint64_t bits = 8ULL * bytes.size();
  for (int shift = 56; shift >= 0; shift -= 8) end += static_cast<char>((bits >> shift) & 0xFFU);
  for (std::size_t at = 0; at < end.size(); at += sha_block) {
    add_block(state, std::string_view(end).substr(at, sha_block));
  }
  std::string text;
  for (const std::uint32_t word : state) text += fmt::format("{:08x}", word);
  return text;
}

std::string line_with_checksum(const designs::Json& object) {
  std::string line = object.dump();
  line.pop_back();  // the closing brace
  const std::uint32_t sum = crc32c(line);
  return line + fmt::format("{}{:08x}{}", crc_mark, sum, crc_ending);
}

LineChecksum check_line(std::string_view line) {
  constexpr std::size_t length = crc_mark.size() + crc_digits + crc_ending.size();
  if (line.size() < length) return LineChecksum::none;
  const std::size_t end = line.size() - length;
  if (line.substr(end, crc_mark.size()) != crc_mark || !line.ends_with(crc_ending))
    return LineChecksum::none;
  const std::string sum = fmt::format("{:08x}", crc32c(line.substr(0, end)));
  return line.substr(end + crc_mark.size(), crc_digits) == sum ? LineChecksum::right
                                                               : LineChecksum::wrong;
}

}  // namespace parapet::records
