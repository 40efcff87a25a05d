#include "tests/timing/measured_proof.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "frontend/cli.hpp"

namespace rungproof {

MeasuredProof measureProof(const std::string& program, const std::vector<std::string>& options, int runs) {
  MeasuredProof result;
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "measured_proof.awl";
  std::ofstream(file) << program;
  for (int run = 0; run < runs; ++run) {
    std::vector<std::string> arguments{"prove", file.string(), "--isolated", "--format", "json", "--timeout", "30s"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    std::istringstream in;
    std::ostringstream out, err;
    const std::clock_t begin = std::clock();
    runProgram(arguments, {in, out, err});
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    result.cpuSeconds = run == 0 ? seconds : std::min(result.cpuSeconds, seconds);
    EXPECT_EQ(err.str(), "");
    const nlohmann::json report = nlohmann::json::parse(out.str(), nullptr, false);
    if (!report.is_object()) {
      ADD_FAILURE() << out.str();
      return result;
    }
    for (const auto& property : report["properties"]) result.verdicts[property["name"]] = property["verdict"];
  }
  return result;
}

}  // namespace rungproof
