// Every kind of record of what a verdict rests on - approximated, not followed, any value, assumed, not asked - reaches
// the reader in every form of the report. The kinds are the sentences in the sources that make them: a new one without
// a row here fails.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "tests/program_run.hpp"
#include "tests/step7/flgnet_text.hpp"
#include "tests/step7/run7.hpp"

namespace rungproof::test {
namespace {

namespace fs = std::filesystem;

/// A record and a question whose verdict names it.
struct Record {
  std::string sentence;  ///< a part of the sentence as the source has it
  std::string told;      ///< a part of what the reader sees; empty: the sentence
  std::string program;
  std::string properties;  ///< empty: `equiv` of the program with itself
  std::vector<std::string> options{};
};

std::string interrupts(const std::string& routine) {
  return "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nATCH INT0, 0\nATCH INT1, 2\nENI\nNetwork 2\n"
         "LD I0.7\n= Q0.7\nEND_ORGANIZATION_BLOCK\nINTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\n" +
         routine +
         "END_INTERRUPT_BLOCK\nINTERRUPT_BLOCK INT_1:INT1\nBEGIN\nNetwork 1\nLD SM0.0\nINCB VB21\n"
         "END_INTERRUPT_BLOCK\n";
}
/// A main program of so many places at which an interrupt can come and be noticed.
std::string manyPlaces() {
  std::string text =
      "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nATCH INT0, 0\nENI\nNetwork 2\nLD SM0.0\n";
  for (int i = 0; i < 450; ++i) text += "INCB VB20\n";
  return text +
         "END_ORGANIZATION_BLOCK\nINTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nINCB VB20\n"
         "END_INTERRUPT_BLOCK\n";
}
std::string counting(const std::string& control) {
  return mainBlock("Network 1\nLD SM0.1\nMOVB " + control +
                   ", SMB47\nMOVD 0, SMD48\nHDEF 1, 0\nHSC 1\nNetwork 2\nLDD> HC1, 100\n= Q0.0\n");
}

/// A timer whose data the export lacks.
std::string drawnTimer() {
  test7::DrawnNet net;
  const int box = net.part("TON", test7::instanceText("\"Wait\"") + test7::typed("time_type", "Time"));
  net.in("M0.0", box, "IN");
  net.in("T#1S:Time", box, "PT");
  net.out(box, "Q", "Q0.0");
  return test7::drawnDocument(test7::drawnBlock("OB", "Main", 1, "", test7::unit(net.text())));
}

const std::string divides =
    "PROGRAM main\nVAR_INPUT\n  a : INT;\nEND_VAR\nVAR\n  q : BOOL;\nEND_VAR\nq := 10 / a > 2;\nEND_PROGRAM\n";

std::vector<Record> records() {
  using test7::block;
  const std::string plain = mainBlock("Network 1\nLD I0.0\n= Q0.0\n"), follows = "prove p: Q0.0 implies I0.0\n";
  const std::string plain7 = block(1, "A I 0.0;= Q 0.0");
  const std::string data = "DATA_BLOCK DB 10\nSTRUCT\n  a : WORD;\n  b : WORD;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  const std::string sine =
      mainBlock("Network 1\nLD SM0.0\nDTR ID4, VD0\nSIN VD0, VD4\nNetwork 2\nLDR> VD4, 2.0\n= Q0.0\n");
  return {
      {"pointer whose targets could not be found", "",
       mainBlock("Network 1\nLD SM0.0\nMOVD ID0, VD0\nMOVB *VD0, VB10\n"), "prove p: VB10 = 0\n"},
      {"calls a block without visible text, which may change any memory", "",
       mainBlock("Network 1\nLD I0.0\nCALL SBR21, I0.0, M0.0\nNetwork 2\nLD M0.0\n= Q0.0\n"), ""},
      {"has no text: what it may write is any value", "",
       mainBlock("Network 1\nLD I0.0\nCALL SBR21, I0.0, M0.0\nNetwork 2\nLD M0.0\n= Q0.0\n"), "prove p: never Q0.0\n"},
      {"calls a block that no file has: what it may write is any value", "",
       "PROGRAM main\nVAR\n  d : Drive;\n  q : BOOL;\nEND_VAR\nd(Q => q);\nEND_PROGRAM\n", "prove p: never q\n"},
      {"which no file holds, begins with the start values", "the instance \"Wait\", which no file holds", drawnTimer(),
       "prove p: Q0.0 implies M0.0\n"},
      {"writes only what its calls give it", "",
       mainBlock("Network 1\nLD I0.0\nCALL SBR21, I0.0, M0.0\nNetwork 2\nLD M0.0\n= Q0.0\n"), "prove p: never Q0.0\n"},
      {"what later rounds of the loop write is taken as any value", "",
       mainBlock("Network 1\nLD SM0.0\nMOVW 0, VW0\nNetwork 2\nLBL 1\nNetwork 3\nLD SM0.0\nINCW VW0\nMOVW VW0, VW2\n"
                 "Network 4\nLDW< VW0, 1000\nJMP 1\n"),
       "prove p: VW2 <> 1500\n"},
      {"synchronous error in the block that takes such errors", "",
       data + block(121, "SET;= M 2.0;OPN DB 10;L DBW 8;SET;= M 2.1") +
           block(1, "A I 0.0;JCN no;OPN DB 10;L DBW 4;no: NOP 0"),
       "prove p: not M2.1\n"},
      {"OB{} inside OB{}, which use the same memory", "OB40 inside OB35, which use the same memory",
       block(1, "NOP 0") + block(40, "CLR;= M 1.0") + block(35, "SET;= M 1.0;AN M 1.0;= Q 0.3"), "prove p: not Q0.3\n"},
      {"interrupts that come more than {} times at one place",
       "interrupts that come more than",
       interrupts("LD SM0.0\nINCB VB20\n"),
       "prove p: VB20 <> 77 or VB21 <> 78\n",
       {"--timeout", "1s"}},
      {"interrupts are followed at the first ", "", manyPlaces(), "prove p: VB20 <> 77\n", {"--timeout", "1s"}},
      {"writes later through a pointer whose targets could not be found", "",
       mainBlock("Network 1\nLD SM0.1\nMOVB 2, SMB30\nMOVD ID0, VD0\nNetwork 2\nLD I0.0\nEU\nNETR *VD0, 0\n"),
       "prove p: VB300 = 0\n"},
      {"writes later into the status byte of another request", "",
       mainBlock("Network 1\nLD SM0.1\nMOVB 2, SMB30\nMOVB 3, VB206\nMOVB 2, VB214\nNetwork 2\nLD I0.0\nNETR VB200, 0\n"
                 "Network 3\nLD I0.1\nNETW VB208, 0\n"),
       "prove p: not V208.5\n"},
      {"the result of its REAL operation is taken as any value", "", sine, "prove p: not Q0.0\n"},
      {"interval clock = any value",
       "",
       mainBlock("Network 1\nLD SM0.0\nBITIM VD0\nNetwork 2\nLDD> VD0, 5\n= Q0.0\n"),
       "prove p: never Q0.0\n",
       {"--cpu", "224XP"}},
      {"clock = any time at each read",
       "",
       mainBlock("Network 1\nLD SM0.0\nTODR VB0\nNetwork 2\nLDB= VB3, 16#22\n= Q0.0\n"),
       "prove p: never Q0.0\n",
       {"--cpu", "224"}},
      {"interval clock = any value", "", block(1, "CALL SFC 64 (RET_VAL := MD 4);L MD 4;L L#5;>D;= Q 0.0"),
       "prove p: not Q0.0\n"},
      {"what it sends to a DP slave is no output of the program", "",
       block(1, "CALL SFC 15 (LADDR := W#16#3EA, RECORD := P#M 10.0 BYTE 8, RET_VAL := MW 4);A I 0.0;= Q 0.0"),
       follows},
      {"outputs are looked at where the scan ends, not where it writes them", "",
       block(1, "CALL SFC 27 (PART := B#16#0, RET_VAL := MW 4, FLADDR := MW 6);A I 0.0;= Q 0.0"), follows},
      {"date and time = any value at each read", "",
       "DATA_BLOCK DB 5\nSTRUCT\n  c : DATE_AND_TIME;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n" +
           block(1, "CALL SFC 1 (RET_VAL := MW 82, CDT := DB5.c);L DB5.DBB 4;L 5;==I;= Q 0.0"),
       "prove p: not Q0.0\n"},
      {"HC{} = any value in each scan", "HC1 = any value in each scan", counting("16#C0"), "prove p: never Q0.0\n"},
      {"nothing is asked of a scan that an error or SFC 46 cuts off", "",
       block(1, "A I 0.0;JCN go;CALL SFC 46;go: SET;= Q 0.0"), "prove p: Q0.0\n"},
      {"nothing is asked of a scan that a fatal error cuts off", "",
       mainBlock("Network 1\nLD I0.0\nSTOP\nNetwork 2\nLD SM0.0\n= Q0.0\n"), "prove p: Q0.0\n"},
      {"nothing is asked of a CPU that has stopped because it has no block", "", plain7, follows},
      {"nothing is asked of a scan that an error cuts off, nor behind it", "", divides, "prove p: q implies a > 0\n"},
      {"{} has any value in every scan", "a has any value in every scan", divides, "prove p: q implies a > 0\n"},
      {"every variable starts with its initial value", "", divides, "prove p: q implies a > 0\n"},
      {"every scan lasts {} ms", "every scan lasts 20 ms", plain, follows, {"--scan-time", "20ms"}},
      {"every scan lasts {} to {} ms", "every scan lasts 5 to 20 ms", plain, follows, {"--scan-time", "5ms..20ms"}},
      {"retentive memory starts with any value", "", plain, "initial retentive\n" + follows},
      {"memory starts with zero and the data block", "", plain, follows},
      {"runs begin with a {} restart", "runs begin with a warm restart", plain7 + block(102, "CLR;= Q 0.0"), follows},
      {"may be written from outside in any scan", "", plain, "external VB10..VB11\n" + follows},
      {"they write between two scans", "", counting("16#C0"), "prove p: never Q0.0\n"},
      {"nothing outside the program writes its memory", "", plain, follows},
      {"nothing else outside the program writes its memory", "", plain, "external VB10..VB11\n" + follows},
      {"never runs: a CPU {} does not start it",
       "OB32 never runs: a CPU 314",
       plain7 + block(32, "NOP 0"),
       follows,
       {"--cpu", "314"}},
      {"runs: a CPU {} starts it",
       "OB32 runs: a CPU 417 starts it",
       plain7 + block(32, "NOP 0"),
       follows,
       {"--cpu", "417"}},
      {"interrupts come anywhere in a scan", "", interrupts("LD SM0.0\nS Q0.0, 1\n"), "", {"--interrupts", "anywhere"}},
      {"interrupts come between scans", "", interrupts("LD SM0.0\nS Q0.0, 1\n"), ""},
      {"what XMT and NETW send is no output", "",
       mainBlock("Network 1\nLD SM0.1\nMOVB 9, SMB30\nMOVB 1, VB100\nXMT VB100, 0\n"), ""},
      {"physical inputs are steady for the whole scan", "", plain, "", {"--inputs", "steady"}},
      {"NEW in scan k + {0} is compared with OLD in scan k",
       "is compared with OLD in scan k",
       plain,
       "",
       {"--latency", "1"}},
      {"outputs may differ for less than {} ms without a break",
       "outputs may differ for less than",
       plain,
       "",
       {"--settle", "20ms"}},
      {"gives its outputs any value and writes nothing else",
       "",
       mainBlock("Network 1\nLD SM0.0\nCALL MBUS_CTRL, SM0.0, 9600, 0, 1000, M0.0, MB1\nNetwork 2\nLD M0.0\n= Q0.0\n"),
       "prove p: never Q0.0\n",
       {"--library-memory", "MBUS_CTRL=VB1000"}},
  };
}

/// Sentences that are no records of their own, by where they begin: names of free inputs, parts of others, what a run
/// is said to need, and what no program was found for (beside each why).
const std::vector<std::string> noRecords = {
    "module behind a pointer fails",  // name of an input
    "a timed event before its turn",
    "more interrupts before instruction",
    "more interrupts end the program",
    "status of RCV at port",
    "port {}: {} of the message",
    "{} is done all the same",
    "answer in {} of {}",
    " places of a scan only",                     // second half of a sentence above
    "{} starts {} ms into its period",            // condition of a run
    "RUN begins {} ms after a tick",              // condition of a run
    "a scan that is not followed to its end",     // name of a question
    "loop that runs longer than it is followed",  // CTL rules refuse the programs that reach it
    "a REAL operation in a property",             // properties have no REAL operations but comparisons
    "the V memory of {} ({} bytes)",              // of libraries whose memory has no place
    ", which leaves this open",                   // behind what broke it off: nothing that a verdict rests on
    "{} is called{}, but no file holds it",       // findings
};

/// The sentences of a source: string literals of five words and more.
std::vector<std::string> sentencesOf(const fs::path& file) {
  std::ifstream in(file);
  std::stringstream content;
  content << in.rdbuf();
  std::string text = content.str();
  text = std::regex_replace(text, std::regex(R"(//[^\n]*)"), "");
  text = std::regex_replace(text, std::regex(R"(CHECK\([^;]*;)"), "");
  std::vector<std::string> sentences;
  const std::regex literal(R"re("(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*)re"), join(R"re("\s*")re");
  for (std::sregex_iterator at(text.begin(), text.end(), literal), end; at != end; ++at) {
    std::string sentence = std::regex_replace(at->str(), join, "");
    if (sentence.size() < 2) continue;
    sentence = sentence.substr(1, sentence.size() - 2);
    if (std::ranges::count(sentence, ' ') >= 4) sentences.push_back(sentence);
  }
  return sentences;
}

TEST(Records, EveryKindHasARow) {
  const fs::path root(RUNGPROOF_SOURCE_DIR);
  const std::vector<Record> rows = records();
  int found = 0;
  for (const char* file : {"analysis/encoding/scan_encoding.cpp", "analysis/encoding/scan_interrupts.cpp",
                           "analysis/encoding/device_writes.cpp", "analysis/encoding/asked_properties.cpp",
                           "analysis/witness/circumstances.cpp", "analysis/proof/question_system.cpp",
                           "analysis/equivalence/comparison_basis.cpp", "analysis/unread/hidden_blocks.cpp"}) {
    const std::vector<std::string> sentences = sentencesOf(root / file);
    EXPECT_FALSE(sentences.empty()) << file;
    for (const std::string& sentence : sentences) {
      const bool isRecord = std::ranges::none_of(noRecords, [&](const auto& n) { return sentence.starts_with(n); });
      const bool hasRow = std::ranges::any_of(
          rows, [&](const Record& row) { return sentence.find(row.sentence) != std::string::npos; });
      EXPECT_TRUE(!isRecord || hasRow) << file << ": give this record a row: " << sentence;
      found += hasRow ? 1 : 0;
    }
  }
  EXPECT_GE(found, 30);
}

/// XML, HTML and JSON write some characters in another way.
std::string plainText(std::string text) {
  for (const auto& [code, plain] : {std::pair("&gt;", ">"),
                                    {"&lt;", "<"},
                                    {"&quot;", "\""},
                                    {"&apos;", "'"},
                                    {"&#39;", "'"},
                                    {"\\\"", "\""},
                                    {"&amp;", "&"},
                                    {"%3A", ":"}})
    for (std::size_t at; (at = text.find(code)) != std::string::npos;)
      text.replace(at, std::string(code).size(), plain);
  return text;
}

class RecordIn : public testing::TestWithParam<Record> {};

TEST_P(RecordIn, EveryFormOfTheReport) {
  const Record& record = GetParam();
  const TemporaryFolder folder;
  folder.file("a.awl", record.program);
  folder.file("a.prop", record.properties);
  const bool isComparison = record.properties.empty();
  std::vector<std::string> arguments =
      isComparison ? std::vector<std::string>{"equiv", folder.path("a.awl"), folder.path("a.awl")}
                   : std::vector<std::string>{"prove", folder.path("a.awl"), "--props", folder.path("a.prop")};
  arguments.insert(arguments.end(), record.options.begin(), record.options.end());
  arguments.emplace_back("--isolated");
  if (std::ranges::find(record.options, "--timeout") == record.options.end())
    arguments.insert(arguments.end(), {"--timeout", "5s"});
  if (std::ranges::find(record.options, "--cpu") == record.options.end() &&
      record.program.starts_with("ORGANIZATION_BLOCK OB 1\n"))
    arguments.insert(arguments.end(), {"--dialect", "s7-300"});
  std::vector<std::string> files;
  const std::vector<std::string> forms = {"human", "json", "html", "junit", "github", "sarif"};
  for (const std::string& form : forms)
    arguments.insert(arguments.end(), {"--format", form + "=" + folder.path("out." + form)});
  const ProgramRun run = test::run(arguments);
  const std::string& told = record.told.empty() ? record.sentence : record.told;
  for (const std::string& form : forms) {
    const std::string text = plainText(contentOf(folder.path("out." + form)));
    EXPECT_NE(text.find(told), std::string::npos) << form << " does not say: " << told << "\n" << text << run.err;
  }
}

INSTANTIATE_TEST_SUITE_P(Records, RecordIn, testing::ValuesIn(records()));

}  // namespace
}  // namespace rungproof::test
