#include "parapet/records/deflate.hpp"

#include <zlib.h>

#include <limits>
#include <stdexcept>

namespace parapet::records {

std::string deflated(std::span<const std::uint8_t> bytes) {
  if (bytes.size() > std::numeric_limits<uLong>::max() / 2) {
    throw std::length_error("too much to compress at once");
  }
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  const int code = compress2(reinterpret_cast<Bytef*>(out.data()), &size, bytes.data(),
                             static_cast<uLong>(bytes.size()), 6);
  if (code != Z_OK) throw std::runtime_error("zlib cannot compress: out of memory");
  out.resize(size);
  return out;
}

std::vector<std::uint8_t> inflated(std::string_view bytes, std::size_t size) {
  std::vector<std::uint8_t> out(size);
  auto got = static_cast<uLongf>(size);
  const int code = uncompress(out.data(), &got, reinterpret_cast<const Bytef*>(bytes.data()),
                              static_cast<uLong>(bytes.size()));
  if (code != Z_OK || got != size) throw std::runtime_error("compressed data are damaged");
  return out;
}

}  // namespace parapet::records
