// The shape of the sources, as the README of each floor states it: includes point one way, no file is too long to read,
// and names in unnamed namespaces differ within a library, because several files are compiled as one (an equal name
// with other parameters would be no error there, but another overload).
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "analysis/rule.hpp"
#include "analysis/schedule/schedule.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof {
namespace {

namespace fs = std::filesystem;

/// The rooms, each with those that it may include from. Who may include from `ir` may from the families too.
const std::map<std::string, std::set<std::string>> roomsBelow = {
    {"engine/platform", {}},
    {"ir", {}},
    // The families run on one machine, and know nothing of each other.
    {"ir/machine", {"ir"}},
    {"ir/s7200", {"ir", "ir/machine"}},
    {"ir/s7300", {"ir", "ir/machine"}},
    {"ir/iec", {"ir", "ir/machine"}},
    {"ir/families", {"ir", "ir/machine", "ir/s7200", "ir/s7300", "ir/iec"}},
    {"engine", {"ir"}},
    {"analysis", {"ir", "engine"}},
    {"analysis/flow", {"ir", "engine", "analysis"}},
    {"analysis/lint", {"ir", "analysis", "analysis/flow"}},
    {"analysis/unread", {"ir", "analysis", "analysis/flow", "analysis/lint"}},
    {"analysis/panel", {"ir", "engine", "analysis", "analysis/flow"}},
    {"analysis/comment", {"ir"}},
    {"analysis/schedule", {}},
    {"analysis/drawing", {"ir", "analysis", "analysis/flow", "analysis/unread"}},
    {"analysis/checks",
     {"ir", "analysis", "analysis/flow", "analysis/unread", "analysis/panel", "analysis/comment", "analysis/drawing",
      "analysis/graph", "analysis/encoding", "analysis/asking", "analysis/witness", "analysis/proof"}},
    {"analysis/graph", {"ir", "engine"}},
    {"analysis/bits", {"ir", "analysis/graph", "analysis/schedule"}},
    {"analysis/encoding", {"ir", "engine", "analysis", "analysis/flow", "analysis/graph", "analysis/bits"}},
    {"analysis/words", {"ir", "analysis/graph", "analysis/bits", "analysis/schedule"}},
    {"analysis/recheck", {"ir", "engine/platform", "analysis/graph", "analysis/schedule"}},
    {"analysis/portfolio",
     {"ir", "analysis/graph", "analysis/bits", "analysis/words", "analysis/recheck", "analysis/schedule"}},
    {"analysis/export", {"ir", "analysis/graph", "analysis/bits"}},
    {"analysis/asking", {"ir", "analysis", "analysis/flow", "analysis/graph", "analysis/encoding"}},
    {"analysis/witness",
     {"ir", "engine", "analysis", "analysis/graph", "analysis/bits", "analysis/encoding", "analysis/schedule"}},
    {"analysis/proof",
     {"ir", "engine", "engine/platform", "analysis", "analysis/flow", "analysis/unread", "analysis/graph",
      "analysis/bits", "analysis/encoding", "analysis/asking", "analysis/witness", "analysis/portfolio",
      "analysis/schedule"}},
    {"analysis/equivalence",
     {"ir", "engine", "analysis", "analysis/flow", "analysis/lint", "analysis/unread", "analysis/graph",
      "analysis/bits", "analysis/encoding", "analysis/witness", "analysis/portfolio", "analysis/proof"}},
    {"analysis/testing",
     {"ir", "engine", "analysis", "analysis/graph", "analysis/encoding", "analysis/asking", "analysis/schedule",
      "analysis/witness", "analysis/proof", "analysis/equivalence", "analysis/selfcheck"}},
    {"analysis/selfcheck",
     {"ir", "engine", "engine/lanes", "analysis", "analysis/schedule", "analysis/witness", "analysis/proof",
      "analysis/equivalence"}},
};

struct Source {
  fs::path path;
  std::string folder;  ///< relative to the root: "analysis/bits"
  std::string text;
};

const std::vector<Source>& sources() {
  static const std::vector<Source> all = [] {
    std::vector<Source> found;
    const fs::path root = RUNGPROOF_SOURCE_DIR;
    for (const char* top : {"ir", "engine", "analysis", "frontend"}) {
      for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
        if (entry.path().extension() != ".cpp" && entry.path().extension() != ".hpp") continue;
        std::stringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        found.push_back({entry.path(), fs::relative(entry.path().parent_path(), root).generic_string(), text.str()});
      }
    }
    return found;
  }();
  return all;
}

