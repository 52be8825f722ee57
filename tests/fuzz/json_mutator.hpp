/// Changes JSON texts so that most of them stay JSON: bytes changed at random die in the parser.
#pragma once

#include <cstddef>
#include <cstdint>

namespace parapet::fuzz {

/// Changes the text in `data` in place: one value of the document is replaced, dropped, moved or
/// written twice. A text that is no JSON, and one in eight others, is changed byte by byte.
/// @param size of the text [bytes]
/// @param max_size what `data` has room for [bytes]
/// @return size of the new text [bytes]
std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t max_size,
                        unsigned int seed);

}  // namespace parapet::fuzz
