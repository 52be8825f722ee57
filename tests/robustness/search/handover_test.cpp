// A thread that waits for answers, and a loop that may stop at any moment.
#include "handover.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace parapet::test {
namespace {

using study::Handover;
using study::Proposal;

std::vector<Proposal> batch(std::initializer_list<double> values) {
  std::vector<Proposal> result;
  for (const double value : values) {
    result.push_back({.stage = "search", .design = {{"x", value}}, .spacing = 0.01});
  }
  return result;
}

records::EvaluationRecord record(const std::string& id) {
  records::EvaluationRecord result;
  result.id = id;
  return result;
}

TEST(HandoverOfQuestions, EachBatchIsAnsweredInItsOrder) {
  Handover handover;
  std::vector<std::string> got;
  std::jthread asker([&] {
    for (int round = 0; round < 3; ++round) {
      for (const auto& answer : handover.ask(batch({1.0, 2.0}))) {
        got.push_back(answer ? answer->id : "none");
      }
    }
    handover.end();
  });
  for (int round = 0; round < 3; ++round) {
    const auto questions = handover.take();
    ASSERT_EQ(questions.size(), 2U);
    EXPECT_EQ(questions[1].design.at("x"), 2.0);
    EXPECT_TRUE(handover.take().empty()) << "answers are due";
    handover.answer(1, record(std::string("b").append(std::to_string(round))));
    EXPECT_TRUE(handover.take().empty()) << "one still is";
    handover.answer(0, record(std::string("a").append(std::to_string(round))));
  }
  EXPECT_TRUE(handover.take().empty()) << "the asker has ended";
  asker.join();
  EXPECT_EQ(got, (std::vector<std::string>{"a0", "b0", "a1", "b1", "a2", "b2"}));
}

TEST(HandoverOfQuestions, StoppedInABatchGivesTheAnswersThatThereAre) {
  Handover handover;
  Handover::Answers first, second;
  std::jthread asker([&] {
    first = handover.ask(batch({1.0, 2.0, 3.0}));
    second = handover.ask(batch({4.0}));
    handover.end();
  });
  ASSERT_EQ(handover.take().size(), 3U);
  handover.answer(1, record("b"));
  handover.stop();
  handover.answer(2, record("late"));
  asker.join();
  ASSERT_EQ(first.size(), 3U);
  EXPECT_FALSE(first[0].has_value());
  EXPECT_EQ(first[1].value().id, "b");
  EXPECT_FALSE(first[2].has_value()) << "too late";
  ASSERT_EQ(second.size(), 1U);
  EXPECT_FALSE(second[0].has_value());
  EXPECT_TRUE(handover.stopped());
}

TEST(HandoverOfQuestions, StoppedBeforeAnybodyTakesItLetsTheAskerGo) {
  for (int k = 0; k < 200; ++k) {  // before and after the asker waits
    Handover handover;
    std::jthread asker([&] {
      while (!handover.stopped()) handover.ask(batch({1.0}));
      handover.end();
    });
    if (k % 2 == 1) std::this_thread::yield();
    handover.stop();
  }
}

TEST(HandoverOfQuestions, TheAskersExceptionReachesTheLoop) {
  Handover handover;
  std::jthread asker([&] {
    try {
      handover.ask(batch({1.0}));
      throw std::logic_error("no gradient");
    } catch (...) {
      handover.end(std::current_exception());
    }
  });
  ASSERT_EQ(handover.take().size(), 1U);
  handover.answer(0, record("a"));
  EXPECT_THROW(handover.take(), std::logic_error);
}

TEST(HandoverOfQuestions, NothingAskedIsNothingAnswered) {
  Handover handover;
  EXPECT_TRUE(handover.ask({}).empty());
  handover.end();
  EXPECT_TRUE(handover.take().empty());
}

}  // namespace
}  // namespace parapet::test
