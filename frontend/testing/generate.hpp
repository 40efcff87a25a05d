// `rungproof test --generate DIR`: tables, sheets and coverage of a program, written all or not at all. Tested by
// tests/tables/generate_command_test.cpp.
#pragma once

#include <string>

#include "analysis/testing/test_generator.hpp"
#include "frontend/command.hpp"
#include "frontend/testing/test_sheet.hpp"

namespace rungproof {

struct GenerateRequest {
  std::string directory;
  std::set<Measure> measures{allMeasures.begin(), allMeasures.end()};
  bool changesTogether = false;
  SimulatorOptions engine;
  ScanTime scanTime{};   ///< for which every expected value must hold
  ScanTime shownTime{};  ///< at which coverage is measured
  std::string title, hash;
  const UnreadCode* unread = nullptr;
  Coverage read{};  ///< how much of the program was understood
};

/// Writes the files and puts coverage and their names into `report`; gives the table. False: a file could not be
/// written.
bool generateInto(TestReport& report, TestTable& table, const Context& context, const CoverageMap& map,
                  const PropertySet& set, const GenerateRequest& request, const ProverOptions& prover);

}  // namespace rungproof
