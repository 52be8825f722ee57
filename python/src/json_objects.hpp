/// JSON as Python objects.
#pragma once

#include <pybind11/pybind11.h>

#include "parapet/designs/case_spec.hpp"

namespace parapet::python {

/// dict, list, str, int, float, bool, None. Numbers keep every bit, objects their order.
pybind11::object to_python(const designs::Json& json);

}  // namespace parapet::python
