// Calls into every installed library, so that whatever they link inside must be found too.
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "parapet/acquisition/improvement.hpp"
#include "parapet/designs/study_spec.hpp"
#include "parapet/optimizer/optimize.hpp"
#include "parapet/records/hashes.hpp"
#include "parapet/reports/line_plot.hpp"
#include "parapet/surrogate/gaussian_process.hpp"

int main() {
  using namespace parapet;

  // A shipped study is sound, and its expressions can be evaluated.
  const char* text = designs::embedded_spec("quickstart");
  if (text == nullptr) return 1;
  const auto spec = designs::parse_study(designs::Json::parse(text), "quickstart");
  if (spec.variables.empty() || designs::evaluate_expression("2 * a", {{"a", 21.0}}) != 42.0) {
    return 1;
  }
  if (records::study_hash(spec).empty()) return 1;

  // (x - 0.3)^2 by COBYLA: the optimum to a hundredth of the range.
  optimizer::Problem problem;
  problem.names = {"x"};
  problem.lower = {0.0};
  problem.upper = {1.0};
  problem.evaluate = [](const std::vector<double>& x) {
    optimizer::Evaluation evaluation;
    evaluation.ok = true;
    evaluation.objective = (x[0] - 0.3) * (x[0] - 0.3);
    return evaluation;
  };
  optimizer::Options options;
  options.starts = {{0.9}};
  const auto result = optimizer::optimize(problem, options);
  if (!result.best || std::abs(result.best->x[0] - 0.3) > 0.01) return 1;

  // One point in the unit square and one that is known to halve what is left.
  const auto point = [](double a, double b) { return math::Objectives{{a, b}}; };
  const auto boxes =
      acquisition::undominated_boxes({point(0.5, 0.0)}, point(1.0, 1.0), point(0.0, 0.0));
  const double gain = acquisition::log_ehvi(boxes, point(0.25, 0.0), point(0.0, 0.0));
  if (std::abs(std::exp(gain) - 0.25) > 1e-15) return 1;
  // A process through two observations returns to the first within the data's spread.
  const surrogate::Data data{Eigen::Vector2d(0.2, 0.8), Eigen::Vector2d(1.0, 2.0), {}};
  const auto process = surrogate::GaussianProcess::fit({{0}, 1}, data, {});
  const double at_first =
      process.from_model(process.predict(Eigen::MatrixXd::Constant(1, 1, 0.2)).mean(0));
  if (std::abs(at_first - 1.0) > 0.5) return 1;

  reports::LinePlot plot;
  plot.x_label = "time [s]";
  plot.y_label = "depth [m]";
  plot.series.push_back({.label = "depth", .x = {0.0, 1.0}, .y = {0.2, 0.1}, .color = {}});
  const auto file = std::filesystem::temp_directory_path() / "parapet-consumer.svg";
  reports::draw_line_plot(file, plot);
  const bool drawn = std::filesystem::file_size(file) > 0;
  std::filesystem::remove(file);

  std::printf("study %s, optimum %.4f, plot %s\n", spec.name.c_str(), result.best->x[0],
              drawn ? "drawn" : "missing");
  return drawn ? 0 : 1;
}
