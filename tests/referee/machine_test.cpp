// The referee itself: what the manual says can happen does happen in some of its runs, and what cannot does not.
#include "machine.hpp"

#include <gtest/gtest.h>

#include "property.hpp"

namespace rungproof::referee {
namespace {

struct Example {
  const char* what;      ///< and the manual's place
  bool happens;          ///< in some run, within ten scans
  const char* property;  ///< a reach property
  const char* main;      ///< instructions, one after the other, parted by ;
  const char* routine;   ///< INT_0, or empty
};

const std::vector<Example>& examples() {
  static const std::vector<Example> list = {
      {"characters arrive in the buffer (000:1524)", true, "VB101 = 83 and VB100 >= 1",
       "LD SM0.1;MOVB 9,SMB30;MOVB 16#B0,SMB87;MOVB 3,SMB94;RCV VB100,0;LDB= VB101,83;= Q0.0", ""},
      {"no reception without freeport mode (001:3147)", false, "VB100 >= 1",
       "LD SM0.1;MOVB 16#B0,SMB87;MOVB 3,SMB94;RCV VB100,0;LDB= VB101,83;= Q0.0", ""},
      {"no more characters than SMB94 (001:3233)", false, "VB100 > 3",
       "LD SM0.1;MOVB 9,SMB30;MOVB 16#B0,SMB87;MOVB 3,SMB94;RCV VB100,0", ""},
      {"the start character is the first one (001:3255)", false, "VB100 >= 1 and VB101 <> 2",
       "LD SM0.1;MOVB 9,SMB30;MOVB 16#C0,SMB87;MOVB 2,SMB88;MOVB 3,SMB94;RCV VB100,0", ""},
      {"a reception without a condition for its start ends at once (001:3217)", true, "VB20 = 64",
       "LD SM0.1;MOVB 9,SMB30;MOVB 16#80,SMB87;MOVB 3,SMB94;RCV VB100,0;LD SM0.0;MOVB SMB86,VB20", ""},
      {"the end of a reception is event 23 (001:3202)", true, "MB1 = 1",
       "LD SM0.1;MOVB 9,SMB30;MOVB 16#B0,SMB87;MOVB 3,SMB94;ATCH INT_0,23;ENI;RCV VB100,0", "LD SM0.0;INCB MB1"},
      {"one RCV, one event 23 (001:3202)", false, "MB1 > 1",
       "LD SM0.1;MOVB 9,SMB30;MOVB 16#B0,SMB87;MOVB 3,SMB94;ATCH INT_0,23;ENI;RCV VB100,0", "LD SM0.0;INCB MB1"},
      {"no event 9 without XMT (001:3187)", false, "MB1 >= 1", "LD SM0.1;MOVB 9,SMB30;ATCH INT_0,9;ENI",
       "LD SM0.0;INCB MB1"},
      {"NETR without PPI master is error 5 (001:3058)", true, "VB200 = 37", "LD SM0.1;MOVB 2,VB206;NETR VB200,0", ""},
      {"NETR brings data (000:1113)", true, "V200.7 and VB207 = 9",
       "LD SM0.1;MOVB 2,SMB30;MOVB 2,VB206;NETR VB200,0;LDB= VB207,9;= Q0.0", ""},
      {"NETW does not write the data (000:1113)", false, "VB207 <> 0",
       "LD SM0.1;MOVB 2,SMB30;MOVB 2,VB206;NETW VB200,0", ""},
      {"events are queued under DISI (001:5372)", true, "MB2 >= 2",
       "LD SM0.1;ATCH INT_0,0;ENI;LD SM0.0;DISI;MOVB 0,MB1;ENI;MOVB MB1,MB2", "LD SM0.0;INCB MB1"},
      {"the queue of inputs holds 16 (001:5486)", false, "MB1 > 16", "LD SM0.1;ATCH INT_0,0;LD I0.1;DTCH 0;ENI",
       "LD SM0.0;INCB MB1"},
      {"the routine sees the overflow bit (001:5491)", true, "M0.0", "LD SM0.1;ATCH INT_0,0;LD I0.1;ENI",
       "LD SM4.1;S M0.0,1"},
      {"no routine before ENI (001:5333)", false, "MB1 >= 1", "LD SM0.1;ATCH INT_0,0", "LD SM0.0;INCB MB1"},
      {"entries of a detached event may stay (001:5357)", true, "MB1 = 1 and M0.0",
       "LD SM0.1;ATCH INT_0,0;LD I0.1;DTCH 0;S M0.0,1;ENI", "LD M0.0;INCB MB1"},
      {"a timed interrupt of 100 ms comes at most 5 times in 500 ms (001:5470)", false, "MB1 > 5 and first_scan",
       "LD SM0.1;MOVB 100,SMB34;ATCH INT_0,10;ENI", "LD SM0.0;INCB MB1"},
      {"T32 that is never on has no event (001:5476)", false, "MB1 >= 1",
       "LD SM0.1;ATCH INT_0,21;ENI;LDN SM0.0;TON T32,5", "LD SM0.0;INCB MB1"},
      {"event 21 at the preset of T32 (001:5476)", true, "MB1 = 1", "LD SM0.1;ATCH INT_0,21;ENI;LD SM0.0;TON T32,5",
       "LD SM0.0;INCB MB1"},
      {"the phase of the time base is free: 100 ms may be short (001:6592)", true, "T37 and MB1 <= 3",
       "LD SM0.0;INCB MB1;TON T37,1", ""},
      {"a timer does not count before its activation (001:6590)", false, "T37.value > 0 and rises(I0.0)",
       "LD I0.0;TON T37,10", ""},
      {"HC0 stays without HDEF (001:4308)", false, "HC0 <> 0", "LD SM0.1;MOVB 16#F8,SMB37;HSC 0", ""},
      {"HC0 counts past its preset (001:4184)", true, "HC0 = 3 and MB1 = 1",
       "LD SM0.1;MOVB 16#F8,SMB37;HDEF 0,0;MOVD 2,SMD42;ATCH INT_0,12;ENI;HSC 0", "LD SM0.0;INCB MB1"},
      {"the end of a pulse train is event 19 (001:4645)", true, "MB1 = 1",
       "LD SM0.1;MOVB 16#85,SMB67;MOVW 500,SMW68;MOVD 4,SMD72;ATCH INT_0,19;ENI;PLS 0", "LD SM0.0;INCB MB1"},
      {"the clock has BCD hours (001:2935)", false, "VB23 > 35 or VB23 = 10", "LD SM0.0;TODR VB20", ""},
      {"RUN after STOP: SM0.3 is 0 (001:14053)", true, "Q0.0", "LD SM0.1;AN SM0.3;= Q0.0", ""},
      {"SM0.1 is 0 in the second scan (001:14051)", false, "SM0.1 and not first_scan", "LD SM0.1;= Q0.0", ""},
      {"the system clears SM31.7 (001:1651)", true, "MB1 = 2", "LD I0.0;AN SM31.7;MOVB 16#81,SMB31;INCB MB1", ""},
      {"a fatal error has no scan end (001:13908)", false, "I0.0",
       "LD I0.0;MOVD 16#7FC00000,VD0;LDR= VD0,1.0;= M0.0;LD I0.0;= Q0.0", ""},
      {"STOP in a routine lets the scan finish (001:5695)", true, "M0.0 and Q0.0",
       "LD SM0.1;ATCH INT_0,0;ENI;LD SM0.0;= Q0.0", "LD SM0.0;S M0.0,1;STOP"},
      {"and no scan after it (001:5695)", false, "prev(M0.0) and not first_scan",
       "LD SM0.1;ATCH INT_0,0;ENI;LD SM0.0;= Q0.0", "LD SM0.0;S M0.0,1;STOP"},
  };
  return list;
}

std::string textOf(const Example& example) {
  const auto lines = [](std::string text) {
    for (char& c : text) c = c == ';' ? '\n' : c;
    return "BEGIN\nNetwork 1\n" + text + "\n";
  };
  std::string text = "ORGANIZATION_BLOCK MAIN:OB1\n" + lines(example.main) + "END_ORGANIZATION_BLOCK\n";
  if (*example.routine != '\0')
    text += "INTERRUPT_BLOCK INT_0:INT0\n" + lines(example.routine) + "END_INTERRUPT_BLOCK\n";
  return text;
}

TEST(RefereeMachine, DoesWhatTheManualSays) {
  for (const Example& example : examples()) {
    const Program program = programOf(textOf(example));
    Property property(std::string("reach it: ") + example.property);
    bool happened = false;
    for (std::uint64_t run = 1; run <= 1000 && !happened; ++run) {
      Machine machine(program, run, OpenPoints());
      property.reset();
      for (int scan = 0; scan < 10 && !happened && machine.scan(); ++scan) happened = property.hits(machine);
    }
    EXPECT_EQ(happened, example.happens) << example.what;
  }
}

// Scan ends of `LD SM0.0;INCB MB1`: MB1 is the number of the scan.
TEST(RefereeProperty, MeansWhatTheContractSays) {
  const std::vector<std::pair<std::string, int>> firstHits = {
      {"reach p: MB1 = 3", 3},
      {"prove p: never MB1 >= 4", 4},
      {"prove p: prev(MB1 = 2) implies MB1 <> 3", 3},
      {"prove p: MB1 >= 2 only after MB1 = 2", 0},
      {"prove p: MB1 >= 2 only after MB1 = 3", 2},
      {"prove p: MB1 <= 2 unless MB1 = 3", 0},
      {"prove p: MB1 <= 2 unless MB1 = 4", 3},
      {"reach p: rises(MB1 >= 1)", 0},
      {"reach p: falls(MB1 <= 1)", 2},
      {"prove p: not once(MB1 = 2) or MB1 = 2", 3},
      {"prove p: MB1 = 2 leads to MB1 = 4 within 2 scans", 0},
      {"prove p: MB1 = 2 leads to MB1 = 5 within 2 scans", 4},
      {"reach p: MB1 - 1 = 2 and not first_scan xor MB1 = 9", 3}};
  const Program program =
      programOf("ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.0\nINCB MB1\nEND_ORGANIZATION_BLOCK\n");
  for (const auto& [line, expected] : firstHits) {
    Property property(line);
    Machine machine(program, 1, OpenPoints());
    int hit = 0;
    for (int scan = 1; scan <= 6 && hit == 0 && machine.scan(); ++scan) hit = property.hits(machine) ? scan : 0;
    EXPECT_EQ(hit, expected) << line;
  }
}

}  // namespace
}  // namespace rungproof::referee
