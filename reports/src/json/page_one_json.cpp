#include "page_one_json.hpp"

#include "design_json.hpp"

namespace parapet::reports {
namespace {

using designs::Json;

Json lines_json(const std::vector<PageOneLine>& lines) {
  Json list = Json::array();
  for (const PageOneLine& one : lines) {
    list.push_back({{"label", one.label},
                    {"text", one.text},
                    {"asked", one.asked},
                    {"mean", optional_json(one.mean)},
                    {"lower_95", optional_json(one.lower_95)},
                    {"upper_95", optional_json(one.upper_95)},
                    {"probability", optional_json(one.probability)}});
  }
  return list;
}

const char* role_word(study::Role role) {
  if (role == study::Role::objective) return "objective";
  return role == study::Role::constraint ? "constraint" : "load";
}

const char* source_word(study::GridSource source) {
  if (source == study::GridSource::none) return "none";
  return source == study::GridSource::levels ? "levels" : "other_run";
}

}  // namespace

Json to_json(const PageOne& page) {
  return {{"title", page.title},
          {"design", page.design},
          {"arrangement", page.arrangement},
          {"sketch", page.sketch},
          {"instead", page.instead},
          {"performance", lines_json(page.performance)},
          {"limits", lines_json(page.limits)},
          {"loads", lines_json(page.loads)},
          {"probability", optional_json(page.probability)},
          {"probability_words", page.probability_words},
          {"chosen", page.chosen},
          {"ties", page.ties},
          {"bounds", page.bounds},
          {"grid", page.grid},
          {"verdict", page.verdict},
          {"verdict_words", page.verdict_words}};
}

Json repeat_json(const std::vector<study::Expectation>& repeat) {
  Json list = Json::array();
  for (const study::Expectation& one : repeat) {
    const auto& estimate = one.estimate;
    const bool known = estimate && estimate->scatter;
    const auto number = [&](bool there, double value) {
      return there ? optional_json(value) : Json(nullptr);
    };
    list.push_back(
        {{"role", role_word(one.role)},
         {"name", one.name},
         {"metric", one.metric},
         {"exact", one.exact},
         {"lower", optional_json(one.lower)},
         {"upper", optional_json(one.upper)},
         {"mean", number(estimate.has_value(), estimate ? estimate->mean : 0.0)},
         {"lower_95", optional_json(estimate ? estimate->lower_95() : std::nullopt)},
         {"upper_95", optional_json(estimate ? estimate->upper_95() : std::nullopt)},
         {"scatter", optional_json(estimate ? estimate->scatter : std::nullopt)},
         {"mean_uncertainty", number(known, estimate ? estimate->mean_uncertainty : 0.0)},
         {"grid_uncertainty", optional_json(estimate ? estimate->grid : std::nullopt)},
         {"grid_source", source_word(estimate ? estimate->grid_source : study::GridSource::none)},
         {"degrees_of_freedom", number(known, estimate ? estimate->freedom : 0.0)},
         {"runs", estimate ? estimate->runs : 0},
         {"runs_absent", one.absent},
         {"probability", optional_json(one.probability)}});
  }
  return list;
}

}  // namespace parapet::reports
