// LIB001 to LIB003: blocks of libraries that run too seldom or too often, requests that are no pulses, memory that
// belongs to a library.
#include <gtest/gtest.h>

#include "analysis/flow/library_use.hpp"
#include "lint.hpp"

namespace rungproof::testing {
namespace {

const std::string slave = "CALL MBUS_SLAVE, M0.1, VB1000\n";
const std::string init = "CALL MBUS_INIT, 1, 1, 9600, 2, 0, 128, 32, 100, &VB0, M0.1, MB1\n";
const std::string skipped = "Network 1\nLD I0.0\nJMP 1\nNetwork 2\nLD SM0.0\n" + slave + "Network 3\nLBL 1\n";

/// A main program, and a subroutine SBR0 with that network.
std::string withRoutine(const std::string& condition, const std::string& network) {
  return "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\n" + condition +
         "CALL SBR0\nEND_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\n" + network +
         "END_SUBROUTINE_BLOCK\n";
}
/// As the editor writes a call: EN in L60.0, the first input in L63.7.
std::string prepared(const std::string& enable, const std::string& start, const std::string& call) {
  return enable + "= L60.0\n" + start + "= L63.7\nLD L60.0\n" + call;
}

std::string found(const char* rule, const std::string& text) {
  std::string result;
  for (const std::string& message : Linted(text).messages(rule)) result += (result.empty() ? "" : "\n") + message;
  return result;
}

TEST(Lib001, FindsBlocksThatRunTooSeldomOrTooOften) {
  const std::string seldom = "MBUS_SLAVE must run in every scan, but ";
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {"Network 1\nLD I0.0\n" + slave, seldom + "its condition may be 0"},
           {"Network 1\nLD SM0.0\nA I0.0\n" + slave, seldom + "its condition may be 0"},
           {"Network 1\nLD SM0.1\n" + slave, seldom + "it runs in the first scan only"},
           {"Network 1\nLD I0.0\nEU\n" + slave, seldom + "it runs in single scans only"},
           {skipped, seldom + "JMP 1 may leave it out"},
           {withRoutine("LD I0.0\n", "LD SM0.0\n" + slave), seldom + "SBR_0 is not called in every scan"},
           {"Network 1\n" +
                prepared("LD SM0.0\nA I0.3\n", "LD SM0.0\n", "CALL MBUS_CTRL, L63.7, 9600, 0, 0, 1000, M0.1, MB1\n"),
            "MBUS_CTRL must run in every scan, but its condition may be 0"},
           {"Network 1\nLD M0.0\nCALL AXIS0_CTRL, I0.0, M0.1, MB1, VD4, VD8, M0.2\n",
            "AXIS0_CTRL must run in every scan, but its condition may be 0"},
           {"Network 1\nLD SM0.0\n" + init, "MBUS_INIT runs in every scan; it is to run once"},
           {"Network 1\nLD SM0.0\nCALL DAT0_WRITE, VB0\n", "DAT0_WRITE runs in every scan; it is to run once"},
           {"Network 1\nLD SM0.0\n" + slave + slave,
            "MBUS_SLAVE is called a second time; it may stand once in a program"}})
    EXPECT_EQ(found("LIB001", text), message) << text;
}

TEST(Lib001, BlocksThatRunAsTheyMustAreSilent) {
  for (const std::string& text : std::vector<std::string>{
           "Network 1\nLD SM0.0\n" + slave, "Network 1\nLDN SM0.1\n" + slave,
           withRoutine("LD SM0.0\n", "LD SM0.0\n" + slave), "Network 1\nLD SM0.1\n" + init,
           "Network 1\nLD I0.0\nEU\n" + init,
           "Network 1\n" + prepared("LD SM0.0\n", "LD SM0.0\n", "CALL MBUS_CTRL, L63.7, 9600, 0, 0, 1000, M0.1, MB1\n"),
           withRoutine("LD I0.0\n", "LD SM0.0\n" + init),
           // One for each drive.
           "Network 1\nLD SM0.0\nCALL USS_CTRL, I0.0, I0.1, I0.2, I0.3, I0.4, 0, 1, 50.0, M0.0, VB0, VW2, VD4, M0.1, "
           "M0.2, "
           "M0.3, M0.4\nCALL USS_CTRL, I0.0, I0.1, I0.2, I0.3, I0.4, 1, 1, 50.0, M1.0, VB10, VW12, VD14, M1.1, M1.2, "
           "M1.3, "
           "M1.4\n",
           "Network 1\nLD I0.0\nCALL MYBLOCK, M0.1\n"})
    EXPECT_EQ(found("LIB001", text), "") << text;
  // A block of the user's that has such a name.
  EXPECT_EQ(found("LIB001",
                  "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nCALL SBR3\nEND_ORGANIZATION_BLOCK\n"
                  "SUBROUTINE_BLOCK MBUS_SLAVE:SBR3\nBEGIN\nNetwork 1\nLD SM0.0\n= Q0.0\nEND_SUBROUTINE_BLOCK\n"),
            "");
}

