/// How threads wait for each other.
#pragma once

namespace parapet::cli {

/// Makes OpenMP's threads sleep while they wait, unless the user's environment says how they wait.
/// By default they spin, and when other programs use the cores too, a spinning thread keeps from
/// its core the very thread that it waits for: measured 2 s against 72 s for the same run.
/// The OpenMP library reads its settings before main begins, so the program starts itself again
/// (same process, same arguments) with the setting made.
void let_waiting_threads_sleep(char** argv);

}  // namespace parapet::cli
