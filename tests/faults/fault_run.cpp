// The environment carries the plan to the library.
#include "tests/faults/fault_run.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "tests/measured_process.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {

namespace {

namespace fs = std::filesystem;

constexpr double mostSeconds = 60;

std::string contentsOf(const fs::path& name) {
  std::ifstream stream(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

FaultRun runIn(const TemporaryFolder& folder, const std::vector<std::string>& arguments, const Contents& files,
               const std::string& setting) {
  for (const auto& [name, text] : files) folder.file(name, text);
  std::vector<std::string> command = {"env", "-C", folder.folder().string(),
                                      std::string("LD_PRELOAD=") + RUNGPROOF_FAULTS};
  if (!setting.empty()) command.push_back(setting);
  command.push_back(std::string(RUNGPROOF_BINARY_DIR) + "/rungproof");
  command.insert(command.end(), arguments.begin(), arguments.end());
  const ProcessRun run = runProcess(command, mostSeconds);
  FaultRun result{run.isCut ? -1 : run.exit, run.output, {}};
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder.folder())) {
    if (entry.is_regular_file())
      result.files[entry.path().lexically_relative(folder.folder()).string()] = contentsOf(entry.path());
  }
  return result;
}

}  // namespace

FaultRun runWithFault(const std::vector<std::string>& arguments, const Contents& files, const std::string& fault) {
  const TemporaryFolder folder;
  return runIn(folder, arguments, files, fault.empty() ? "" : "RUNGPROOF_FAULT=" + fault);
}

std::map<std::string, std::uint64_t> countCalls(const std::vector<std::string>& arguments, const Contents& files) {
  const TemporaryFolder folder, other;
  runIn(folder, arguments, files, "RUNGPROOF_FAULT_COUNT=" + other.path("calls"));
  std::map<std::string, std::uint64_t> calls;
  std::istringstream lines(contentsOf(other.path("calls")));
  std::string kind;
  for (std::uint64_t count = 0; lines >> kind >> count;) calls[kind] = count;
  return calls;
}

}  // namespace rungproof::test
