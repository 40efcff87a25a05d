// The page that an inspector signs, over programs of the corpus: one file without outside references, well-formed, all
// links lead somewhere, and everything that was examined and decided stands in it.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <pugixml.hpp>
#include <regex>
#include <set>

#include "frontend/files/sha256.hpp"
#include "page_run.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

/// Every element of the page.
void forEach(const pugi::xml_node& node, const std::function<void(const pugi::xml_node&)>& visit) {
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() == pugi::node_element) visit(child);
    forEach(child, visit);
  }
}

/// Faults of the page as such; empty: none.
std::string faultsOf(const std::string& page) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed =
      document.load_buffer(page.data(), page.size(), pugi::parse_default | pugi::parse_doctype);
  if (!parsed)
    return std::string("not well-formed: ") + parsed.description() + " at ..." +
           page.substr(static_cast<std::size_t>(parsed.offset), 80);
  std::string faults;
  std::set<std::string> places;
  std::vector<std::string> links;
  forEach(document, [&](const pugi::xml_node& node) {
    const std::string name = node.name();
    if (const auto id = node.attribute("id"); id && !places.insert(id.value()).second)
      faults += std::string("two places are called ") + id.value() + "\n";
    for (const char* attribute : {"href", "src"}) {
      const std::string link = node.attribute(attribute).value();
      if (link.starts_with("#"))
        links.push_back(link.substr(1));
      else if (!link.empty() && !link.starts_with("data:"))
        faults += "leads out of the page: " + link + "\n";
    }
    if (name == "link" || name == "iframe" || name == "img") faults += "outside reference: " + name + "\n";
  });
  for (const std::string& link : links) {
    if (!places.contains(link)) faults += "leads nowhere: #" + link + "\n";
  }
  return faults;
}

TEST(Faults, AreSeen) {
  EXPECT_NE(faultsOf("<html><p>a</html>"), "");
  EXPECT_NE(faultsOf("<html><a href=\"#b\">b</a></html>"), "");
  EXPECT_NE(faultsOf("<html><p id=\"a\"/><p id=\"a\"/></html>"), "");
  EXPECT_NE(faultsOf("<html><a href=\"run.csv\">b</a></html>"), "");
  EXPECT_EQ(faultsOf("<html><p id=\"a\"/><a href=\"#a\">b</a></html>"), "");
}

class PageTest : public testing::TestWithParam<const char*> {};