const std::string uss = "CALL USS_RPM_W, L63.7, 0, 3, 0, &VB100, M0.1, VB10, VW12\n";
const std::string message = "CALL MBUS_MSG, L63.7, 2, 0, 40001, 4, &VB200, M2.1, VB300\n";
std::string plain(const std::string& start) {
  return "LD SM0.0\nCALL USS_RPM_W, " + start + ", 0, 3, 0, &VB100, M0.1, VB10, VW12\n";
}

TEST(Lib002, FindsRequestsThatAreNoPulses) {
  for (const std::string& text : std::vector<std::string>{
           "Network 1\n" + prepared("LD SM0.0\n", "LD I0.0\n", uss), "Network 1\n" + plain("I0.0"),
           "Network 1\n" + plain("SM0.0"), "Network 1\n" + prepared("LD SM0.0\n", "LD SM0.5\n", message),
           "Network 1\n" + prepared("LD SM0.0\n", "LD T37\n", message) + "Network 2\nLD I0.0\nTON T37, 50\n",
           // On until Done comes: the Modbus master sends anew in each scan.
           "Network 1\n" + prepared("LD M5.0\n", "LD M5.0\n", message) +
               "Network 2\nLD I0.0\nS M5.0, 1\nNetwork 3\nLD M2.1\nR M5.0, 1\n",
           "Network 1\n" + prepared("LD SM0.0\n", "LD I0.0\nA I0.1\n", message),
           "Network 1\nLD I0.0\n= M3.0\nNetwork 2\n" + plain("M3.0"),
           "Network 1\nLD SM0.0\nCALL PTO0_RUN, I0.0, 1, I0.1, M0.1, VB0, VB1, VB2, VD4\n"}) {
    const std::string messages = found("LIB002", text);
    EXPECT_TRUE(messages.find("it sends a request in each scan") != std::string::npos &&
                messages.find('\n') == std::string::npos)
        << text << "\n"
        << messages;
  }
}

TEST(Lib002, FindsTwoRequestsThatOneSignalStarts) {
  const std::string pulse = "LD I0.0\nEU\n";
  const std::string both = "Network 1\n" + prepared("LD SM0.0\n", pulse, message) + "Network 2\n" +
                           prepared("LD SM0.0\n", pulse, "CALL MBUS_MSG, L63.7, 3, 0, 40001, 4, &VB220, M2.2, VB301\n");
  EXPECT_EQ(
      found("LIB002", both),
      "MBUS_MSG is started in the same scan as another request of MBUS_MSG: the Modbus master serves one at a time");
  // The second master has a port of its own; another signal starts the second request.
  EXPECT_EQ(
      found("LIB002", "Network 1\n" + prepared("LD SM0.0\n", pulse, message) + "Network 2\n" +
                          prepared("LD SM0.0\n", pulse, "CALL MB_MSG2, L63.7, 3, 0, 40001, 4, &VB220, M2.2, VB301\n")),
      "");
  EXPECT_EQ(found("LIB002", "Network 1\n" + prepared("LD SM0.0\n", pulse, message) + "Network 2\n" +
                                prepared("LD SM0.0\n", "LD M2.1\nEU\n", message)),
            "");
}

