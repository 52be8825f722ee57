/// What is wrong with a problem or the options, before anything is evaluated.
#pragma once

#include <string>

#include "parapet/bayesian/search.hpp"

namespace parapet::bayesian {

/// One sentence, empty when all is sound.
std::string problem_error(const Problem& problem, const SearchOptions& options);

}  // namespace parapet::bayesian
