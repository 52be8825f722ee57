#include "parapet/validation/suite.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "case.hpp"
#include "parapet/records/atomic_file.hpp"
#include "slots.hpp"

namespace parapet::validation {
namespace {

std::vector<const Case*> chosen_cases(const std::vector<std::string>& only) {
  std::vector<const Case*> cases;
  for (const Case& c : all_cases()) {
    if (only.empty() || std::ranges::count(only, c.name) > 0) cases.push_back(&c);
  }
  for (const std::string& name : only) {
    if (std::ranges::any_of(all_cases(), [&](const Case& c) { return c.name == name; })) continue;
    std::string names;
    for (const Case& c : all_cases()) {
      if (!names.empty()) names += ", ";
      names += c.name;
    }
    std::string problem = "there is no case \"";
    problem.append(name).append("\"; allowed: ").append(names);
    throw std::invalid_argument(problem);
  }
  return cases;
}

// Nothing when cancelled. A case that fails is a recorded result.
std::optional<Scorecard> carry_out(const Case& c, const SuiteOptions& options, Slots& slots) {
  Scorecard card;
  card.name = c.name;
  card.title = c.title;
  card.full = options.full;
  CaseRun run(card, options.folder, slots);
  try {
    c.run(run);
    run.add_masses();
  } catch (const Cancelled&) {
    return std::nullopt;
  } catch (const records::FileError&) {
    throw;
  } catch (const std::exception& error) {
    card.failure = error.what();
  }
  records::write_file_atomically(options.folder / (card.name + ".json"),
                                 to_json(card).dump(2) + "\n");
  return card;
}

}  // namespace

std::vector<CaseInfo> list_cases() {
  std::vector<CaseInfo> list;
  for (const Case& c : all_cases()) list.push_back({std::string(c.name), std::string(c.title)});
  return list;
}

SuiteOutcome run_suite(const SuiteOptions& options) {
  const std::vector<const Case*> cases = chosen_cases(options.only);
  records::make_folder(options.folder);
  Slots slots(std::max(1, options.jobs), options.cancelled, options.on_progress);
  std::vector<std::optional<Scorecard>> cards(cases.size());
  std::mutex mutex;
  std::exception_ptr failure;
  {
    std::vector<std::jthread> threads;
    for (std::size_t k = 0; k < cases.size(); ++k) {
      threads.emplace_back([&, k] {
        const auto start = std::chrono::steady_clock::now();
        try {
          {
            const std::scoped_lock lock(mutex);
            if (options.on_start) options.on_start(std::string(cases[k]->name));
          }
          cards[k] = carry_out(*cases[k], options, slots);
          const std::scoped_lock lock(mutex);
          if (cards[k] && options.on_case) {
            options.on_case(
                *cards[k],
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
          }
        } catch (...) {
          const std::scoped_lock lock(mutex);
          if (!failure) failure = std::current_exception();
        }
      });
    }
  }
  if (failure) std::rethrow_exception(failure);
  SuiteOutcome outcome;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (cards[k]) {
      outcome.cards.push_back(std::move(*cards[k]));
    } else {
      outcome.unfinished.emplace_back(cases[k]->name);
    }
  }
  return outcome;
}

}  // namespace parapet::validation
