/// What the programs `parapet` and `parapet-validate` share: arguments in, exit code out.
#pragma once

#include <initializer_list>

#include "session.hpp"

namespace parapet::cli {

/// Adds a verb to a program; the session outlives the app.
using AddVerb = void (*)(CLI::App& app, Session& session);

/// Runs the verb that the arguments name. Never throws: whatever goes wrong becomes a message on
/// standard error and an exit code.
int run_program(int argc, char** argv, std::initializer_list<AddVerb> verbs);

}  // namespace parapet::cli
