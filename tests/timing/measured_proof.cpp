#include "tests/timing/measured_proof.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "frontend/cli/cli.hpp"
#include "tests/machine_pace.hpp"

namespace rungproof {

double cpuSeconds() {
  double sum = 0;
  for (const int whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(whose, &usage);
    for (const timeval& t : {usage.ru_utime, usage.ru_stime})
      sum += static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  }
  return sum;
}

MeasuredProof measureProof(const std::string& program, const std::vector<std::string>& options, int runs,
                           double enough) {
  MeasuredProof result;
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "measured_proof.awl";
  std::ofstream(file) << program;
  for (int run = 0; run < runs && (run == 0 || result.cpuSeconds > enough); ++run) {
    std::vector<std::string> arguments{"prove", file.string(), "--isolated", "--format", "json", "--timeout", "30s"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    std::istringstream in;
    std::ostringstream out, err;
    const double seconds = test::quietSeconds([&] { runProgram(arguments, {in, out, err}); }, 0, 1, cpuSeconds);
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
