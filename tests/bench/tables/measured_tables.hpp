// What `rungproof test --generate` makes of one program, in figures: coverage, processor time, whether its tests hold
// at any scan time and skew, which faults they notice, and how many steps random testing needs for the same.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rungproof::tables {

struct Faults {
  std::size_t noticed = 0, unnoticed = 0, withoutEffect = 0, undecided = 0;
  std::vector<std::string> missed{};  ///< what was planted, of those unnoticed
  double share() const {
    const std::size_t matter = noticed + unnoticed;
    return matter == 0 ? 1 : static_cast<double>(noticed) / static_cast<double>(matter);
  }
};

struct Figures {
  std::string program;
  std::size_t instructions = 0;
  std::size_t goals = 0, open = 0;
  std::vector<std::string> openGoals{};
  double seconds = 0;  ///< of processor time, generation alone
  std::size_t tests = 0, rows = 0, timingRows = 0, cells = 0;
  std::size_t failures = 0;       ///< in rows without mark, of all replays
  Faults planted{};               ///< those of --kill
  Faults ofText{};                ///< of text_mutant.hpp, which the generator does not know
  std::size_t coverageSteps = 0;  ///< of the tests in their order, until all is covered
  std::size_t randomSteps = 0;
  bool isRandomCut = false;  ///< random testing had not covered the same by then
};

struct Questions {
  std::size_t replays = 200;
  std::size_t textMutants = 40;
  bool kills = true;
  bool random = false;
};

/// Nothing: the program cannot be tested (refused, no main program) or is longer than `most` instructions.
std::optional<Figures> measure(const std::filesystem::path& program, const Questions& questions, std::size_t most);

}  // namespace rungproof::tables