/// The room of a file in ir/s7200/isa is ir/s7200; analysis has rooms of its own.
std::string roomOf(const std::string& folder) {
  for (std::string room = folder; !room.empty();
       room = room.substr(0, room.find_last_of('/') + 1 == 0 ? 0 : room.find_last_of('/'))) {
    if (roomsBelow.contains(room)) return room;
  }
  return "";
}

TEST(Layout, IncludesPointOneWay) {
  const std::regex include("#include \"([a-z_/0-9]+)/[a-z_0-9]+\\.hpp\"");
  std::size_t count = 0;
  for (const Source& source : sources()) {
    const std::string room = roomOf(source.folder);
    if (room.empty()) continue;  // frontend, which stands above all
    for (std::sregex_iterator i(source.text.begin(), source.text.end(), include), end; i != end; ++i) {
      const std::string folder = (*i)[1], target = roomOf(folder);
      ++count;
      const std::set<std::string>& below = roomsBelow.at(room);
      const bool isOfIr = target.starts_with("ir/") && !room.starts_with("ir") && below.contains("ir");
      EXPECT_TRUE(target == room || below.contains(target) || isOfIr) << source.path << " includes from " << folder;
    }
  }
  EXPECT_GT(count, 700u) << "the search no longer finds the includes";
}

/// A way along includes from a folder back to itself, folder by folder; empty if there is none.
std::vector<std::string> circleIn(const std::map<std::string, std::set<std::string>>& below) {
  std::vector<std::string> way;
  std::set<std::string> done;
  const std::function<bool(const std::string&)> visit = [&](const std::string& folder) {
    if (const auto met = std::ranges::find(way, folder); met != way.end()) {
      way.erase(way.begin(), met);
      return true;
    }
    if (done.contains(folder)) return false;
    way.push_back(folder);
    if (const auto next = below.find(folder); next != below.end()) {
      for (const std::string& other : next->second) {
        if (visit(other)) return true;
      }
    }
    way.pop_back();
    done.insert(folder);
    return false;
  };
  for (const auto& [folder, others] : below) {
    if (visit(folder)) return way;
  }
  return {};
}

