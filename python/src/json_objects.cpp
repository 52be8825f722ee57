#include "json_objects.hpp"

#include <cstdint>

namespace parapet::python {
namespace py = pybind11;

py::object to_python(const designs::Json& json) {
  switch (json.type()) {
    case designs::Json::value_t::object: {
      py::dict object;
      for (const auto& [key, value] : json.items()) object[py::str(key)] = to_python(value);
      return object;
    }
    case designs::Json::value_t::array: {
      py::list list;
      for (const designs::Json& value : json) list.append(to_python(value));
      return list;
    }
    case designs::Json::value_t::string:
      return py::str(json.get_ref<const std::string&>());
    case designs::Json::value_t::boolean:
      return py::bool_(json.get<bool>());
    case designs::Json::value_t::number_integer:
      return py::int_(json.get<std::int64_t>());
    case designs::Json::value_t::number_unsigned:
      return py::int_(json.get<std::uint64_t>());
    case designs::Json::value_t::number_float:
      return py::float_(json.get<double>());
    default:
      return py::none();
  }
}

}  // namespace parapet::python
