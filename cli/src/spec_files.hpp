/// Specs by path or by the name of a shipped one, as every verb reads them.
#pragma once

#include "parapet/study/spec_files.hpp"

namespace parapet::cli {

using study::read_case;
using study::read_spec;
using study::read_study;
using study::read_sweep;
using study::require_affordable;
using study::SpecDocument;

}  // namespace parapet::cli
