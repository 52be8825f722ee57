/// Surrogates as surrogates.json holds them.
#pragma once

#include <optional>

#include "parapet/designs/study_spec.hpp"
#include "parapet/surrogate/gaussian_process.hpp"

namespace parapet::study {

/// The process of one entry of /metrics, conditioned on its data with its parameters as they are;
/// empty for a formula and where there was none.
/// @throws std::invalid_argument or nlohmann::json::exception saying what is wrong
std::optional<surrogate::GaussianProcess> stored_process(const designs::Json& surrogates,
                                                         const designs::Json& metric);

}  // namespace parapet::study
