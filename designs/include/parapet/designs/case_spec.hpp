/// A case: one design, ready to simulate.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "parapet/designs/error.hpp"
#include "parapet/solver/simulation.hpp"

namespace parapet::designs {

/// JSON whose keys keep the order in which they were written.
using Json = nlohmann::ordered_json;

/// Says in the words of an InputError what the JSON library found wrong with the content of a file:
/// for files that Parapet wrote itself, which carry no schema.
[[noreturn]] void throw_misread(const std::filesystem::path& file, const Json::exception& error);

/// A parsed case file. `resolved` is the same case as JSON with every default written out: reading
/// it again gives the same case to the bit.
struct CaseSpec {
  std::string name;
  std::string description;
  solver::Scene scene;
  solver::Numerics numerics;
  solver::RunOptions run;  ///< threads stay 1; the caller decides
  Json resolved;
};

/// The undisturbed flow at one place, as a case's `approach` lists it, and back.
Json approach_json(const solver::Approach& flow);
/// @throws Json::exception
solver::Approach approach_from_json(const Json& json);

/// Gives a case the undisturbed flow at its barriers' feet, in place of what it had.
void set_approach(CaseSpec& spec, const solver::ApproachProfile& profile);

/// Reads and checks a case. `file` only names the source in messages.
/// @throws InputError with every issue found.
CaseSpec parse_case(const Json& json, const std::string& file);

/// Parses JSON text. `file` only names the source in messages.
/// @throws InputError for a syntax error (with line and column) or a key that stands twice.
Json parse_json(const std::string& text, const std::string& file);

/// The same with the text read from disk.
/// @throws InputError
Json read_json(const std::filesystem::path& file);

/// What a document says it is: "parapet-case/1", "parapet-study/1" or "parapet-sweep/1".
/// @throws InputError when it says nothing or something else.
std::string document_format(const Json& json, const std::string& file);

/// The same with the file read from disk.
CaseSpec load_case(const std::filesystem::path& file);

}  // namespace parapet::designs
