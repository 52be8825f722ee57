/// The program `parapet`: arguments in, exit code out.
#pragma once

namespace parapet::cli {

/// Never throws: whatever goes wrong becomes a message on standard error and an exit code.
int run_program(int argc, char** argv);

}  // namespace parapet::cli
