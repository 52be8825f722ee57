// docs/metrics.md says what the program says.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "parapet/solver/result.hpp"

namespace parapet::solver {
namespace {

TEST(MetricDocs, DefineEveryMetricInTheProgramsWords) {
  std::ifstream file(METRICS_DOC);
  ASSERT_TRUE(file) << METRICS_DOC;
  std::stringstream text;
  text << file.rdbuf();
  for (const MetricInfo& info : metric_catalog(1)) {
    std::string key = info.key;
    if (key.rfind("barrier_1_", 0) == 0) key.replace(0, 10, "barrier_K_");
    const std::string row = "| `" + key + "` | " + info.definition;
    EXPECT_NE(text.str().find(row), std::string::npos) << row;
  }
}

}  // namespace
}  // namespace parapet::solver