TEST(Layout, FoldersIncludeInNoCircle) {
  EXPECT_TRUE(circleIn({{"a", {"b", "c"}}, {"b", {"c"}}}).empty());
  EXPECT_EQ(circleIn({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b"}}}), (std::vector<std::string>{"b", "c"}));
  const std::regex include("#include \"([a-z_/0-9]+)/[a-z_0-9]+\\.hpp\"");
  std::map<std::string, std::set<std::string>> below;
  for (const Source& source : sources()) {
    for (std::sregex_iterator i(source.text.begin(), source.text.end(), include), end; i != end; ++i) {
      const std::string from = source.folder, to = (*i)[1];
      if (from != to) below[from].insert(to);
    }
  }
  EXPECT_GT(below.size(), 30u) << "the search no longer finds the includes";
  EXPECT_EQ(circleIn(below), std::vector<std::string>());
}

TEST(Layout, TheReadmeOfEachFloorSaysWhatLivesInEveryFolder) {
  std::map<std::string, std::string> readmes;
  for (const std::string floor : {"ir", "engine", "analysis", "frontend"}) {
    std::stringstream text;
    text << std::ifstream(fs::path(RUNGPROOF_SOURCE_DIR) / floor / "README.md").rdbuf();
    readmes[floor] = text.str();
  }
  std::set<std::string> folders;
  for (const Source& source : sources()) folders.insert(source.folder);
  for (const std::string& folder : folders) {
    const std::string floor = folder.substr(0, folder.find('/'));
    EXPECT_NE(readmes[floor].find("`" + folder + "/`"), std::string::npos)
        << folder << " is not in " << floor << "/README.md";
    EXPECT_TRUE(!folder.starts_with("analysis") || roomsBelow.contains(folder)) << folder;
  }
}

TEST(Layout, TopLevelHoldsNothingElse) {
  const std::set<std::string> known = {
      "CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "analysis", "corpus",
      "engine",         "frontend",          "ir",      "tests",     "build"};
  for (const auto& entry : fs::directory_iterator(RUNGPROOF_SOURCE_DIR)) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(name.starts_with(".") || known.contains(name)) << name;
  }
}

TEST(Layout, NoFileIsTooLongToRead) {
  for (const Source& source : sources()) {
    EXPECT_LE(std::count(source.text.begin(), source.text.end(), '\n'), 600) << source.path;
    EXPECT_TRUE(source.text.starts_with("// ")) << source.path << " does not say what it is for";
  }
}

TEST(Layout, OnlyThePlatformKnowsTheSystem) {
  // Questions of the preprocessor, and headers that only one system has.
  const std::regex asked(
      "# *(if|ifdef|ifndef|elif).*\\b(_WIN32|__WIN32|WIN32|__linux__|__unix__|__APPLE__|__MINGW\\w*)\\b|"
      "# *include *<(unistd|poll|fcntl|fnmatch|dlfcn|elf|link|pthread|termios|spawn|dirent|glob|malloc|io|windows|"
      "winsock2|shlobj|sys/\\w+)\\.h>|# *include *<csignal>");
  EXPECT_TRUE(std::regex_search(std::string("#ifdef _WIN32"), asked));
  EXPECT_TRUE(std::regex_search(std::string("#if defined(__linux__) && x"), asked));
  EXPECT_TRUE(std::regex_search(std::string("#include <sys/stat.h>"), asked));
  EXPECT_FALSE(std::regex_search(std::string("#if defined(__x86_64__)"), asked));
  EXPECT_FALSE(std::regex_search(std::string("#include <filesystem>"), asked));
  std::size_t knowing = 0;
  for (const Source& source : sources()) {
    std::istringstream in(source.text);
    bool isKnown = false;
    for (std::string line; !isKnown && std::getline(in, line);)
      isKnown = line.starts_with("#") && std::regex_search(line, asked);
    if (source.folder.starts_with("engine/platform/"))
      knowing += isKnown ? 1 : 0;
    else
      EXPECT_FALSE(isKnown) << source.path << " asks for the system; engine/platform/ has an interface for each need";
  }
  EXPECT_GT(knowing, 10u) << "the search no longer finds the implementations";
}

/// Characters of a line of UTF-8.
std::size_t charactersOf(const std::string& line) {
  return static_cast<std::size_t>(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

TEST(Layout, LinesAreAsWideAsTheFormatAllows) {
  // Tables between clang-format off and on, and texts in raw strings, are as wide as they are.
  const std::regex rawBegin("R\"([a-z]*)\\(");
  for (const Source& source : sources()) {
    std::istringstream in(source.text);
    bool isTable = false;
    std::string rawEnd;  // of the text that goes on
    for (std::string line; std::getline(in, line);) {
      isTable = isTable ? line.find("clang-format on") == std::string::npos
                        : line.find("clang-format off") != std::string::npos;
      if (std::smatch begin; rawEnd.empty() && std::regex_search(line, begin, rawBegin))
        rawEnd = ")" + begin[1].str() + "\"";
      EXPECT_TRUE(isTable || !rawEnd.empty() || charactersOf(line) <= 120) << source.path << ": " << line;
      if (!rawEnd.empty() && line.find(rawEnd) != std::string::npos) rawEnd.clear();
    }
  }
}

/// Readers and printers of text, which have to know how instructions are spelt. Everybody else asks the descriptor.
bool mayKnowSpellings(const Source& source) {
  static const std::set<std::string> rooms = {
      "ir",     "ir/families",  "ir/s7200",     "ir/s7200/isa",   "ir/s7300",           "ir/s7300/isa",
      "ir/iec", "frontend/iec", "frontend/stl", "frontend/step7", "frontend/graphical", "frontend/plcopen"};
  static const std::set<std::string> files = {"explain.cpp", "completion.cpp", "instruction_page.cpp",
                                              "swallowed_text.cpp"};
  return rooms.contains(source.folder) || files.contains(source.path.filename().string());
}

/// The part of a line that asks how an instruction is spelt, or nothing: `desc.stl == "LD"`, `stl.back()`, a view of
/// the spelling kept to be compared, a look-up by name, or any comparison with a mnemonic of two letters or more.
std::string spellingAsked(const std::string& line) {
  static const std::regex ofDesc(
      "\\bstl\\b *(==|!=|\\[|\\.(back|front|starts_with|ends_with|find|contains|substr|at|compare|data|begin)\\b)|"
      "(==|!=) *[\\w.>*()-]*(\\.|->)stl\\b|string_view \\w+ = [^;]*(\\.|->)stl;|"
      "[Ii]nstructions(\\(\\)|_)\\.(named|namedGerman|alias)\\(");
  static const std::regex literal("(==|!=|starts_with\\(|ends_with\\() *\"([^\"]+)\"|\"([^\"]+)\" *(==|!=)");
  const auto has = [&](std::string_view part) { return line.find(part) != std::string::npos; };
  std::smatch match;
  if ((has("stl") || has("nstructions")) && std::regex_search(line, match, ofDesc)) return match.str();
  if (!has("\"") || (!has("==") && !has("!=") && !has("_with("))) return "";
  for (std::sregex_iterator i(line.begin(), line.end(), literal), end; i != end; ++i) {
    const std::string word = (*i)[2].matched ? (*i)[2].str() : (*i)[3].str();
    const bool isSign = std::none_of(word.begin(), word.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
    if (word.size() > 1 && !isSign && s7200Instructions().named(word) != nullptr) return i->str();
  }
  return "";
}

TEST(Layout, OnlyReadersAndPrintersKnowHowInstructionsAreSpelt) {
  for (const char* line : {"  if (desc.stl == \"LD\") return;", "const bool n = i.desc->stl.back() == 'N';",
                           "return wanted == element.desc->stl;", "const std::string_view name = i.desc->stl;",
                           "if (name == \"ATCH\") return;", "const Desc* d = s7200Instructions().named(text);",
                           "if (text.starts_with(\"MOVB\"))"})
    EXPECT_NE(spellingAsked(line), "") << line;
  for (const char* line : {"std::string text(instruction.desc->stl);", "fmt::format(\"{} of\", desc.stl)",
                           "if (form == \"stl\") return;", "if (relation == \"=\") return a == b;"})
    EXPECT_EQ(spellingAsked(line), "") << line;
  std::size_t knowing = 0;
  for (const Source& source : sources()) {
    std::istringstream in(source.text);
    for (std::string line; std::getline(in, line);) {
      const std::string asked = line.find_first_not_of(' ') == line.find("//") ? "" : spellingAsked(line);
      if (mayKnowSpellings(source))
        knowing += asked.empty() ? 0 : 1;
      else
        EXPECT_EQ(asked, "") << source.path << ": " << line;
    }
  }
  EXPECT_GT(knowing, 20u) << "the search no longer finds the readers";
}

/// The part of a line that compares a family by its name instead of asking it (ir/family.hpp), or nothing.
std::string familyAsked(const std::string& line) {
  static const std::regex named(
      "\\b(is|has|are|of)(Of)?(Step7|S7200|S7300|S7400|Iec)(Old|New)?_?\\b|"  // questions, flags filled by them
      "\\b(s7200|s7300|s7400|iec)Dialect\\b|\\bfirst(Step7|Iec)Cpu\\b|\\bEdition::(Step7|Iec)\\b|"
      "(==|!=|&) *dialect::|\\bdialect::\\w+\\)* *(==|!=|&)|"
      "(==|!=) *\"(s7-[234]00|iec|S7-[234]00|IEC 61131-3)\"|dynamic_cast<const (Step7|Iec)");
  static constexpr std::string_view marks[] = {
      "Step7", "Iec", "S7200", "S7300", "S7400", "dialect::", "Dialect", "\"s7-", "\"S7-", "\"iec", "\"IEC"};
  const auto has = [&](std::string_view mark) { return line.find(mark) != std::string::npos; };
  if (std::ranges::none_of(marks, has)) return "";
  std::smatch match;
  return std::regex_search(line, match, named) ? match.str() : "";
}

/// The families themselves, their list, and who reads or prints the text of one of them.
bool mayNameFamilies(const Source& source) {
  static const std::set<std::string> rooms = {
      "ir/families",  "ir/s7200",     "ir/s7200/isa",     "ir/s7300",       "ir/s7300/isa",
      "ir/iec",       "ir/iec/isa",   "frontend/reader",  "frontend/step7", "frontend/input",
      "frontend/iec", "frontend/stl", "frontend/explain", "frontend/mc7",   "frontend/s7project"};
  const std::string file = source.path.filename().string();
  return rooms.contains(source.folder) || (source.folder == "frontend/command" && file == "explain.cpp");
}

TEST(Layout, NobodyComparesAFamilyByItsName) {
  for (const char* line : {"  if (isStep7(program.target)) return;", "if (plan.isIec()) return;", "bool isStep7_;",
                           "const bool isOfIec = x;", "if (&dialectOf(cpu) == &s7300Dialect)",
                           "if ((set & dialect::S7200) == 0)", "if (rule.dialects != dialect::Iec)",
                           "return dialect.name == \"s7-300\";", "cpu >= firstStep7Cpu", "const bool isStep7New = x;"})
    EXPECT_NE(familyAsked(line), "") << line;
  for (const char* line : {"if (facts.form() == StatementForm::Rungs) return;", "    .dialects = dialect::S7200,",
                           "if (before.set == after.set) return true;", "const bool isTimer = isIecTimer(block);"})
    EXPECT_EQ(familyAsked(line), "") << line;
  std::size_t naming = 0;
  for (const Source& source : sources()) {
    std::istringstream in(source.text);
    for (std::string line; std::getline(in, line);) {
      const std::string asked = line.find_first_not_of(' ') == line.find("//") ? "" : familyAsked(line);
      if (mayNameFamilies(source))
        naming += asked.empty() ? 0 : 1;
      else
        EXPECT_EQ(asked, "") << source.path << ": " << line;
    }
  }
  EXPECT_GT(naming, 10u) << "the search no longer finds the families";
}

/// Who reads a file, a comment or a baseline tells what is wrong with it on the spot, under the id of a rule that has
/// its page in analysis/checks.
bool mayTell(const Source& source, std::string_view id) {
  static const std::map<std::string, std::set<std::string_view>> told = {
      {"suppress.cpp", {"SUP001", "SUP002"}},
      {"baseline.cpp", {"SUP003"}},
      {"syntax_sink.cpp", {"STY004"}},
      {"check.cpp", {"GRF001", "GRF003"}},
      {"drawn_sink.cpp", {"GRF001", "GRF002", "GRF003"}},
  };
  const auto found = told.find(source.path.filename().string());
  return found != told.end() && found->second.contains(id);
}

/// Ids of rules that stand as a text of their own in the code: `"OUT003"`. Help texts and comments may give examples.
std::vector<std::string> ruleIdsIn(const std::string& text) {
  static const std::regex literal("\"([A-Z]{3}[0-9]{3})\"");
  std::vector<std::string> found;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.find_first_not_of(' ') == line.find("//")) continue;
    line = line.substr(0, line.find(" //"));
    for (std::sregex_iterator i(line.begin(), line.end(), literal), end; i != end; ++i) {
      if (ruleNamed((*i)[1].str()) != nullptr) found.push_back((*i)[1]);
    }
  }
  return found;
}

TEST(Layout, ARuleIsOneFileAndNobodyElseKnowsItsId) {
  EXPECT_EQ(ruleIdsIn("  ask(kind, \"OUT003\", name);  // \"OUT001\"\n  // \"OUT002\"\n"),
            std::vector<std::string>{"OUT003"});
  EXPECT_EQ(ruleIdsIn("\"give a rule (ADR001), a group\" \"SYN001\""), std::vector<std::string>{});
  std::size_t rules = 0;
  for (const Source& source : sources()) {
    for (const std::string& id : ruleIdsIn(source.text)) {
      if (source.folder == "analysis/checks")
        ++rules;
      else
        EXPECT_TRUE(mayTell(source, id)) << source.path << " names " << id;
    }
  }
  EXPECT_GE(rules, allRules().size()) << "the search no longer finds the rules";
}

/// A share, limit or patience of the prover that stands outside the table of its schedule: a constant with a number.
/// What a program or the controller gives, patterns and marks are no schedule.
bool isOfNoSchedule(const std::string& name) {
  static const std::set<std::string> names = {"depths",       "everyScan",     "none",           "noInput",
                                              "noReader",     "prime",         "endless",        "longestQueue",
                                              "longestTable", "shownScans",    "shownAddresses", "onWords",
                                              "unreached",    "largestPreset", "mostHalves",     "noClause",
                                              "own",          "yes",           "givenInputs",    "joined"};
  return names.contains(name);
}
std::string scheduledElsewhere(const std::string& line) {
  static const std::regex constant(
      "constexpr (?:double|int|unsigned|std::u?int\\d*_t|std::size_t) (\\w+) = [^;]*[0-9]");
  static const std::regex seconds("(Budget::seconds|slice)\\([0-9.]+\\)");
  std::smatch match;
  if (std::regex_search(line, match, constant) && !isOfNoSchedule(match[1])) return match.str();
  return std::regex_search(line, match, seconds) && match.str() != "slice(0)" ? match.str() : "";
}

TEST(Layout, TheScheduleOfTheProverIsOneTable) {
  EXPECT_NE(scheduledElsewhere("constexpr double quickSeconds = 0.5;  ///< for each question"), "");
  EXPECT_NE(scheduledElsewhere("  static constexpr std::size_t mostStates = 3000;"), "");
  EXPECT_NE(scheduledElsewhere("  const Budget budget = Budget::seconds(0.5);"), "");
  EXPECT_EQ(scheduledElsewhere("  const Budget budget = Budget::seconds(schedule::inputSampleSeconds);"), "");
  const std::set<std::string> rooms = {"analysis/bits",    "analysis/words", "analysis/portfolio", "analysis/asking",
                                       "analysis/witness", "analysis/proof", "analysis/recheck"};
  std::size_t uses = 0;
  std::string all;
  for (const Source& source : sources()) {
    all += source.folder == "analysis/schedule" ? "" : source.text;
    if (!rooms.contains(source.folder)) continue;
    std::istringstream in(source.text);
    for (std::string line; std::getline(in, line);) EXPECT_EQ(scheduledElsewhere(line), "") << source.path;
  }
  for (const ScheduleRow& row : scheduleRows) {
    EXPECT_FALSE(row.reason.empty()) << row.name;
    const bool isUsed = all.find("schedule::" + std::string(row.name)) != std::string::npos;
    EXPECT_TRUE(isUsed) << "nobody keeps to " << row.name;
    uses += isUsed ? 1 : 0;
  }
  EXPECT_GT(uses, 100u);
}

/// Lines of the unnamed namespaces of a file that begin in the first column, where declarations stand.
std::vector<std::string> hiddenDeclarations(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  bool isHidden = false;
  for (std::string line; std::getline(in, line);) {
    if (line == "namespace {") {
      isHidden = true;
    } else if (line.starts_with("}  // namespace")) {
      isHidden = false;
    } else if (isHidden && !line.empty() && (std::isalpha(static_cast<unsigned char>(line[0])) != 0)) {
      lines.push_back(line);
    }
  }
  return lines;
}

std::string declaredName(const std::string& line) {
  static const std::regex type("(?:struct|class|enum class) (\\w+).*");
  static const std::regex alias("using (\\w+) = .*");
  static const std::regex other("(?:[\\w:<>,&*]| (?=[\\w&*:]))+? [&*]*(\\w+)(?:\\(|\\{| = |\\[|;).*");
  std::smatch match;
  if (std::regex_match(line, match, type) || std::regex_match(line, match, alias)) return match[1];
  return std::regex_match(line, match, other) ? match[1].str() : "";
}

TEST(Layout, NamesInUnnamedNamespacesDifferWhereFilesAreCompiledTogether) {
  EXPECT_EQ(declaredName("constexpr std::string_view rungRules[] = {\"LOG001\"};"), "rungRules");
  EXPECT_EQ(declaredName("std::map<Key, std::vector<int>> placesOf(const Facts& facts) {"), "placesOf");
  EXPECT_EQ(declaredName("using Clock = std::chrono::steady_clock;"), "Clock");
  std::map<std::pair<std::string, std::string>, std::map<std::string, std::string>> seen;  // library, name: file, line
  std::size_t count = 0;
  for (const Source& source : sources()) {
    if (source.path.extension() != ".cpp" || source.folder == "frontend/reader") continue;  // compiled one by one
    if (source.folder == "engine/platform/windows") continue;  // in the place of engine/platform/posix
    static const std::set<std::string> brief = {"analysis/drawing",   "analysis/export", "analysis/asking",
                                                "analysis/witness",   "analysis/proof",  "analysis/equivalence",
                                                "analysis/selfcheck", "analysis/testing"};
    static const std::set<std::string> ofCommands = {"frontend/command", "frontend/report", "frontend/trace"};
    const std::string library = source.folder == "analysis/checks"   ? "checks"
                                : brief.contains(source.folder)      ? "brief"
                                : ofCommands.contains(source.folder) ? "commands"
                                                                     : source.folder.substr(0, source.folder.find('/'));
    for (const std::string& line : hiddenDeclarations(source.text)) {
      const std::string name = declaredName(line);
      if (name.empty()) continue;
      ++count;
      seen[{library, name}].emplace(source.folder + "/" + source.path.filename().string(), line);
    }
  }
  for (const auto& [key, places] : seen) {
    std::set<std::string> lines;
    std::string files;
    for (const auto& [file, line] : places) {
      lines.insert(line);
      files += " " + file;
    }
    const bool isOneAlias =
        lines.size() == 1 && (lines.begin()->starts_with("using ") || lines.begin()->starts_with("namespace "));
    EXPECT_TRUE(places.size() == 1 || isOneAlias) << key.second << " in" << files;
  }
  EXPECT_GT(count, 600u) << "the search no longer finds the names";
}

}  // namespace
}  // namespace rungproof
