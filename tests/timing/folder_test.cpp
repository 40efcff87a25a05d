// A project as it is handed over, a folder of 30 blocks in a file each with 2,000 instructions: what an editor or a
// commit hook waits for when it asks for lint or check, reading included, in processor time.
#include <gtest/gtest.h>

#include <sstream>

#include "frontend/cli/cli.hpp"
#include "tests/machine_pace.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

constexpr double mostOfFolder = 0.050;
constexpr int sections = 30;
constexpr int folderAttempts = 5;

std::string bit(char area, int number) {
  return area + std::to_string(number / 8 % 1000) + "." + std::to_string(number % 8);
}

/// Twelve networks of motors, timers, counters, scaled values and a state word, as in plants of many alike drives.
std::string blockText(int block) {
  std::ostringstream text;
  const int base = block * 40;
  text << "// Section " << block << " of the plant\n";
  for (int n = 0; n < 6; ++n) {
    const std::string run = bit('M', base % 200 + n), timer = std::to_string(37 + (block * 6 + n) % 26),
                      word = std::to_string(1000 + base + 2 * n);
    text << "Network " << 2 * n + 1 << " // Drive " << n << "\nLD I" << n << ".0\nO " << run << "\nA I" << n
         << ".1\nAN " << bit('V', 4000 + base + n) << "\nLPS\nAN T" << timer << "\n= " << run << "\nLPP\nTON T" << timer
         << ", +50\n";
    text << "Network " << 2 * n + 2 << "\nLDW>= VW" << word << ", 100\nLPS\nA " << run << "\nMOVW VW" << word << ", VW"
         << 3000 + base + 2 * n << "\nLPP\nAN " << run << "\nINCW VW" << word << '\n';
    if (n % 2 == 0)
      text << "Network " << 20 + n << "\nLDB= VB" << block << ", " << n << "\nEU\nMOVB " << n + 1 << ", VB" << block
           << '\n';
  }
  text << "Network 40\nLD SM0.0\nCALL MBUS_MSG, M30.0, 2, 0, 40001, 2, &VB" << 8000 + 4 * block << ", M31.0, MB32\n";
  return text.str();
}

/// The folder's files; the number of its instructions.
std::size_t fill(const test::TemporaryFolder& folder) {
  std::string main;
  std::size_t instructions = 0;
  for (int block = 0; block < sections; ++block) {
    main += "Network " + std::to_string(block + 1) + "\nLD SM0.0\nCALL SBR" + std::to_string(block) + "\n";
    folder.file("SBR" + std::to_string(block) + "_Section.stl", blockText(block));
  }
  folder.file("MAIN.stl", main);
  for (const auto& entry : std::filesystem::directory_iterator(folder.folder())) {
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);)
      instructions += line.starts_with("Network") || line.starts_with("//") ? 0 : 1;
  }
  return instructions;
}

double secondsOf(const std::string& command, const test::TemporaryFolder& folder) {
  return test::quietSeconds(
      [&] {
        std::istringstream in;
        std::ostringstream out, err;
        runProgram({command, "--isolated", "--cpu", "ST60", folder.folder().string()}, {in, out, err});
        EXPECT_FALSE(out.str().empty()) << err.str();
      },
      mostOfFolder, folderAttempts);
}

TEST(Folder, LintAndCheckTakeFiftyMilliseconds) {
  const test::TemporaryFolder folder;
  EXPECT_GE(fill(folder), 2000U);
  for (const char* command : {"lint", "check"}) {
    const double seconds = secondsOf(command, folder);
    std::printf("%s: %.1f ms of %.0f\n", command, seconds * 1000, mostOfFolder * 1000);
    EXPECT_LE(seconds, mostOfFolder) << command;
  }
}

}  // namespace
}  // namespace rungproof
