/// Which build of the program this is.
#pragma once

#include "parapet/cli/run_parapet.hpp"
