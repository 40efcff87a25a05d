// A run shared by several machines: the joined report says what one run says.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "frontend/report.hpp"
#include "schema_check.hpp"
#include "tests/program_run.hpp"

namespace rungproof::test {
namespace {

class Merge : public testing::Test {
 protected:
  Merge() {
    program_ = folder_.file("p.awl",
                            "//@ prove a: never Q0.0 and I0.1\n//@ prove b: Q0.0 implies I0.0\n"
                            "//@ prove c: Q0.1 implies I0.2\n//@ reach d: Q0.0 and Q0.1\n//@ prove e: never Q0.1\n" +
                                mainBlock("Network 1\nLD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\nNetwork 2\nLD I0.2\n= Q0.1\n"));
  }
  /// Reports of all parts in one form, and the worst of their exit codes.
  std::vector<std::string> parts(int count, const std::string& form) {
    std::vector<std::string> files;
    for (int i = 1; i <= count; ++i) {
      files.push_back(folder_.path("part" + std::to_string(i) + "." + form));
      const ProgramRun part =
          run({"prove", program_, "--builtin", "--shard", std::to_string(i) + "/" + std::to_string(count), "--format",
               form + "=" + files.back()});
      worst_ = std::max(worst_, part.exit);
    }
    return files;
  }
  static ProgramRun merge(std::vector<std::string> files) {
    files.insert(files.begin(), "merge");
    return run(files);
  }
  static std::map<std::string, std::string> verdicts(const nlohmann::json& report) {
    std::map<std::string, std::string> rows;
    for (const nlohmann::json& property : report["properties"]) rows[property["name"]] = property["verdict"];
    return rows;
  }
  TemporaryFolder folder_;
  std::string program_;
  int worst_ = 0;
  int count_ = 0;  ///< of reports that are kept
};

TEST_F(Merge, JsonOfThreePartsSaysWhatOneRunSays) {
  const ProgramRun whole = run({"prove", program_, "--builtin", "--format", "json"});
  const ProgramRun joined = merge(parts(3, "json"));
  EXPECT_EQ(joined.exit, 1);  // b and e are violated
  EXPECT_EQ(whole.exit, 1);
  const nlohmann::json one = nlohmann::json::parse(whole.out), many = nlohmann::json::parse(joined.out);
  EXPECT_GE(verdicts(one).size(), 5U);
  EXPECT_EQ(verdicts(one), verdicts(many));
  EXPECT_EQ(one["summary"], many["summary"]);
  EXPECT_EQ(one["coverage"], many["coverage"]);
  const auto schema = nlohmann::json::parse(contentOf(RUNGPROOF_SOURCE_DIR "/frontend/report/schema.json"));
  EXPECT_EQ(schemaFaults(many, schema), std::vector<std::string>{});
  EXPECT_EQ(schemaFaults(nlohmann::json::parse(contentOf(folder_.path("part2.json"))), schema),
            std::vector<std::string>{});
}

TEST_F(Merge, SarifAndJunitCountEachResultOnce) {
  const auto one = nlohmann::json::parse(run({"prove", program_, "--builtin", "--format", "sarif"}).out)["runs"][0];
  const auto many = nlohmann::json::parse(merge(parts(2, "sarif")).out)["runs"][0];
  EXPECT_EQ(one["results"].size(), many["results"].size());
  for (const nlohmann::json& result : many["results"])
    EXPECT_EQ(many["tool"]["driver"]["rules"][result["ruleIndex"].get<std::size_t>()]["id"], result["ruleId"]);
  EXPECT_EQ(many["properties"].contains("shard"), false);

  pugi::xml_document whole, joined;
  ASSERT_TRUE(whole.load_string(run({"prove", program_, "--builtin", "--format", "junit"}).out.c_str()));
  const ProgramRun merged = merge(parts(2, "junit"));
  ASSERT_TRUE(joined.load_string(merged.out.c_str())) << merged.err;
  for (const char* count : {"tests", "failures", "errors"})
    EXPECT_STREQ(whole.child("testsuites").attribute(count).value(),
                 joined.child("testsuites").attribute(count).value());
  EXPECT_EQ(merged.exit, 1);
}

// Seven machines for five properties: two of them have nothing to do, which is no fault of theirs.
TEST_F(Merge, PartsMayBeEmpty) {
  const ProgramRun last = run({"prove", program_, "--shard", "7/7"});
  EXPECT_EQ(last.exit, 0) << last.out << last.err;
  const ProgramRun joined = merge(parts(7, "json"));
  EXPECT_EQ(verdicts(nlohmann::json::parse(joined.out)),
            verdicts(nlohmann::json::parse(run({"prove", program_, "--builtin", "--format", "json"}).out)));
}

TEST_F(Merge, RefusesWhatIsNotTheWholeRun) {
  const std::vector<std::string> files = parts(3, "json");
  EXPECT_TRUE(merge({files[0], files[2]}).says("part 2 of 3 is missing"));
  EXPECT_EQ(merge({files[0], files[2]}).exit, 2);
  EXPECT_TRUE(merge({files[0], files[1], files[1]}).says("part 2 is there twice"));
  const std::string plain = folder_.path("plain.json");
  run({"prove", program_, "--format", "json=" + plain});
  EXPECT_TRUE(merge({files[0], plain}).says("'" + plain + "' is no part of a report"));
  const std::string other = folder_.path("other.json");
  run({"prove", program_, "--shard", "2/2", "--format", "json=" + other});
  EXPECT_TRUE(merge({files[0], other}).says("one of 2"));
  EXPECT_EQ(merge({files[0], folder_.file("x.json", "{]")}).exit, 2);
  EXPECT_EQ(merge({folder_.path("nowhere.json")}).exit, 2);
  for (const char* shard : {"0/3", "4/3", "2", "a/b", "1/2x", "1/0"}) {
    const ProgramRun wrong = run({"prove", program_, "--shard", shard});
    EXPECT_EQ(wrong.exit, 2) << shard;
    EXPECT_TRUE(wrong.says("is no value for --shard")) << shard;
  }
}

// What would be joined is one run: the same texts, CPU and options in every part.
TEST_F(Merge, RefusesPartsOfOtherRuns) {
  const std::string text = contentOf(program_);
  const auto part = [&](const std::string& form, const std::string& program, const std::string& shard,
                        const std::vector<std::string>& options = {}) {
    const std::string file = folder_.path("run." + form);
    std::vector<std::string> arguments = {"prove",   "--isolated", program,    "--builtin",
                                          "--shard", shard,        "--format", form + "=" + file};
    arguments.insert(arguments.end(), options.begin(), options.end());
    run(arguments);
    return folder_.file(std::to_string(++count_) + "." + form, contentOf(file));
  };
  for (const char* form : {"json", "sarif", "junit"}) {
    const std::string first = part(form, program_, "1/2"), second = part(form, program_, "2/2");
    EXPECT_NE(merge({first, second}).exit, 2) << form << merge({first, second}).err;
    // Another machine has the file in a folder of its own; how long it may look is its own affair.
    const std::string copy = folder_.file("copy.awl", text);
    EXPECT_NE(merge({first, part(form, copy, "2/2", {"--timeout", "60s", "--jobs", "1"})}).exit, 2) << form;

    const auto refuses = [&](const std::string& other, const std::string& reason) {
      const ProgramRun joined = merge({first, other});
      EXPECT_EQ(joined.exit, 2) << form << " " << reason << joined.out;
      EXPECT_TRUE(joined.says(reason)) << joined.err;
      EXPECT_TRUE(joined.says("'" + first + "'") && joined.says("'" + other + "'")) << joined.err;
      EXPECT_TRUE(joined.says("= help: make all parts ")) << joined.err;
    };
    refuses(part(form, folder_.file("other.awl", text + " "), "2/2"), "the parts are about different texts");
    folder_.file("p.awl", text + " ");
    refuses(part(form, program_, "2/2"), "has another text than that of");
    folder_.file("p.awl", text);
    refuses(part(form, program_, "2/2", {"--scan-time", "10ms"}), "with --scan-time 10ms");
    refuses(part(form, program_, "2/2", {"--bound", "5"}), "with --bound 5");
    refuses(part(form, program_, "2/2", {"--cpu", "224"}), "224, 2004 edition");
    refuses(part(form, program_, "2/2", {"--only", "a"}), "with --only a");
    refuses(part(form, program_, "2/2", {"--props", folder_.file("q.prop", "prove q: I0.0 or not I0.0\n")}),
            "the parts are about different texts");
  }
  // A report of an older version names no program.
  nlohmann::json old = nlohmann::json::parse(contentOf(part("json", program_, "2/2")));
  old["shard"].erase("programs");
  EXPECT_TRUE(merge({part("json", program_, "1/2"), folder_.file("old.json", old.dump())})
                  .says("does not say which program it is about"));
}

// A program that nobody can read is 2 in each part, and joined.
TEST_F(Merge, TheWorstExitCodeCounts) {
  folder_.file("p.awl", "//@ prove a: never Q0.0\n" + mainBlock("Network 1\nLD I0.0\nXYZ\n= Q0.0\n"));
  EXPECT_EQ(merge(parts(2, "json")).exit, 2);
  EXPECT_EQ(worst_, 2);
}

}  // namespace
}  // namespace rungproof::test
