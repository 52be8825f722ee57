// bench_search_asker OUT.json [DESIGNS]
//
// What one question of the search costs when it knows many designs (500): 10 variables, two
// objectives and a limit, each a modelled metric with noise. A batch of questions is put before all
// of it is answered, as for many workers. Processor time per question, everything included:
// answers, fits, questions.
#include <fmt/format.h>

#include <cmath>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench_problem.hpp"
#include "hash_noise.hpp"
#include "parapet/bayesian/search.hpp"
#include "processor_seconds.hpp"
#include "scrambled_sobol.hpp"

namespace parapet::bench::search {
namespace {

constexpr std::size_t n_variables = 10;

bayesian::Problem problem() {
  std::vector<bayesian::Variable> variables;
  for (std::size_t j = 0; j < n_variables; ++j) {
    variables.push_back({.name = fmt::format("x{}", j + 1), .lower = 0.0, .upper = 1.0});
  }
  bayesian::Problem result;
  result.space = bayesian::Space(variables);
  result.metrics = {{.name = "f1"}, {.name = "f2"}, {.name = "g"}};
  result.objectives = {{.metric = 0, .reference = 3.0}, {.metric = 1, .reference = 3.0}};
  result.limits = {{.metric = 2, .upper = 1.0}};
  return result;
}

bayesian::Observation answer(const bayesian::Point& x) {
  double near = 0.0, far = 0.0, wave = 0.0;
  for (std::size_t j = 0; j < x.size(); ++j) {
    near += (x[j] - 0.3) * (x[j] - 0.3);
    far += (x[j] - 0.6) * (x[j] - 0.6);
    wave += std::sin(5.0 * x[j]) / static_cast<double>(x.size());
  }
  const auto noise = [&](const char* stream) { return 0.01 * hash_normal(x, stream); };
  return {.ok = true,
          .values = {near + noise("f1"), far + noise("f2"), 1.0 + wave + noise("g")},
          .seconds = 1.0};
}

nlohmann::ordered_json measure(int designs, int batch) {
  bayesian::SearchOptions options;
  options.max_evaluations = designs + 10000;
  bayesian::Search search(problem(), options);
  ScrambledSobol points(static_cast<int>(n_variables), 1);
  for (int k = 0; k < designs; ++k) {
    const Design x = points.next();
    search.tell_external(x, 0, answer(x));
  }
  double first = 0.0;
  const auto round = [&] {
    std::vector<bayesian::Suggestion> asked;
    for (int k = 0; k < batch; ++k) {
      if (const auto suggestion = search.ask()) asked.push_back(*suggestion);
    }
    for (const auto& one : asked) search.tell(one.id, answer(one.x));
    return asked.size();
  };
  double begin = processor_seconds();
  round();  // fits all surrogates for the first time
  first = processor_seconds() - begin;
  // As many questions for every size of batch, so that each pays the same share of later fits.
  std::size_t asked = 0;
  begin = processor_seconds();
  while (asked < 96) asked += round();
  const double each = (processor_seconds() - begin) / static_cast<double>(asked);
  fmt::print(
      "  {} designs, {} variables, batches of {}: {:.1f} ms a question (first batch {:.2f} s)\n",
      designs, n_variables, batch, 1e3 * each, first);
  std::fflush(stdout);
  return {{"designs", designs},
          {"variables", n_variables},
          {"batch", batch},
          {"first_batch_seconds", first},
          {"seconds_each", each}};
}

}  // namespace
}  // namespace parapet::bench::search

int main(int argc, char** argv) {
  using namespace parapet::bench::search;
  if (argc != 2 && argc != 3) {
    fmt::print(stderr, "usage: bench_search_asker OUT.json [DESIGNS]\n");
    return 2;
  }
  try {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    const int designs = argc == 3 ? std::stoi(argv[2]) : 500;
    for (const int batch : {32, 8}) rows.push_back(measure(designs, batch));
    std::ofstream file(argv[1]);
    file << rows.dump(1) << '\n';
    if (!file) throw std::runtime_error(std::string("cannot write ") + argv[1]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_search_asker: {}\n", error.what());
    return 1;
  }
}
