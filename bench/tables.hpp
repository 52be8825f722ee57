// The tables that people read. Each is empty when nothing of it was measured.
#pragma once

#include <string>

#include "report_input.hpp"

namespace parapet::bench {

// What | target | measured | met?
std::string target_table(const Report& report);
// Where each neighbour sum stands under the ceilings of this machine.
std::string roofline_table(const Report& report);
// Cost against particles and threads with fitted exponents.
std::string scaling_table(const Report& report);
// How fast this is as a multiple of the baseline; `scaled`: by what the two machines' peaks differ.
std::string comparison_table(const Report& report, const Report& baseline);

}  // namespace parapet::bench
