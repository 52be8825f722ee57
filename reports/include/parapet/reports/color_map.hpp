/// A perceptually uniform colour scale.
#pragma once

#include "parapet/reports/canvas.hpp"

namespace parapet::reports {

/// Viridis (van der Walt and Smith, 2015): dark blue at 0, yellow at 1; clamped out of that range.
Color viridis(double share);

/// Colour number `index` of a palette that colour-blind readers can tell apart (Okabe and Ito,
/// 2008); it repeats after seven.
Color palette_color(int index);

}  // namespace parapet::reports
