// A search on one's own function: ask for a design, evaluate it, tell the answer.
//
//   own_search [MAX_EVALUATIONS]     30 unless given
//
// Link parapet::bayesian. It knows nothing of particles: `evaluate` below could be any program of
// yours. Here it is three formulas of a barrier, so that the right answer can be worked out by
// hand.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

#include "parapet/bayesian/search.hpp"

namespace bayesian = parapet::bayesian;

constexpr double degree = std::numbers::pi / 180.0;
constexpr double slope = 26.0 * degree;    // of the bed
constexpr double deposit = 18.0 * degree;  // of the deposit's surface, once it has come to rest
constexpr double density = 1135.0;         // [kg/m3]
constexpr double flow_depth = 0.03;        // of the jet that runs up the barrier [m]
constexpr double speed = 3.0;              // of that jet [m/s]
constexpr double gravity = 9.81;           // [m/s2]
constexpr double greatest_force = 440.0;   // what the plate's joint can bear [N/m]
constexpr double least_storage = 0.05;     // debris that must find room behind the stem [m2]

// Where a jet lands that leaves the crest, `height` above the bed, upwards at `angle`: a parabola
// meets a bed that falls away. Distance along the bed from the foot [m].
static double launch_length(double height, double angle) {
  const double tangents = std::tan(angle) + std::tan(slope);
  const double reach = std::pow(speed * std::cos(angle), 2) / gravity;
  const double x = reach * (tangents + std::sqrt(tangents * tangents + 2.0 * height / reach));
  return x / std::cos(slope);
}

// The plate turns the jet by slope + angle; its force is the change of momentum [N/m].
static double plate_force(double angle) {
  return density * flow_depth * speed * speed * 2.0 * std::sin((slope + angle) / 2.0);
}

// The triangle between stem, bed and the surface of the deposit [m2].
static double storage(double height) {
  return height * height / (2.0 * (std::tan(slope) - std::tan(deposit)));
}

// The answer of the expensive program: one number per metric, in the order of the problem below.
static bayesian::Observation evaluate(const bayesian::Point& x) {
  const double height = x[0];
  const double angle = x[1] * degree;
  return {.ok = true,
          .values = {launch_length(height, angle), plate_force(angle), storage(height)},
          .seconds = 1.0};
}

// Launch the overflow as short as possible, within what the joint bears, with room for the debris.
static bayesian::Problem short_launch() {
  bayesian::Problem problem;
  problem.space = bayesian::Space({{.name = "height_m", .lower = 0.05, .upper = 0.25},
                                   {.name = "deflector_angle_deg", .lower = 0.0, .upper = 75.0}});
  problem.metrics = {{.name = "launch_length_m"}, {.name = "force_n_m"}, {.name = "storage_m2"}};
  problem.objectives = {{.metric = 0, .maximize = false}};
  problem.limits = {{.metric = 1, .upper = greatest_force}, {.metric = 2, .lower = least_storage}};
  return problem;
}

static void print_design(const char* name, double height, double angle_deg, double length) {
  std::printf("%-8s height_m %.4f  deflector_angle_deg %6.2f  launch_length_m %.4f\n", name, height,
              angle_deg, length);
}

int main(int argc, char** argv) try {
  bayesian::SearchOptions options;
  options.max_evaluations = argc > 1 ? std::atoi(argv[1]) : 30;
  bayesian::Search search(short_launch(), options);

  // The whole search. Each question takes all answers so far into account.
  while (const auto suggestion = search.ask()) {
    search.tell(suggestion->id, evaluate(suggestion->x));
  }

  // Everything that was told, and which of it no other design betters within the limits. With one
  // objective that is the best design; with several it would be the Pareto set.
  const auto designs = search.assessed();
  std::printf("%d evaluations, %d of them within the limits\n", search.evaluations(),
              int(std::count_if(designs.begin(), designs.end(),
                                [](const auto& design) { return design.feasible; })));
  const auto best = search.pareto();
  if (best.empty()) {
    std::printf("no design within the limits was found\n");
    return 1;
  }
  const bayesian::Assessed& found = designs[best.front()];
  print_design("found", found.x[0], found.x[1], *found.values[0]);

  // By hand: a lower stem launches shorter, and so does a steeper plate (beyond 32 degrees), so
  // both limits bind. Both formulas can be turned round.
  const double height = std::sqrt(2.0 * least_storage * (std::tan(slope) - std::tan(deposit)));
  const double angle =
      2.0 * std::asin(greatest_force / (2.0 * density * flow_depth * speed * speed)) - slope;
  print_design("by_hand", height, angle / degree, launch_length(height, angle));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
