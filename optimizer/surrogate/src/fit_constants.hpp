/// Numbers that several fits share.
#pragma once

namespace parapet::surrogate {

inline constexpr double log_two_pi = 1.8378770664093454836;

/// A descent ends when the log-likelihood changes by less [nats].
inline constexpr double tolerance_nats = 1e-3;

/// A handful of parameters does not need more observations, and each likelihood costs their number
/// cubed; the process itself is conditioned on all of them.
inline constexpr int most_for_parameters = 150;

/// The same for outcomes, of which one call costs several times as much.
inline constexpr int most_outcomes_for_parameters = 400;

}  // namespace parapet::surrogate
