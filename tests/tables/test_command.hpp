// `rungproof test` as a user runs it: files in a folder of its own, exit code, both outputs.
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/program_run.hpp"

namespace rungproof::test {

class TestCommand : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_.path(name); }
  std::string write(const std::string& name, const std::string& text) const { return folder_.file(name, text); }
  std::string content(const std::string& name) const { return contentOf(path(name)); }
  int run(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "test");
    arguments.push_back("--isolated");
    ProgramRun run = test::run(arguments);
    out_ = std::move(run.out);
    err_ = std::move(run.err);
    return run.exit;
  }
  /// The JSON report of the same.
  nlohmann::json json(std::vector<std::string> arguments, int exit) {
    arguments.insert(arguments.end(), {"--format", "json"});
    EXPECT_EQ(run(arguments), exit) << err_ << out_;
    return nlohmann::json::parse(out_);
  }

  TemporaryFolder folder_;
  std::string out_, err_;
};

/// A motor with its stop, and a lamp 300 ms after it.
inline constexpr const char* motorProgram =
    "Network 1\nLD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\nNetwork 2\nLD Q0.0\nTON T37, +3\nNetwork 3\nLD T37\n= Q0.1\n";

}  // namespace rungproof::test
