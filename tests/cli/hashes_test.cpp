// What makes a study another one, and what may change when it is continued.
#include "parapet/records/hashes.hpp"

#include <gtest/gtest.h>

#include "tiny_specs.hpp"

namespace parapet::test {
namespace {

using designs::Json;

std::string hash_with(const std::string& method_key, const Json& value) {
  Json json = tiny_study();
  json["method"][method_key] = value;
  return records::study_hash(designs::parse_study(json, "test"));
}

TEST(StudyHash, LeavesOutWhenTheStudyEnds) {
  const std::string plain = records::study_hash(designs::parse_study(tiny_study(), "test"));
  EXPECT_EQ(hash_with("max_evaluations", 99), plain);
  EXPECT_EQ(hash_with("max_time_s", 60), plain);
  EXPECT_EQ(hash_with("max_cpu_time_s", 60), plain);
  EXPECT_EQ(hash_with("stagnation_evaluations", 9), plain);
  EXPECT_EQ(hash_with("least_gain", 0.1), plain);
}

TEST(StudyHash, HoldsWhatTheStudySearchesFor) {
  const std::string plain = records::study_hash(designs::parse_study(tiny_study(), "test"));
  EXPECT_NE(hash_with("seed", 2), plain);
  EXPECT_NE(hash_with("algorithm", "BAYESIAN"), plain);
  Json json = tiny_study();
  json["scenarios"] = Json::parse(R"([{"set": {"slope_deg": 25}}])");
  EXPECT_NE(records::study_hash(designs::parse_study(json, "test")), plain);
  json = tiny_study();
  json["fidelity"]["spacings_m"] = {0.02, 0.025};
  EXPECT_NE(records::study_hash(designs::parse_study(json, "test")), plain);
}

}  // namespace
}  // namespace parapet::test