TEST(Lib002, PulsesAndHandshakesAreSilent) {
  for (const std::string& text : std::vector<std::string>{
           "Network 1\n" + prepared("LD SM0.0\n", "LD I0.0\nEU\n", uss),
           "Network 1\nLD I0.0\nEU\n= M3.0\nNetwork 2\n" + plain("M3.0"),
           "Network 1\n" + prepared("LD SM0.0\n", "LD SM0.1\n", message),
           "Network 1\nLD I0.0\nS M3.0, 1\nNetwork 2\n" + plain("M3.0") + "Network 3\nLD SM0.0\nR M3.0, 1\n",
           // A step that starts a profile and is left when it is done (001:8931).
           "Network 1\nLSCR S0.2\nNetwork 2\nLD SM0.0\nCALL PTO0_RUN, S0.2, 1, I0.1, M0.1, VB0, VB1, VB2, VD4\nNetwork "
           "3\n"
           "LD M0.1\nSCRT S0.3\nNetwork 4\nSCRE\n",
           // A start bit that Done takes back.
           "Network 1\nLD I0.0\nS M3.0, 1\nNetwork 2\nLD SM0.0\nCALL PTO0_RUN, M3.0, 1, I0.1, M0.1, VB0, VB1, VB2, "
           "VD4\n"
           "Network 3\nLD M0.1\nR M3.0, 1\n",
           "Network 1\n" + plain("V500.0"), "Network 1\nLD I0.0\nCALL MYBLOCK, I0.0\n"})
    EXPECT_EQ(found("LIB002", text), "") << text;
}

/// Messages of LIB003 where the settings give VB1000 to VB1099 to a library.
std::string owned(const std::string& networks) {
  Linted linted(networks);
  linted.program.libraryMemory.push_back({"MBUS_SLAVE", 1000, 1099});
  std::string result;
  for (const std::string& text : linted.messages("LIB003")) result += (result.empty() ? "" : "\n") + text;
  return result;
}

TEST(Lib003, FindsUsesOfLibraryMemory) {
  const std::string buffer = "Network 1\n" + plain("I0.0") + "Network 2\nLD I0.1\n";
  for (const auto& [text, part] : std::vector<std::pair<std::string, std::string>>{
           {"Network 1\nLD I0.0\nMOVW 1, VW1098\n",
            "MOVW 1, VW1098 writes VW1098, which lies in the memory of MBUS_SLAVE"},
           {"Network 1\nLD V1000.0\n= Q0.0\n", "LD V1000.0 reads V1000.0"},
           {"Network 1\nLD I0.0\nMOVD 1, VD997\n", "MOVD 1, VD997 writes VD997"},
           {"Network 1\nLD SM0.1\nCALL MBUS_INIT, 1, 1, 9600, 2, 0, 128, 32, 100, &VB900, M0.1, MB1\n",
            "100 holding registers from VB900 on of MBUS_INIT reach into VB1000 to VB1099 of MBUS_SLAVE (error 5)"},
           {buffer + "MOVW 1, VW114\n", "which lies in the memory of USS_RPM_W (VB100 to VB115)"},
           {buffer + "MOVB VB100, VB0\n", "MOVB VB100, VB0 reads VB100"},
           {buffer + "BMB VB0, VB90, 20\n", "BMB VB0, VB90, 20 writes VB90 to VB109"},
           {buffer + "LD V107.3\n= Q0.0\n", "LD V107.3 reads V107.3"},
           {"Network 1\n" + plain("I0.0") +
                "Network 2\nLD SM0.1\nCALL MBUS_INIT, 1, 1, 9600, 2, 0, 128, 32, 10, &VB90, M0.1, MB1\n",
            "10 holding registers from VB90 on of MBUS_INIT reach into VB100 to VB115 of USS_RPM_W (error 5)"},
           // 6000 words are 12000 bytes; V memory of a 226 ends at VB10239.
           {"Network 1\nLD SM0.1\nCALL MBUS_INIT, 1, 1, 9600, 2, 0, 128, 32, 6000, &VB2000, M0.1, MB1\n",
            "6000 holding registers from VB2000 on of MBUS_INIT reach beyond the end of V memory"}})
    EXPECT_NE(owned(text).find(part), std::string::npos) << text << "\n" << owned(text);
}

TEST(Lib003, OtherMemoryIsSilent) {
  const std::string buffer = "Network 1\n" + plain("I0.0") + "Network 2\nLD I0.1\n";
  for (const std::string& text : std::vector<std::string>{
           "Network 1\nLD I0.0\nMOVW 1, VW100\n", "Network 1\nLD I0.0\nMOVW 1, VW998\n",
           "Network 1\nLD V1100.0\n= Q0.0\n", buffer + "MOVW 1, MW104\n", buffer + "MOVW 1, VW116\n",
           buffer + "MOVW 1, VW98\n", buffer + "BMB VB0, VB80, 20\n",
           "Network 1\nLD SM0.1\nCALL MBUS_INIT, 1, 1, 9600, 2, 0, 128, 32, 100, &VB800, M0.1, MB1\n"})
    EXPECT_EQ(owned(text), "") << text;
}

}  // namespace
}  // namespace rungproof::testing
