/// Specs by path or by the name of a shipped one, with another particle spacing where one is given.
#pragma once

#include <optional>
#include <string>

#include "parapet/designs/study_spec.hpp"

namespace parapet::study {

/// A document and what to call it in messages.
struct SpecDocument {
  designs::Json json;
  std::string file;
};

/// Reads a file; where there is none, the shipped spec with that name (folders and ending aside).
/// @throws designs::InputError
SpecDocument read_spec(const std::string& argument);

/// Each parses and checks, with another particle spacing [mm] when one is given.
/// @throws designs::InputError
designs::CaseSpec read_case(const std::string& argument, std::optional<double> spacing_mm);

/// The same of a study.
designs::StudySpec read_study(const std::string& argument, std::optional<double> spacing_mm);

/// The same of a sweep.
designs::SweepSpec read_sweep(const std::string& argument, std::optional<double> spacing_mm);

/// The same of documents that were read already: `document.file` names the source in messages.
/// @throws designs::InputError
designs::CaseSpec case_of(const SpecDocument& document, std::optional<double> spacing_mm);

/// The same of a study.
designs::StudySpec study_of(const SpecDocument& document, std::optional<double> spacing_mm);

/// Refuses what the solver cannot number or this machine cannot hold.
/// @param file names the source in messages
/// @throws designs::InputError
void require_affordable(const designs::CaseSpec& spec, const std::string& file);

/// The same at every particle spacing of a study.
void require_affordable(const designs::StudySpec& study, const std::string& file);

/// The same of every row.
void require_affordable(const designs::SweepSpec& sweep, const std::string& file);

}  // namespace parapet::study
