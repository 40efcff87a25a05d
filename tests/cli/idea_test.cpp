// Every word that a report can print behind "by", and every verdict, has a page.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "frontend/explain/idea_page.hpp"
#include "frontend/report.hpp"

namespace rungproof {
namespace {

TEST(Ideas, EveryVerdictHasAPage) {
  for (const Outcome outcome : {Outcome::Proved, Outcome::Violated, Outcome::Reachable, Outcome::Unreachable,
                                Outcome::HoldsToBound, Outcome::Vacuous, Outcome::NotCovered, Outcome::Unknown})
    EXPECT_NE(ideaNamed(verdictText(outcome, 7)), nullptr) << verdictText(outcome, 7);
}

/// The words in quotes of every statement of the prover that says how an answer was found.
std::set<std::string> methodsInSources() {
  const std::regex statement("(?:\\bmethod_? = [^;]*|\\b(?:show|shown|showRun)\\([^;]*);"), word("\"([^\"]+)\"");
  std::set<std::string> words;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(RUNGPROOF_SOURCE_DIR "/analysis")) {
    if (entry.path().extension() != ".cpp") continue;
    std::stringstream stream;
    stream << std::ifstream(entry.path()).rdbuf();
    const std::string text = stream.str();
    for (std::sregex_iterator at(text.begin(), text.end(), statement), end; at != end; ++at) {
      const std::string found = at->str();
      for (std::sregex_iterator w(found.begin(), found.end(), word); w != end; ++w) words.insert((*w)[1]);
    }
  }
  return words;
}

TEST(Ideas, EveryMethodHasAPage) {
  const std::set<std::string> methods = methodsInSources();
  for (const char* known : {"one scan", "simulation", "BMC", "k-induction", "IC3", "IC3 on words", "invariant",
                            "explicit search", "held inputs", "accelerated search", "exploration", "engine runs",
                            "runs of both programs", "both programs side by side"})
    EXPECT_TRUE(methods.contains(known)) << known << ": the search no longer finds the methods";
  for (const std::string& method : methods)
    EXPECT_NE(ideaNamed(method.starts_with("-") ? "3" + method : method), nullptr) << method;
  EXPECT_NE(ideaNamed("7-induction"), nullptr);
  EXPECT_EQ(ideaNamed("guessing"), nullptr);
}

TEST(Ideas, AreNamedOnce) {
  for (const Idea& idea : ideas()) EXPECT_EQ(ideaNamed(idea.name), &idea) << idea.name;
}

}  // namespace
}  // namespace rungproof
