/// The beginning that designs share: until a barrier comes into sight, designs with the same
/// channel, material and numerics are one flow. simulate() keeps states of it here, and later runs
/// go on from the last one that their own barriers allow. The answer has the same bits with and
/// without it; it counts all steps, also those that were not computed again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace parapet::solver {

/// A store of such states; any number of simulations may use it side by side.
class StartStates {
 public:
  /// @param most_bytes memory that the states may take; the flow that was longest not asked for
  ///        goes first. A state takes 0.2 kB a particle, and a flow has up to 32.
  explicit StartStates(std::size_t most_bytes = std::size_t{256} << 20);
  ~StartStates();
  StartStates(const StartStates&) = delete;
  StartStates& operator=(const StartStates&) = delete;

  /// How often a run went on from a state, and the time steps that this saved.
  struct Use {
    std::int64_t runs = 0;   ///< that went on from a state
    std::int64_t steps = 0;  ///< that they did not compute
  };
  Use use() const;  ///< so far

  class Store;                              ///< private to the solver
  Store& store() const { return *store_; }  ///< likewise

 private:
  std::unique_ptr<Store> store_;
};

}  // namespace parapet::solver
