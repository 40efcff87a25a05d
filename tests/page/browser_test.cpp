// Pages opened in a headless Chromium, which must not complain in its console; the buttons of a run must have been set
// up. Without a Chromium on the machine this says so, and the pages are held to be well-formed by acceptance_test.cpp
// alone.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>

#include "page_run.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> browser() {
  std::istringstream path(std::getenv("PATH") == nullptr ? "" : std::getenv("PATH"));
  for (std::string folder; std::getline(path, folder, ':');) {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
      const fs::path file = fs::path(folder) / name;
      if (::access(file.c_str(), X_OK) == 0) return file.string();
    }
  }
  return std::nullopt;
}

struct Opened {
  std::string document;  ///< after its scripts have run
  std::string console;   ///< lines that the page wrote, errors included
};

Opened open(const std::string& program, const TemporaryFolder& folder, const std::string& page) {
  const std::string file = folder.file("page.html", page);
  const std::string log = folder.path("log");
  const std::string command = program +
                              " --headless --no-sandbox --disable-gpu --enable-logging=stderr --user-data-dir='" +
                              folder.path("profile") + "' --dump-dom 'file://" + file + "' 2>'" + log + "'";
  Opened opened;
  FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 65536> part{};
  for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;)
    opened.document.append(part.data(), n);
  ::pclose(pipe);
  std::istringstream lines(contentOf(log));
  for (std::string line; std::getline(lines, line);) {
    if (line.find("CONSOLE") != std::string::npos) opened.console += line + "\n";
  }
  return opened;
}

TEST(Browser, OpensThePagesWithoutAComplaint) {
  const std::vector<std::vector<std::string>> pages = {{"prove", corpusFile("interlocks/reversing_faulty.awl")},
                                                       {"prove", corpusFile("simaticml/tank_pump.xml"), "--self-check"},
                                                       {"lint", corpusFile("faulty/ranges.awl")}};
  const std::optional<std::string> program = browser();
  if (!program) {
    std::puts("no Chromium on this machine: pages are not opened here, only held to be well-formed");
    for (const auto& arguments : pages) EXPECT_TRUE(pageOf(arguments).ends_with("</html>\n"));
    return;
  }
  const TemporaryFolder folder;
  for (const auto& arguments : pages) {
    const std::string page = pageOf(arguments);
    const Opened opened = open(*program, folder, page);
    EXPECT_EQ(opened.console, "") << arguments[1];
    EXPECT_NE(opened.document.find("</html>"), std::string::npos) << arguments[1];
    const std::size_t runs = countIn(page, "class=\"steps\"");
    EXPECT_EQ(countIn(opened.document, "<span class=\"where\"></span>"), 0u) << "the script has not reached a run";
    EXPECT_EQ(countIn(opened.document, "class=\"steps\" hidden"), 0u) << runs;
  }
}

TEST(Browser, WouldShowAnError) {
  const std::optional<std::string> program = browser();
  if (!program) {
    std::puts("no Chromium on this machine");
    EXPECT_TRUE(pageOf({"lint", corpusFile("faulty/ranges.awl")}).starts_with("<!DOCTYPE html>"));
    return;
  }
  const TemporaryFolder folder;
  const Opened opened =
      open(*program, folder, "<!DOCTYPE html><html><body><script>nothing.there();</script></body></html>");
  EXPECT_NE(opened.console.find("nothing is not defined"), std::string::npos) << opened.console;
}

}  // namespace
}  // namespace rungproof::test
