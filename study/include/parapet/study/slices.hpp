/// The surrogates along one variable at a time, through a design.
#pragma once

#include <string>
#include <vector>

#include "parapet/designs/study_spec.hpp"
#include "parapet/study/sensitivity_file.hpp"

namespace parapet::study {

/// One quantity along one variable, the others as the design has them; in the quantity's unit.
struct Slice {
  std::string variable;
  std::vector<VariablePlace> at;                   ///< [n]
  std::vector<double> median, lower_95, upper_95;  ///< [n] of the prediction at the finest spacing
};

/// All slices of one modelled quantity.
struct MetricSlices {
  std::string metric;
  std::vector<Slice> slices;  ///< of the variables that the design has, in the study's order
  std::string name = {};      ///< of the surrogate: a metric may be modelled by two, such as a
                              ///< quantile and a share of the events
};

/// @param surrogates format "parapet-surrogates/1"
/// @param places along a continuous variable; options and whole numbers once each
/// @throws std::invalid_argument or nlohmann::json::exception when the surrogates are damaged
std::vector<MetricSlices> surrogate_slices(const designs::StudySpec& study,
                                           const designs::Json& surrogates,
                                           const designs::Design& design, int places = 41);

}  // namespace parapet::study
