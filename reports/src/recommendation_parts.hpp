/// The pieces that a recommendation is put together from.
#pragma once

#include <string>

#include "design_choice.hpp"
#include "study_log.hpp"

namespace parapet::reports {

/// A fit explains designs left out of it roughly from here on, and can be trusted from there.
constexpr double rough_r2 = 0.3;
constexpr double trusted_r2 = 0.7;

/// What each variable does to each metric that the study asks about; shape in recommendation.cpp.
designs::Json effects_json(const StudyLog& log);

/// What it takes to leave a design of the front: for each objective in which another design is
/// better, the nearest of these and the best, with the change in every objective.
designs::Json leaving_json(const Choice& choice, const LoggedDesign& from);

/// {reference, value, history [...]} of pareto.json; null without it.
designs::Json hypervolume_json(const StudyLog& log);

// Sections of the text; each is empty when there is nothing to say.

std::string opening_section(const designs::Json& json);
std::string front_section(const designs::Json& json);
std::string confirmation_section(const designs::Json& json);
std::string sensitivity_section(const designs::Json& json);
std::string study_section(const designs::Json& json);

/// "deflector angle 45°, deflector plate and height 0.2 m".
std::string design_words(const designs::Json& design);

/// An objective's name: "launch length", with its statistic if it has one.
std::string objective_name(const designs::Json& objective);

/// The same with its unit: "launch length [m]".
std::string objective_label(const designs::Json& objective);

/// The key whose suffix is an objective's unit; empty for a formula without a name.
std::string objective_unit_key(const designs::Json& objective);

/// "0.25 m".
std::string objective_value(const designs::Json& objective, const std::optional<double>& value);

/// What a constraint limits, with unit and statistic; its name where it limits a formula.
std::string constraint_label(const designs::Json& constraint);

/// "0.93 (0.91 to 0.95)": an estimate with its 95 % interval; "-" when there is none.
std::string estimate_text(const designs::Json& objective);

/// The recommendation for a reader, from its JSON.
std::string recommendation_text(const designs::Json& json);

}  // namespace parapet::reports
