/// The verb `evaluate`: one design, or a stream of them.
#pragma once

#include <string>

#include "common_options.hpp"
#include "session.hpp"

namespace parapet::cli {

/// What the verb is asked for.
struct EvaluateOptions : CommonOptions {
  std::string spec;
  std::string design;
  std::string log_folder;
  bool no_report = false;
  bool stream = false;
};

/// Designs from standard input, a record on standard output for each. The exit code.
int evaluate_stream(const Session& session, const EvaluateOptions& options);

}  // namespace parapet::cli
