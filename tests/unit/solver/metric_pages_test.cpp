// docs/metrics.md and designs/schema/metrics.schema.json say what the table of metrics says. To
// write them anew after a change of the table, set PARAPET_WRITE_PAGES and run these tests.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "parapet/solver/metric_catalog.hpp"

namespace parapet::solver {
namespace {

std::string file_text(const std::string& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Compares a committed file with what it should hold, or writes it.
void expect_file(const std::string& path, const std::string& text) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): no other thread runs
  if (std::getenv("PARAPET_WRITE_PAGES") != nullptr) {
    std::ofstream(path) << text;
    return;
  }
  EXPECT_EQ(file_text(path), text)
      << path << " is not what the table of metrics says; write it anew with\n"
      << "PARAPET_WRITE_PAGES=1 ctest --test-dir BUILD_FOLDER -R MetricPages";
}

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string range_text(const MetricInfo& info) {
  if (std::isfinite(info.least) && std::isfinite(info.greatest)) {
    return number(info.least) + " to " + number(info.greatest);
  }
  if (std::isfinite(info.least)) return "at least " + number(info.least);
  return std::isfinite(info.greatest) ? "at most " + number(info.greatest) : "any";
}

std::string markdown_table() {
  std::string text =
      "| key | unit | values | definition | absent when |\n"
      "|---|---|---|---|---|\n";
  for (const MetricInfo& info : metric_definitions()) {
    std::string reasons;
    for (const std::string& reason : info.absent_when) {
      reasons += (reasons.empty() ? "" : "; or ") + reason;
    }
    text += "| `" + info.key + "` | " + (info.unit.empty() ? "-" : info.unit) + " | " +
            range_text(info) + " | " + info.definition + " | " +
            (reasons.empty() ? "never" : reasons) + " |\n";
  }
  return text;
}

TEST(MetricPages, TheDocumentedTableIsTheProgramsTable) {
  const std::string path = METRICS_DOC, text = file_text(path);
  const std::string begin = "<!-- the table of metrics, written by the program -->\n";
  const std::string end = "<!-- end of the table -->\n";
  const std::size_t from = text.find(begin), to = text.find(end);
  ASSERT_NE(from, std::string::npos) << "no line " << begin;
  ASSERT_NE(to, std::string::npos) << "no line " << end;
  expect_file(path, text.substr(0, from + begin.size()) + markdown_table() + text.substr(to));
}

TEST(MetricPages, TheSchemaListsTheProgramsKeys) {
  std::string keys;
  for (const MetricInfo& info : metric_catalog(1)) {
    keys += (keys.empty() ? "        \"" : ",\n        \"") + info.key + "\"";
  }
  expect_file(METRICS_SCHEMA, R"({
  "$schema": "http://json-schema.org/draft-07/schema#",
  "$id": "metrics.schema.json",
  "title": "Parapet metrics",
  "description": "The keys of metrics, written by the program from its table of metrics: do not edit.",
  "definitions": {
    "metric": {
      "description": "Key of a metric; docs/metrics.md defines each. barrier_1_ is the barrier furthest upstream; barrier_2_ and so on have the same metrics.",
      "type": "string",
      "minLength": 1,
      "examples": [
)" + keys + R"(
      ]
    }
  }
}
)");
}

}  // namespace
}  // namespace parapet::solver
