// Calls with POINTER and ANY in random S7-300/400 programs: own blocks that look at the bytes and follow them, SFC 20
// and 21, FC 22, 25, 27 and 36. Sides of a copy do not overlap, and all of them exist.
#include "tests/naive7/program_generator.hpp"

namespace naive7 {

/// Statements that take the parameter `p` apart and use it: the bytes come out in MD 80 ff., the place changes.
static const char* const followed[] = {
    "L P##p", "LAR1",        "L W [AR1,P#0.0]", "T MW 80", "L W [AR1,P#2.0]", "T MW 82", "L W [AR1,P#4.0]",
    "T #n",   "OPN DB [#n]", "L D [AR1,P#6.0]", "LAR1",    "L B [AR1,P#0.0]", "T MB 84"};

std::string ProgramGenerator::fc4() {
  text_.clear();
  for (const char* s : followed) say(s);
  if (chance(60)) {
    say("INC 3");
    say("T B [AR1,P#0.0]");
  }
  if (chance(40)) say("S [AR1,P#0.5]");
  return "FUNCTION FC 4 : VOID\nVAR_INPUT\n  p : ANY ;\nEND_VAR\nVAR_TEMP\n  n : WORD ;\nEND_VAR\nBEGIN\nNETWORK\n" +
         text_ + "END_FUNCTION\n";
}

/// A POINTER, and the ANY of the caller handed on.
std::string ProgramGenerator::fc5() {
  text_.clear();
  for (const char* s : {"L P##q", "LAR1", "L W [AR1,P#0.0]", "T #n", "OPN DB [#n]", "L D [AR1,P#2.0]", "LAR1",
                        "A [AR1,P#0.0]", "= M 86.0"})
    say(s);
  if (chance(50)) say("CALL FC 4 ( p := #p )");
  return "FUNCTION FC 5 : VOID\nVAR_INPUT\n  p : ANY ;\n  q : POINTER ;\nEND_VAR\nVAR_TEMP\n  n : WORD ;\nEND_VAR\n"
         "BEGIN\nNETWORK\n" +
         text_ + "END_FUNCTION\n";
}

/// The ANY of a timer or a counter: its bytes.
std::string ProgramGenerator::fc6() {
  text_.clear();
  for (const char* s :
       {"L P##p", "LAR1", "L W [AR1,P#0.0]", "T MW 80", "L D [AR1,P#2.0]", "T MD 82", "L D [AR1,P#6.0]", "T MD 86"})
    say(s);
  return "FUNCTION FC 6 : VOID\nVAR_INPUT\n  p : ANY ;\nEND_VAR\nBEGIN\nNETWORK\n" + text_ + "END_FUNCTION\n";
}

std::string ProgramGenerator::fb3() {
  text_.clear();
  for (const char* s : followed) say(s);
  say("L #k");
  say("L #s");
  say("+I");
  say("T #s");
  if (chance(50)) say("CALL FC 4 ( p := " + pick({"#s", "#w", "P#M 6.0 BYTE 2"}) + " )");
  if (chance(50)) say("T MD 88");
  return "FUNCTION_BLOCK FB 3\nVAR_INPUT\n  k : INT ;\n  p : ANY ;\nEND_VAR\nVAR\n  s : INT ;\n  w : DWORD ;\nEND_VAR\n"
         "VAR_TEMP\n  n : WORD ;\nEND_VAR\nBEGIN\nNETWORK\n" +
         text_ + "END_FUNCTION_BLOCK\n";
}

/// After a call the registers that the description leaves open get values again.
void ProgramGenerator::registersAgain() {
  for (const char* s : {"OPN DB 1", "OPN DI 2", "LAR1 P#1.0", "LAR2 P#2.0", "L 5", "L 6"}) say(s);
  if (choices_.is400) {
    say("ENT");
    say("ENT");
  }
  say("CLR");
}

void ProgramGenerator::pointerCalls(std::uint32_t kind) {
  const std::string any =
      pick({"P#M " + number(40) + ".0 BYTE 4", "P#DB1.DBX " + number(40) + ".0 INT 2", "MW " + number(40),
            "P#Q " + number(4) + ".0 WORD 1", "DB2.DBD " + number(12), "LW 24", "M 3.0", "P#L 28.0 DINT 1",
            "DBW " + number(18), "DID " + number(16), "P#DBX " + number(16) + ".0 BYTE 2"});
  if (kind == 7 && choices_.timers && chance(30)) {
    say("CALL FC 6 ( p := " + pick({"T " + std::to_string(1 + below(5)), "C " + std::to_string(1 + below(2))}) + " )");
  } else if (kind == 7) {
    say("CALL FC 4 ( p := " + any + " )");
  } else if (kind == 8) {
    if (chance(50)) {
      say("CALL FC 5 ( p := " + pick({"P#M 8.0 BYTE 4", "DB1.DBW 6"}) +
          " , q := " + pick({"M 4.2", "P#M 5.0", "DB2.DBW 2", "P#DB1.DBX 7.1", "LD 24", "Q 1.2"}) + " )");
    } else {
      say("CALL FB 3 , DB 5 ( k := MW 12 , p := " + any + " )");
    }
  } else if (kind == 9) {
    const std::string from = pick({"P#M 0.0 BYTE " + std::to_string(1 + below(8)), "P#DB1.DBX 50.0 WORD 3", "MD 4",
                                   "P#I 0.0 BYTE 3", "LD 28", "P#DB2.DBX 4.0 BOOL 16"});
    const std::string to = pick({"P#M 20.0 BYTE " + std::to_string(1 + below(8)), "P#DB1.DBX 30.0 BYTE 6", "MW 24",
                                 "P#Q 2.0 DWORD 1", "P#DB2.DBX 10.0 INT 2", "LD 32"});
    if (chance(60))
      say("CALL SFC 20 ( SRCBLK := " + from + " , RET_VAL := MW 94 , DSTBLK := " + to + " )");
    else
      say("CALL SFC 21 ( BVAL := " + from + " , RET_VAL := MW 94 , BLK := " + to + " )");
  } else {
    const bool isLong = chance(40);
    const std::string type = isLong ? "DINT" : "INT";
    const auto value = [&] {
      return "P#" +
             pick({"M " + std::to_string(2 * below(20)) + ".0 ", "DB1.DBX " + std::to_string(2 * below(20)) + ".0 "}) +
             type + " 1";
    };
    const std::string out = " , RET_VAL := P#M 64.0 " + type + " 1 )";
    switch (below(4)) {
      case 0: say("CALL FC 22 ( MN := " + value() + " , IN := " + value() + " , MX := " + value() + out); break;
      case 1: say("CALL FC 25 ( IN1 := " + value() + " , IN2 := " + value() + " , IN3 := " + value() + out); break;
      case 2: say("CALL FC 27 ( IN1 := " + value() + " , IN2 := " + value() + " , IN3 := " + value() + out); break;
      default: say("CALL FC 36 ( G := M 2.3 , IN0 := " + value() + " , IN1 := " + value() + out);
    }
  }
  registersAgain();
  if (kind >= 9) {  // they leave the status bits open
    say("L 0");
    say("+I");
  }
}

}  // namespace naive7
