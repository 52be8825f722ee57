/// Ctrl-C and SIGTERM ask the program to end in good order.
#pragma once

namespace parapet::cli {

/// From now on SIGINT and SIGTERM set a flag; a second one ends the program at once.
void install_interrupt_handler();

/// Whether one of them arrived.
bool interrupted();

}  // namespace parapet::cli
