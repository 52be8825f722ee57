/// Numbers and records as a person reads them.
#pragma once

#include <string>

#include "parapet/records/evaluation_log.hpp"
#include "parapet/solver/result.hpp"

namespace parapet::cli {

/// One line per metric, aligned; where a value is absent, the reason.
std::string metrics_text(const std::vector<solver::Metric>& metrics);

/// One line per warning; empty without any.
std::string warnings_text(const std::vector<solver::Warning>& warnings);

/// "deflector_angle_deg 45, upstream_height_m 0.1".
std::string design_text(const designs::Design& design);

/// "deflector plate, deflector_angle_deg 45": options by their names.
std::string design_text(const records::EvaluationRecord& record);

/// "retention_efficiency 0.83".
std::string objectives_text(const records::EvaluationRecord& record);

/// "launch_length_m, stem": the constraints that a record violates; empty when it meets all.
std::string violated_text(const records::EvaluationRecord& record);

/// A header and one line for each record, in columns: id, the study's variables, its objectives.
/// Inactive variables are shown as "-".
std::string front_table(const designs::StudySpec& study,
                        const std::vector<records::EvaluationRecord>& records);

/// Several lines: design, objectives, constraints with their margins.
std::string record_text(const records::EvaluationRecord& record);

}  // namespace parapet::cli
