/// Specs by path or by the name of a shipped one, with the spacing of the command line.
#pragma once

#include <optional>
#include <string>

#include "parapet/designs/study_spec.hpp"

namespace parapet::cli {

/// A document and what to call it in messages.
struct SpecDocument {
  designs::Json json;
  std::string file;
};

/// Reads a file; where there is none, the shipped spec with that name (folders and ending aside).
/// @throws designs::InputError
SpecDocument read_spec(const std::string& argument);

/// Each parses and checks, with another particle spacing when one is given.
/// @throws designs::InputError
designs::CaseSpec read_case(const std::string& argument, std::optional<double> spacing_mm);
designs::StudySpec read_study(const std::string& argument, std::optional<double> spacing_mm);
designs::SweepSpec read_sweep(const std::string& argument, std::optional<double> spacing_mm);

/// What the solver cannot number or this machine cannot hold.
/// @param file names the source in messages
/// @throws designs::InputError
void require_affordable(const designs::CaseSpec& spec, const std::string& file);
void require_affordable(const designs::StudySpec& study, const std::string& file);
void require_affordable(const designs::SweepSpec& sweep, const std::string& file);

}  // namespace parapet::cli
