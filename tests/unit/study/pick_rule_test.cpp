#include "parapet/study/pick_rule.hpp"

#include <gtest/gtest.h>

namespace parapet::study {
namespace {

std::string refusal(const std::string& rule, const std::string& weights,
                    const std::vector<std::string>& limits) {
  try {
    parse_pick_rule(rule, weights, limits);
  } catch (const designs::InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(PickRule, ReadsWeightsAndLimits) {
  const PickRule weights =
      parse_pick_rule("weights", "retention_efficiency=2,launch_length_m=0.5", {});
  EXPECT_EQ(weights.kind, RuleKind::weights);
  EXPECT_EQ(weights.weights.at("retention_efficiency"), 2.0);
  EXPECT_EQ(weights.weights.at("launch_length_m"), 0.5);
  const PickRule limits =
      parse_pick_rule("", "", {"launch_length_m<=0.1", "retention_efficiency>=1e-1"});
  EXPECT_EQ(limits.kind, RuleKind::limits) << "limits alone say which rule";
  EXPECT_EQ(limits.limits[0].objective, "launch_length_m");
  EXPECT_EQ(limits.limits[0].upper, 0.1);
  EXPECT_FALSE(limits.limits[0].lower);
  EXPECT_EQ(limits.limits[1].lower, 0.1);
  EXPECT_EQ(parse_pick_rule("", "", {}).kind, RuleKind::automatic);
}

TEST(PickRule, IsWrittenAsItIsRead) {
  EXPECT_EQ(command_line(parse_pick_rule("", "", {})), "");
  EXPECT_EQ(command_line(parse_pick_rule("knee", "", {})), " --rule knee");
  EXPECT_EQ(command_line(parse_pick_rule("", "b=1,a=0.5", {})),
            " --rule weights --weights a=0.5,b=1");
  EXPECT_EQ(command_line(parse_pick_rule("", "", {"a<=0.1", "b>=2"})),
            " --rule limits --limit 'a<=0.1' --limit 'b>=2'");
}

TEST(PickRule, NamesTheOptionThatIsWrong) {
  for (const auto& [said, wanted] : std::vector<std::pair<std::string, std::string>>{
           {refusal("nearest", "", {}), "--rule"},
           {refusal("weights", "", {}), "needs weights"},
           {refusal("knee", "a=1", {}), "takes no weights"},
           {refusal("limits", "", {}), "needs a limit"},
           {refusal("", "a", {}), "--weights"},
           {refusal("", "a=-1", {}), "negative"},
           {refusal("", "a=0", {}), "above 0"},
           {refusal("", "a=1x", {}), "not a number"},
           {refusal("", "", {"a<1"}), "--limit"},
           {refusal("", "", {"a<=much"}), "not a number"},
           {refusal("", "", {"<=1"}), "--limit"}}) {
    EXPECT_NE(said.find(wanted), std::string::npos) << said << "; wanted: " << wanted;
  }
}

}  // namespace
}  // namespace parapet::study
