/// What the programs `parapet` and `parapet-validate` share: arguments in, exit code out.
#pragma once

#include <initializer_list>

#include "session.hpp"

namespace parapet::cli {

/// Adds a verb to a program; the session outlives the app.
using AddVerb = void (*)(CLI::App& app, Session& session);

/// Runs the verb that the arguments name. Never throws: whatever goes wrong becomes a message on
/// standard error and an exit code.
/// @param service who simulates the designs of studies, the rows of sweeps and what confirms a
/// design
int run_program(int argc, char** argv, std::initializer_list<AddVerb> verbs,
                study::ServiceFactory service = study::local_service());

}  // namespace parapet::cli
