#include <cerrno>
#include <exception>
#include <filesystem>
#include <string>

#include "parapet/designs/case_spec.hpp"
#include "parapet/designs/error.hpp"
#include "parapet/records/atomic_file.hpp"
#include "parts.hpp"

namespace parapet::python {
namespace {

namespace py = pybind11;

void raise_input_error(const designs::InputError& error) {
  const py::module_ errors = py::module_::import("parapet.errors");
  py::list issues;
  for (const designs::InputIssue& issue : error.issues()) {
    issues.append(
        errors.attr("Issue")(issue.file, issue.pointer, issue.value, issue.problem, issue.allowed));
  }
  const py::object type = errors.attr("InputError");
  PyErr_SetObject(type.ptr(), type(issues).ptr());
}

void raise_file_error(const std::string& text) {
  const py::object type = py::module_::import("parapet.errors").attr("FileError");
  PyErr_SetObject(type.ptr(), type(text).ptr());
}

void translate(std::exception_ptr error) {
  try {
    if (error) std::rethrow_exception(error);
  } catch (const designs::InputError& input) {
    raise_input_error(input);
  } catch (const records::FileError& file) {
    raise_file_error(file.what());
  } catch (const std::filesystem::filesystem_error& file) {
    raise_file_error(file.path1().string() + ": " + file.code().message());
  } catch (const designs::Json::exception& json) {
    const std::string text = std::string("this is not what Parapet writes: ") + json.what();
    PyErr_SetString(PyExc_ValueError, text.c_str());
  }
}

}  // namespace

void add_errors(py::module_&) {
  py::register_exception_translator(&translate);
}

}  // namespace parapet::python