TEST_P(PageTest, IsOneWholeFileWhoseLinksLeadSomewhere) {
  const std::string page = pageOf({"prove", corpusFile(GetParam()), "--self-check"});
  EXPECT_EQ(faultsOf(page), "");
  EXPECT_NE(page.find(sha256(contentOf(corpusFile(GetParam())))), std::string::npos) << "the hash of the bytes";
  for (const char* part : {"What was examined", "Choices in force", "What this rests on", "Self-check", "Findings",
                           "Signatures", "Accepted by", "2023-11-14 22:13 UTC"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  const bool namesMachine = page.find("assumes: CPU ") != std::string::npos ||
                            page.find("assumes: program of IEC 61131-3") != std::string::npos;
  EXPECT_TRUE(namesMachine);
}

INSTANTIATE_TEST_SUITE_P(Corpus, PageTest,
                         testing::Values("interlocks/reversing_faulty.awl", "interlocks/star_delta.awl",
                                         "plcopen/press_two_hand_faulty.xml", "simaticml/tank_pump.xml",
                                         "simaticml/two_valves.xml"),
                         [](const auto& info) {
                           std::string name = info.param;
                           for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
                           return name;
                         });

TEST(Page, OfSeveralProgramsKeepsThemApart) {
  const std::string page =
      pageOf({"prove", corpusFile("interlocks/reversing.awl"), corpusFile("interlocks/reversing_faulty.awl")});
  EXPECT_EQ(faultsOf(page), "");
  for (const char* name : {"interlocks/reversing.awl", "interlocks/reversing_faulty.awl"})
    EXPECT_NE(page.find(sha256(contentOf(corpusFile(name)))), std::string::npos);
}

TEST(Page, OfTwoProgramsShowsBothInOneScan) {
  const std::string page = pageOf(
      {"equiv", corpusFile("interlocks/press_two_hand.awl"), corpusFile("interlocks/press_two_hand_faulty.awl")});
  EXPECT_EQ(faultsOf(page), "");
  EXPECT_EQ(countIn(page, "<div class=\"scan\">"), 1u);
  EXPECT_GT(countIn(page, "<figcaption>OLD MAIN"), 0u);
  EXPECT_GT(countIn(page, "<figcaption>NEW MAIN"), 0u);
}

TEST(Page, OfLintIsOneWholeFile) {
  const std::string page = pageOf({"lint", corpusFile("faulty/ranges.awl")});
  EXPECT_EQ(faultsOf(page), "");
  EXPECT_EQ(page.find("Signatures"), std::string::npos) << "nothing was decided that somebody could sign";
}

/// Row: number of cells before the one that holds the verdict.
TEST(Page, VerdictsOfGoalsHaveAColumnOfTheirOwn) {
  const std::string page = pageOf({"prove", corpusFile("interlocks/reversing_faulty.awl")});
  const auto columnOf = [&](const std::string& verdict) {
    const std::size_t at = page.find(">" + verdict + "<");
    const std::size_t cell = page.rfind("data-label=", at);
    return page.substr(cell, page.find('>', cell) - cell);
  };
  for (const char* verdict : {"REACHABLE", "UNREACHABLE"}) EXPECT_EQ(columnOf(verdict), "data-label=\"Goal\"");
  for (const char* verdict : {"VIOLATED", "PROVED"}) EXPECT_EQ(columnOf(verdict), "data-label=\"Requirement\"");
}

/// star_delta.awl: delta is reached in scan 20; no scan of the run may be missing on paper.
TEST(Page, HoldsEveryScanOfARun) {
  const std::string page = pageOf({"prove", corpusFile("interlocks/star_delta.awl"), "--only", "delta is reached"});
  std::set<int> scans;
  const std::regex heading("<h4>scans? ([0-9]+)(?: to ([0-9]+))?,");
  for (std::sregex_iterator i(page.begin(), page.end(), heading), end; i != end; ++i) {
    const int first = std::stoi((*i)[1]), last = (*i)[2].matched ? std::stoi((*i)[2]) : first;
    for (int scan = first; scan <= last; ++scan) scans.insert(scan);
  }
  ASSERT_FALSE(scans.empty());
  EXPECT_EQ(*scans.begin(), 1);
  EXPECT_EQ(static_cast<int>(scans.size()), *scans.rbegin()) << "a scan is missing";
  EXPECT_GE(*scans.rbegin(), 10) << "four seconds take more than ten scans of at most 500 ms: 8, the start and delta";
  EXPECT_NE(page.find("href=\"data:text/csv;base64,c2Nhbix0aW1lX21z"), std::string::npos) << "begins with scan,time_ms";
  EXPECT_NE(page.find("<figure class=\"wave\"><svg"), std::string::npos);
}

TEST(Page, DrawsFbdAsFbdAndLadderAsLadder) {
  const std::string fbd = pageOf({"prove", corpusFile("simaticml/tank_pump.xml")});
  const std::string ladder = pageOf({"prove", corpusFile("simaticml/motor.xml")});
  // A ladder stands between rails; an FBD has none.
  EXPECT_EQ(countIn(fbd, "class=\"rr"), 0u);
  EXPECT_GT(countIn(fbd, "class=\"rb"), 0u) << "boxes of gates";
  EXPECT_GT(countIn(ladder, "class=\"rr"), 0u);
}

TEST(Page, TellsRequirementsChoicesOptionsAndCertificates) {
  const TemporaryFolder folder;
  const std::string program =
      folder.file("press.awl",
                  "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1 // T\xFCr\nLD I0.0\nAN Q0.1\n= Q0.0\n"
                  "Network 2\nLD I0.1\nAN Q0.0\n= Q0.1\nEND_ORGANIZATION_BLOCK\n");
  const std::string symbols = folder.file("press.csv", "Left,Q0.0,contactor left\nRight,Q0.1,contactor right\n");
  const std::string properties = folder.file("press.prop",
                                             "# SR-1: one direction at a time.\n"
                                             "prove exclusive: never Left and Q0.1\n");
  folder.file("rungproof.toml", "scan-time = \"5ms..20ms\"\n[choices]\nfirst-edge = \"first-scan-only\"\n");
  int exit = -1;
  const std::string page =
      pageOf({"prove", program, symbols, "--props", properties, "--certificate", folder.path("proofs")}, &exit);
  EXPECT_EQ(exit, 0);
  EXPECT_EQ(faultsOf(page), "");
  const std::string certificate = contentOf(folder.path("proofs/exclusive.smt2"));
  ASSERT_FALSE(certificate.empty());
  EXPECT_NE(certificate.find("press.awl, SHA-256 " + sha256(contentOf(program))), std::string::npos)
      << "of the bytes, which are no UTF-8 here, and from whatever folder";
  for (const std::string& part :
       {std::string("SR-1: one direction at a time."),
        std::string("never Left <span class=\"also\">Q0.0</span> and Q0.1 "
                    "<span class=\"also\">Right</span>"),
        sha256(certificate), sha256(contentOf(program)), sha256(contentOf(properties)), sha256(contentOf(symbols)),
        sha256(contentOf(folder.path("rungproof.toml"))), std::string("<dt>scan-time</dt><dd>5ms..20ms"),
        std::string("first-edge = first-scan-only"), std::string("contactor left"),
        std::string("id=\"property-exclusive\""), std::string("href=\"#network-MAIN-1\""),
        std::string("id=\"network-MAIN-1\"")})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}

/// A program of contacts and coils depends on no open point; one with an edge, on what an edge sees first (001:2763).
TEST(Page, NamesTheChoicesThatAVerdictDependsOn) {
  const TemporaryFolder folder;
  const auto pageWith = [&](const std::string& contacts) {
    return pageOf({"prove", folder.file("p.awl",
                                        "ORGANIZATION_BLOCK MAIN:OB1\n//@ prove p: not Q0.0 or not Q0.1\nBEGIN\n"
                                        "Network 1\nLD I0.0\n" +
                                            contacts +
                                            "AN Q0.1\n= Q0.0\nNetwork 2\nLD I0.1\nAN Q0.0\n= Q0.1\n"
                                            "END_ORGANIZATION_BLOCK\n")});
  };
  const auto choicesIn = [](const std::string& page) {
    const std::size_t begin = page.find("id=\"Choices-in-force\"");
    return page.substr(begin, page.find("<h2", begin) - begin);
  };
  const std::string plain = choicesIn(pageWith(""));
  EXPECT_EQ(countIn(plain, "<tr>"), 0u) << plain;
  EXPECT_NE(plain.find("No verdict depends on one."), std::string::npos);
  const std::string all = pageOf({"prove", corpusFile("interlocks/star_delta.awl")});
  for (const char* foreign : {"s5-time", "iec-div-zero", "hot-restart"})
    EXPECT_EQ(choicesIn(all).find(foreign), std::string::npos) << foreign;
}

/// Height on A4 with the margins of the print style, 263 mm a page: a line of 9.5 points with its space is 5.5 mm, a
/// heading as high as two or three, a drawing as high as it says at 96 points an inch. An estimate without a browser.
double pagesOnPaper(const std::string& page) {
  double millimetres = 0;
  std::string text = page.substr(page.find("<body>"));
  for (std::size_t at = 0; (at = text.find("<svg", at)) != std::string::npos;) {
    const std::size_t height = text.find("height=\"", at) + 8, end = text.find("</svg>", at);
    millimetres += std::stod(text.substr(height)) * 25.4 / 96;
    text.erase(at, end - at);
  }
  for (const auto& [part, lines] : std::map<std::string, double>{{"<tr", 1},
                                                                 {"<p>", 1},
                                                                 {"<p ", 1},
                                                                 {"<li", 1},
                                                                 {"<dt", 1},
                                                                 {"<figcaption", 1},
                                                                 {"<pre", 1},
                                                                 {"<code", 1},
                                                                 {"<h2", 3},
                                                                 {"<h3", 2}})
    millimetres += 5.5 * lines * static_cast<double>(countIn(text, part));
  return millimetres / 263;
}

TEST(Page, OfFiftyProvedInstructionsTakesAtMostSixSheets) {
  std::string statements, networks;
  for (const char n : std::string("01234567")) {
    const std::string bit(1, n);
    statements += "//@ prove stop " + bit + ": never Q0." + bit + " and I0." + bit + "\n";
    networks += "Network " + std::to_string(n - '0' + 1) + " // drive " + bit + "\nLD I1." + bit + "\nO Q0." + bit +
                "\nAN I0." + bit + "\nA I2." + bit + "\nAN I3." + bit + "\n= Q0." + bit + "\n";
  }
  networks += "Network 9\nLD Q0.0\n= Q1.0\n";  // 8 times 6, and 2
  const TemporaryFolder folder;
  const std::string page =
      pageOf({"prove", folder.file("fifty.awl", "ORGANIZATION_BLOCK MAIN:OB1\n" + statements + "BEGIN\n" + networks +
                                                    "END_ORGANIZATION_BLOCK\n")});
  EXPECT_NE(page.find("50 of 50 instructions understood"), std::string::npos);
  EXPECT_EQ(countIn(page, ">PROVED</span></td>"), 8u);
  EXPECT_LE(pagesOnPaper(page), 6.0);
  EXPECT_GT(pagesOnPaper(page), 1.0) << "the estimate saw something";
}

/// What every verdict assumes stands before the verdicts, once.
TEST(Page, BeginsWithTheAssumptions) {
  const std::string page = pageOf({"prove", corpusFile("interlocks/reversing.awl")});
  const std::size_t assumed = page.find("assumes: CPU "), verdicts = page.find("id=\"Verdicts\"");
  ASSERT_NE(assumed, std::string::npos);
  EXPECT_LT(assumed, verdicts);
  EXPECT_EQ(countIn(page, "assumes: CPU "), 1u);
}

TEST(Page, SaysWhatLintFindsWithoutChangingTheExitCode) {
  const TemporaryFolder folder;
  const std::string program =
      folder.file("twice.awl",
                  "ORGANIZATION_BLOCK MAIN:OB1\n//@ prove p: I0.0 or not I0.0\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\n"
                  "Network 2\nLD I0.1\n= Q0.0\nEND_ORGANIZATION_BLOCK\n");
  int exit = -1;
  const std::string page = pageOf({"prove", program}, &exit);
  EXPECT_NE(page.find("[OUT001]"), std::string::npos) << "two coils of one output";
  EXPECT_NE(page.find("what they say changes no verdict"), std::string::npos);
  EXPECT_NE(exit, 2);
}

}  // namespace
}  // namespace rungproof::test
