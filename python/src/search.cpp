#include <pybind11/stl.h>

#include <string>
#include <utility>
#include <vector>

#include "json_objects.hpp"
#include "parapet/study/front.hpp"
#include "parapet/study/study_search.hpp"
#include "parts.hpp"

namespace parapet::python {
namespace {

namespace py = pybind11;
using designs::Json;
using study::StudySearch;

records::EvaluationRecord record_of(const std::string& text) {
  return records::record_from_json(designs::parse_json(text, "the record"));
}

py::object ask(StudySearch& search) {
  std::optional<study::AskedDesign> asked;
  {
    const py::gil_scoped_release release;
    asked = search.ask();
  }
  if (!asked) return py::none();
  return py::make_tuple(asked->id, to_python(designs::design_json(search.study(), asked->design)),
                        asked->spacing, asked->stage);
}

py::list records_of(const study::Front& front) {
  py::list out;
  for (const records::EvaluationRecord& record : front.designs) {
    out.append(to_python(records::to_json(record)));
  }
  return out;
}

py::tuple front_of(const designs::StudySpec& study, const std::vector<std::string>& texts) {
  std::vector<records::EvaluationRecord> all;
  for (const std::string& text : texts) {
    all.push_back(record_of(text));
    all.back().id = records::evaluation_id(static_cast<int>(all.size()));
  }
  const study::Front front = study::make_front(study, all);
  return py::make_tuple(records_of(front), front.hypervolume);
}

}  // namespace

void add_search(py::module_& module) {
  py::class_<StudySearch>(module, "Search")
      .def(py::init([](const designs::StudySpec& study) { return new StudySearch(study); }))
      .def("ask", &ask)
      .def("tell", [](StudySearch& search, int id,
                      const std::string& record) { search.tell(id, record_of(record)); })
      .def("tell_other", [](StudySearch& search,
                            const std::string& record) { search.tell_other(record_of(record)); })
      .def("stop_reason", &StudySearch::stop_reason)
      .def("records",
           [](const StudySearch& search) {
             py::list out;
             for (const auto& one : search.records()) out.append(to_python(records::to_json(one)));
             return out;
           })
      .def("front",
           [](const StudySearch& search) {
             const study::Front front = search.front();
             return py::make_tuple(records_of(front), front.hypervolume);
           })
      .def("front_json", [](const StudySearch& search) { return to_python(search.front_json()); });
  module.def("front", &front_of);
}

}  // namespace parapet::python
