/// Colours that plots and pictures of the flow share.
#pragma once

#include "parapet/reports/canvas.hpp"

namespace parapet::reports {

inline constexpr Color ink{0.13, 0.13, 0.15, 1.0};
inline constexpr Color frame_color{0.35, 0.35, 0.38, 1.0};

}  // namespace parapet::reports
