#include "json_mutator.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace parapet::fuzz {
namespace {

using Json = nlohmann::ordered_json;

/// Values at which programs break: limits of types, units gone wrong, texts where numbers belong.
const std::vector<std::string>& awkward_values() {
  static const std::vector<std::string> values{"null",
                                               "true",
                                               "[]",
                                               "{}",
                                               "\"\"",
                                               "\"NaN\"",
                                               "\"\\u0000\"",
                                               "\"../x\"",
                                               "\"<b>\"",
                                               "0",
                                               "-0.0",
                                               "-1",
                                               "1",
                                               "2",
                                               "1e-320",
                                               "1e308",
                                               "-1e308",
                                               "1e-9",
                                               "1e9",
                                               "0.005",
                                               "4294967296",
                                               "9007199254740993",
                                               "-9223372036854775808",
                                               "18446744073709551615",
                                               "[1]",
                                               "[0, 1]",
                                               "[[]]",
                                               "{\"lower\": 1, \"upper\": 0}",
                                               "\"a + b\"",
                                               "\"1/0\""};
  return values;
}

/// Every value below `json`, itself included, as pointers that stay valid while nothing changes.
void collect(Json& json, std::vector<Json*>& nodes) {
  nodes.push_back(&json);
  if (!json.is_structured()) return;
  for (Json& child : json) collect(child, nodes);
}

std::size_t draw(std::mt19937& engine, std::size_t count) {
  return engine() % count;
}

Json awkward(std::mt19937& engine) {
  return Json::parse(awkward_values()[draw(engine, awkward_values().size())]);
}

/// A number near the old one: most limits are found by small steps.
Json nearby(const Json& number, std::mt19937& engine) {
  constexpr std::array<double, 8> factors{-1.0, 0.0, 0.5, 0.99, 1.01, 2.0, 10.0, 1000.0};
  const double scaled = number.get<double>() * factors[draw(engine, factors.size())];
  if (number.is_number_float() || draw(engine, 4) == 0) return scaled;
  // Unsigned, so that the largest number has a successor too.
  return static_cast<std::int64_t>(number.get<std::uint64_t>() + draw(engine, 5) - 2);
}

void change_object(Json& object, const Json& other, std::mt19937& engine) {
  const std::size_t chosen = object.empty() ? 0 : draw(engine, object.size());
  const auto member = std::next(object.begin(), static_cast<std::ptrdiff_t>(chosen));
  if (object.empty() || draw(engine, 3) == 0) {
    object[object.empty() ? "name" : member.key() + "x"] = other;
  } else {
    object.erase(member);
  }
}

void change_array(Json& array, const Json& other, std::mt19937& engine) {
  const auto at = array.begin() + static_cast<std::ptrdiff_t>(draw(engine, array.size() + 1));
  if (array.empty() || draw(engine, 2) == 0) {
    array.insert(at, other);
  } else {
    array.erase(draw(engine, array.size()));
  }
}

void change(Json& document, std::mt19937& engine) {
  std::vector<Json*> nodes;
  collect(document, nodes);
  Json& node = *nodes[draw(engine, nodes.size())];
  const Json other = draw(engine, 2) == 0 ? awkward(engine) : *nodes[draw(engine, nodes.size())];
  if (node.is_number() && draw(engine, 2) == 0) {
    node = nearby(node, engine);
  } else if (node.is_object() && draw(engine, 4) != 0) {
    change_object(node, other, engine);
  } else if (node.is_array() && draw(engine, 4) != 0) {
    change_array(node, other, engine);
  } else {
    node = other;
  }
}

}  // namespace

std::size_t mutate_json(std::uint8_t* data, std::size_t size, std::size_t max_size,
                        unsigned int seed) {
  std::mt19937 engine(seed);
  Json document = Json::parse(data, data + size, nullptr, false);
  if (document.is_discarded() || draw(engine, 8) == 0) {
    return LLVMFuzzerMutate(data, size, max_size);
  }
  for (std::size_t changes = 1 + draw(engine, 3); changes > 0; --changes) change(document, engine);
  const std::string text = document.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
  std::memcpy(data, text.data(), text.size());
  return text.size();
}

}  // namespace parapet::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned int seed) {
  return parapet::fuzz::mutate_json(data, size, max_size, seed);
}
