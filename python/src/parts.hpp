/// The parts of the module `parapet._native`. Python's side of each is in python/parapet: types,
/// units and documentation live there; here only what must cross the border does.
#pragma once

#include <pybind11/pybind11.h>

namespace parapet::python {

void add_errors(pybind11::module_& module);    ///< exceptions of the libraries as Python's
void add_simulate(pybind11::module_& module);  ///< cases, their drawings and their simulations
void add_study(pybind11::module_& module);     ///< studies, and designs judged by them
void add_search(pybind11::module_& module);    ///< the search by ask and tell, and fronts
void add_advice(pybind11::module_& module);    ///< recommendations
void add_tasks(pybind11::module_& module);     ///< simulations for somebody else's machine
void add_program(pybind11::module_& module);   ///< the verbs of the program

}  // namespace parapet::python
