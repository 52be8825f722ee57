/// The flow that a barrier meets, had it not been there: what hand formulas of its load ask for.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "parapet/solver/numerics.hpp"
#include "parapet/solver/result.hpp"
#include "parapet/solver/scene.hpp"

namespace parapet::solver {

struct RunOptions;
struct Progress;

/// The undisturbed flow at one place; a member is absent where the flow did not come so far.
struct Approach {
  std::optional<double> front_velocity;  ///< over front_base about the place [m/s]
  std::optional<double> depth;           ///< largest mean over depth_window upstream of it [m]

  /// Of the front's velocity and that depth.
  std::optional<double> froude_number(const Scene& scene) const;
  friend bool operator==(const Approach&, const Approach&) = default;
};

/// The same along the channel.
struct ApproachProfile {
  std::vector<double> x;         ///< [n_places] rising, along the bed [m]
  std::vector<Approach> places;  ///< [n_places]
  /// At any place: linear between the two next to it, absent where one of them is.
  Approach at(double place) const;
};

/// The event without barriers, gauged where the last of them stood: all that decides the
/// undisturbed flow but the numerics.
Scene undisturbed(const Scene& scene);

/// A run of an event without barriers.
struct UndisturbedRun {
  Result result;
  ApproachProfile profile;  ///< empty unless the run ended well
};

/// Simulates a scene without barriers, and gauges it along the whole channel.
/// @pre `open` has no barriers; nothing is asked of places beyond its monitor_x, where it ends
/// early
/// @param on_progress returns false to cancel; may be empty
/// @throws std::invalid_argument like simulate()
UndisturbedRun simulate_undisturbed(const Scene& open, const Numerics& numerics,
                                    const RunOptions& options,
                                    const std::function<bool(const Progress&)>& on_progress = {});

}  // namespace parapet::solver
