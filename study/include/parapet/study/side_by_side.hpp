/// Many independent tasks over a number of workers.
#pragma once

#include <cstddef>
#include <functional>

namespace parapet::study {

/// Runs task(index, threads) for index 0 .. count-1, at most `jobs` at a time, handed out in
/// order. With fewer tasks than jobs each may use several threads, whose number is passed on.
/// The first exception stops the handing out; it is thrown again when all workers have ended.
/// @param stop polled before each task; true ends the handing out. May be empty.
void run_side_by_side(std::size_t count, int jobs,
                      const std::function<void(std::size_t index, int threads)>& task,
                      const std::function<bool()>& stop = {});

}  // namespace parapet::study
