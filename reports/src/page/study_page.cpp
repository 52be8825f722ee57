#include <algorithm>

#include "page_html.hpp"
#include "parapet/reports/recommendation_json.hpp"
#include "parapet/study/sensitivity.hpp"
#include "parapet/study/slices.hpp"
#include "study_columns.hpp"

namespace parapet::reports {
namespace {

using designs::Json;
using records::EvaluationRecord;

Json slices_json(const study::LoadedStudy& study, const DesignReport& shown) {
  std::string source;
  const auto record = std::ranges::find(study.designs, shown.id, &EvaluationRecord::id);
  if (record == study.designs.end()) return nullptr;
  try {
    const Json surrogates = study::study_surrogates(study.spec, study.folder, source);
    if (surrogates.is_null()) return nullptr;
    Json metrics = Json::array();
    for (const study::MetricSlices& one :
         study::surrogate_slices(study.spec, surrogates, record->design)) {
      Json slices = Json::array();
      for (const study::Slice& slice : one.slices) {
        Json at = Json::array();
        for (const study::VariablePlace& place : slice.at) {
          std::visit([&](const auto& value) { at.push_back(value); }, place);
        }
        slices.push_back({{"variable", slice.variable},
                          {"at", std::move(at)},
                          {"median", slice.median},
                          {"lower_95", slice.lower_95},
                          {"upper_95", slice.upper_95}});
      }
      metrics.push_back(
          {{"name", one.name}, {"metric", one.metric}, {"slices", std::move(slices)}});
    }
    return {{"design", shown.id}, {"metrics", std::move(metrics)}};
  } catch (const Json::exception&) {
    return nullptr;  // damaged surrogates: `parapet recommend` says so
  } catch (const std::invalid_argument&) {
    return nullptr;
  }
}

}  // namespace

FolderReport study_report(const study::LoadedStudy& study, const Recommendation& advice,
                          const PageOptions& options) {
  Json page = common_json("study", study.spec.name, study.spec_hash, options);
  page["description"] = study.spec.description;
  page["state"] = study.state;
  page["simulated_by"] = simulated_by(study.provenance);
  page["recommendation"] = recommendation_json(advice);
  page["variables"] = page["recommendation"]["study"]["variables"];
  page["objectives"] = page["recommendation"]["study"]["objectives"];
  page["finest_spacing_m"] = advice.study.counted_spacing;
  page["designs"] = designs_json(study, advice);
  add_study_keys(page, study);
  const DesignReport* shown = advice.shown();
  page["slices"] = shown != nullptr ? slices_json(study, *shown) : Json(nullptr);
  const std::string folder = shell_word(study.folder.string());
  add_command(page, "recommend a design and simulate it again", "parapet recommend " + folder);
  if (advice.reproduce) {
    add_command(page, "repeat the study", advice.reproduce->optimize);
    add_command(page, "simulate the design shown", advice.reproduce->evaluate);
  }
  add_command(page, "simulate stored designs again and compare bit by bit",
              "parapet verify " + folder);
  add_command(page, "check the files", "cd " + folder + " && sha256sum -c checksums.sha256");
  RunBlocks runs(page);
  add_study_runs(runs, study, advice, options);
  std::string table = designs_csv(page["designs"]);
  return {.page = page_html(page, runs.blocks()), .designs_csv = std::move(table)};
}

}  // namespace parapet::reports
