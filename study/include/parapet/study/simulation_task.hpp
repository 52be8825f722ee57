/// One simulation that is to be done, as a value: nothing in it refers to the sender's memory.
#pragma once

#include <string>

#include "parapet/designs/study_spec.hpp"

namespace parapet::study {

/// A design under one event at one particle spacing.
struct SimulationTask {
  std::string label;       ///< for people: an evaluation's id, with scenarios "ID SCENARIO"
  designs::Design design;  ///< what the case was made of; does not decide the result
  std::string scenario;    ///< likewise; empty: the base event
  designs::CaseSpec spec;  ///< the resolved case, particle spacing included: decides the result
  int threads = 1;         ///< the simulation may use at most so many; does not decide the result
  std::string key;         ///< records::case_hash(spec): tasks of the same key have the same result

  double spacing() const { return spec.numerics.spacing; }  ///< particle spacing [m]
};

/// The task of a design under an event.
/// @param scenario null: the base event
/// @param spacing particle spacing [m]
/// @throws designs::InputError when the design gives an impossible scene.
SimulationTask make_task(const designs::StudySpec& study, const designs::Design& design,
                         const designs::Scenario* scenario, double spacing, std::string label,
                         int threads);

/// The task of a case that was resolved before.
SimulationTask task_from_case(designs::CaseSpec spec, std::string label);

/// As JSON, format "parapet-simulation-task/1", and back: the same case to the bit.
designs::Json to_json(const SimulationTask& task);

/// @throws designs::InputError when the case is wrong, std::runtime_error or
///         nlohmann::json::exception for anything else, also when the key is not that of the case.
SimulationTask task_from_json(const designs::Json& json);

}  // namespace parapet::study
