// Offers are played on the programs with the faults that are open; the first that notices one is taken.
#include "analysis/testing/fault_tests.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace rungproof {

namespace {

constexpr std::size_t mostTimedOffers = 300;
constexpr std::size_t timedOffersOfOne = 4;  ///< of one fault

/// Gives up what does not come everywhere.
void dropCells(TestCase& test, const std::vector<std::set<std::size_t>>& failing) {
  for (std::size_t row = 0; row < test.rows.size(); ++row) {
    for (const std::size_t output : failing[row]) test.rows[row].expects[output].reset();
  }
}

}  // namespace

FaultTests::FaultTests(const Program& program, const BenchRows& rows, RobustCheck& check,
                       const SimulatorOptions& engine)
    : rows_(rows), check_(check), engine_(engine) {
  for (Mutant& mutant : mutantsOf(program)) {
    auto fault = std::make_unique<OpenFault>();
    fault->program = planted(program, mutant.fault);
    fault->program.number();
    fault->mutant = std::move(mutant);
    open_.push_back(std::move(fault));
  }
}

/// Where the program with the fault shows something else than is expected.
std::vector<FaultTests::Notice> FaultTests::noticesOf(const OpenFault& fault, const TestCase& test) const {
  Simulator simulator(fault.program, engine_);
  std::vector<Notice> notices;
  for (const TestFailure& failure : playTest(simulator, rows_.columns(), test, rows_.atShown()).failures) {
    if (failure.signal) notices.push_back({&fault, failure.step, *failure.signal});
  }
  return notices;
}

void FaultTests::forget(const std::vector<TestCase>& tests) {
  std::erase_if(open_, [&](const std::unique_ptr<OpenFault>& fault) {
    return std::ranges::any_of(tests, [&](const TestCase& test) { return !noticesOf(*fault, test).empty(); });
  });
}

void FaultTests::remove(std::size_t index) { open_.erase(open_.begin() + static_cast<std::ptrdiff_t>(index)); }

void FaultTests::offer(TestCase test) {
  std::vector<Notice> notices;
  for (const std::unique_ptr<OpenFault>& fault : open_) {
    const std::vector<Notice> more = noticesOf(*fault, test);
    notices.insert(notices.end(), more.begin(), more.end());
  }
  if (notices.empty()) return;
  RobustCells cells = check_.quick(test);
  std::map<const OpenFault*, std::size_t> noticedAt;  // row
  for (const Notice& notice : notices) {
    if (!cells.failing[notice.row].contains(notice.output)) noticedAt.try_emplace(notice.fault, notice.row);
  }
  if (noticedAt.empty()) {
    std::map<const OpenFault*, std::size_t> known;
    for (const Offer& offer : timed_) {
      std::set<const OpenFault*> ofOffer;
      for (const Notice& notice : offer.notices) ofOffer.insert(notice.fault);
      for (const OpenFault* fault : ofOffer) ++known[fault];
    }
    const bool isWanted =
        std::ranges::any_of(notices, [&](const Notice& notice) { return known[notice.fault] < timedOffersOfOne; });
    if (isWanted && timed_.size() < mostTimedOffers)
      timed_.push_back({std::move(test), std::move(cells.failing), std::move(notices)});
    return;
  }
  std::size_t last = 0;
  for (const auto& [fault, row] : noticedAt) last = std::max(last, row);
  dropCells(test, cells.failing);
  test.rows.resize(last + 1);
  robust_.push_back(std::move(test));
  std::erase_if(open_, [&](const std::unique_ptr<OpenFault>& fault) { return noticedAt.contains(fault.get()); });
}

std::vector<TestCase> FaultTests::takeTimed(std::size_t others, double share, const std::string& scanText) {
  std::vector<TestCase> tests;
  std::size_t rows = others;
  std::set<const OpenFault*> open;
  for (const std::unique_ptr<OpenFault>& fault : open_) open.insert(fault.get());
  for (std::size_t timing = 1; !open.empty(); ++timing) {
    // The row of an offer that notices the most; of equal ones the first that is reached.
    const Offer* best = nullptr;
    std::size_t bestRow = 0, most = 0;
    for (const Offer& offer : timed_) {
      std::map<std::size_t, std::set<const OpenFault*>> byRow;
      for (const Notice& notice : offer.notices) {
        if (open.contains(notice.fault)) byRow[notice.row].insert(notice.fault);
      }
      for (const auto& [row, faults] : byRow) {
        if (faults.size() < most || (faults.size() == most && (best == nullptr || row >= bestRow))) continue;
        best = &offer;
        bestRow = row;
        most = faults.size();
      }
    }
    if (best == nullptr) break;
    rows += bestRow + 1;
    if (static_cast<double>(timing) > std::max(1.0, share * static_cast<double>(rows))) break;
    TestCase test = best->test;
    std::vector<std::set<std::size_t>> failing = best->failing;
    std::set<std::string> names;
    for (const Notice& notice : best->notices) {
      if (notice.row != bestRow) continue;
      open.erase(notice.fault);
      if (failing[bestRow].erase(notice.output) > 0) names.insert(signalText(rows_.columns().expects[notice.output]));
    }
    dropCells(test, failing);
    test.rows.resize(bestRow + 1);
    test.rows[bestRow].note =
        fmt::format("timing: {} with scans of {} and inputs in their scan", fmt::join(names, ", "), scanText);
    tests.push_back(std::move(test));
  }
  std::erase_if(open_, [&](const std::unique_ptr<OpenFault>& fault) { return !open.contains(fault.get()); });
  return tests;
}

}  // namespace rungproof
