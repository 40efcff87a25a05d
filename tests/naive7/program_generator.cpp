// The statements of random S7-300/400 programs. Data lies in I 0-3, Q 0-7, M 0-63, DB1 and DB2 0-17, L 20-43 of OB1;
// MD 100 holds pointers, MW 120 ff. the counts of loops, MD 200 ff. the registers at the end of OB1.
#include "tests/naive7/program_generator.hpp"

namespace naive7 {

std::string ProgramGenerator::newLabel() {
  const std::string digits = std::to_string(1000 + ++labels_);
  return "m" + digits.substr(1);
}

std::string ProgramGenerator::bit(bool isWritten) {
  const std::string place = number(4) + "." + number(8);
  switch (below(isWritten ? 9 : 11)) {
    case 0: return "Q " + place;
    case 1: return "DBX " + number(18) + "." + number(8);
    case 2: return "DIX " + number(18) + "." + number(8);
    case 3: return isOb1_ ? "L " + std::to_string(20 + below(24)) + "." + number(8) : "M " + place;
    case 4: return "DB" + std::to_string(1 + below(2)) + ".DBX " + number(18) + "." + number(8);
    case 5:
    case 6: return locals_.bits.empty() ? "M " + place : pick(locals_.bits);
    case 7:
    case 8: return "M " + place;
    default: return "I " + place;
  }
}

std::string ProgramGenerator::byteOperand(bool isWritten) {
  switch (below(isWritten ? 4 : 6)) {
    case 0: return "QB " + number(8);
    case 1: return "DBB " + number(18);
    case 2: return "DIB " + number(18);
    case 3: return "MB " + number(64);
    case 4: return choices_.overlappingModules ? "PIB " + std::to_string(256 + below(4)) : "PIB 256";
    default: return "IB " + number(4);
  }
}

std::string ProgramGenerator::word(bool isWritten) {
  switch (below(isWritten ? 8 : 10)) {
    case 0: return "QW " + number(7);
    case 1: return "DBW " + number(17);
    case 2: return "DIW " + number(17);
    case 3: return isOb1_ ? "LW " + std::to_string(20 + below(23)) : "MW " + number(63);
    case 4: return "DB" + std::to_string(1 + below(2)) + ".DBW " + number(17);
    case 5: return isWritten ? "PQW " + std::to_string(256 + below(3)) : "MW " + number(63);
    case 6: return locals_.words.empty() ? "MW " + number(63) : pick(locals_.words);
    case 7: return "MW " + number(63);
    case 8: return choices_.overlappingModules ? "PIW " + std::to_string(256 + below(3)) : "PIW 258";
    default: return "IW " + number(3);
  }
}

std::string ProgramGenerator::doubleWord(bool isWritten) {
  switch (below(isWritten ? 7 : 8)) {
    case 0: return "QD " + number(5);
    case 1: return "DBD " + number(15);
    case 2: return "DID " + number(15);
    case 3: return isOb1_ ? "LD " + std::to_string(20 + below(21)) : "MD " + number(61);
    case 4: return "DB" + std::to_string(1 + below(2)) + ".DBD " + number(15);
    case 5: return locals_.doubles.empty() ? "MD " + number(61) : pick(locals_.doubles);
    case 6: return "MD " + number(61);
    default: return "ID 0";
  }
}

std::string ProgramGenerator::wordConstant() {
  switch (below(8)) {
    case 0: return pick({"0", "1", "-1", "2", "-2", "3"});
    case 1: return pick({"32767", "-32768", "-32767", "32766"});
    case 2: return std::to_string(static_cast<int>(below(2000)) - 1000);
    case 3: return "W#16#" + pick({"FFFF", "8000", "7FFF", "F999", "0FFF", "AAAA", "5555"});
    case 4: return "B#16#" + pick({"0", "1", "FF", "80", "10", "1F", "20"});
    case 5: return "C#" + number(1000);
    case 6: return "2#1010_0101";
    default: return std::to_string(static_cast<int>(below(65536)) - 32768);
  }
}

std::string ProgramGenerator::doubleConstant() {
  switch (below(7)) {
    case 0: return "L#" + pick({"0", "1", "-1", "2", "-2"});
    case 1: return "L#" + pick({"2147483647", "-2147483648", "-2147483647", "32768", "-32769"});
    case 2: return "DW#16#" + pick({"FFFFFFFF", "80000000", "7FFFFFFF", "F9999999", "0000FFFF", "00010000"});
    case 3: return "T#" + number(5000) + "MS";
    case 4: return "'" + pick({"abcd", "ab", "x"}) + "'";
    case 5: return "L#" + std::to_string(static_cast<int>(below(20000001)) - 10000000);
    default: return "L#" + std::to_string(static_cast<std::int32_t>(engine_() & 0xFFFFFFFF));
  }
}

std::string ProgramGenerator::realConstant() {
  switch (below(5)) {
    case 0: return pick({"0.0", "1.0", "-1.0", "0.5", "2.5", "-2.5", "3.5"});
    case 1: return pick({"3.0e+38", "-3.0e+38", "1.2e-38", "2147483648.0", "-2147483648.0", "1.0e+10"});
    case 2: return pick({"DW#16#7F800000", "DW#16#FF800000", "DW#16#7FC00000", "DW#16#80000000", "DW#16#00800000"});
    case 3: return std::to_string(static_cast<int>(below(2000)) - 1000) + ".25";
    default: return std::to_string(static_cast<int>(below(200)) - 100) + "." + number(1000);
  }
}

std::string ProgramGenerator::statusBit() {
  return pick({"==0", "<>0", ">0", "<0", ">=0", "<=0", "UO", "OS", "OV", "BR"});
}

void ProgramGenerator::loadAny() {
  switch (below(8)) {
    case 0: return say("L " + byteOperand(false));
    case 1:
    case 2: return say("L " + word(false));
    case 3:
    case 4: return say("L " + doubleWord(false));
    case 5: return say("L " + doubleConstant());
    case 6: return say("L " + pick({"T 1", "T 2", "T 3", "T 4", "T 5", "C 1", "C 2"}));
    default: return say("L " + wordConstant());
  }
}

void ProgramGenerator::scan() {
  const std::string op = pick({"A", "A", "A", "AN", "AN", "O", "O", "ON", "X", "XN"});
  const std::uint32_t kind = below(12);
  if (kind == 0) return say(op + " " + statusBit());
  if (kind == 1 && choices_.timers) return say(op + " T " + std::to_string(1 + below(5)));
  if (kind == 2) return say(op + " C " + std::to_string(1 + below(2)));
  say(op + " " + bit(false));
}

void ProgramGenerator::group(int depth) {
  const int count = 1 + static_cast<int>(below(3));
  for (int i = 0; i < count; ++i) {
    if (depth < 6 && chance(25)) {
      say(pick({"A(", "AN(", "O(", "ON(", "X(", "XN("}));
      if (chance(15)) {
        loadAny();
        loadAny();
        say(pick({"==I", "<>D", ">I", "<=D", ">=R"}));
      } else {
        group(depth + 1);
      }
      say(")");
    } else {
      scan();
    }
    if (chance(15)) say("O");
    if (chance(8)) say("NOT");
  }
}

void ProgramGenerator::logicString() {
  group(0);
  if (chance(25)) say(pick({"FP ", "FN "}) + bit(true));
  if (chance(10)) say("SAVE");
  const int ends = 1 + static_cast<int>(below(2));
  for (int i = 0; i < ends; ++i) say(pick({"= ", "= ", "= ", "S ", "R "}) + bit(true));
  if (chance(15)) say(pick({"SET", "CLR"}));
}

void ProgramGenerator::math() {
  loadAny();
  if (chance(70)) loadAny();
  switch (below(4)) {
    case 0: say(pick({"+I", "-I", "*I", "/I"})); break;
    case 1: say(pick({"+D", "-D", "*D", "/D", "MOD"})); break;
    case 2:
      say("+ " + (chance(50) ? std::to_string(static_cast<int>(below(65536)) - 32768) : "L#" + number(100000)));
      break;
    default: {
      const std::string op = pick({"AW", "OW", "XOW", "AD", "OD", "XOD"});
      const bool isWord = op.back() == 'W';
      say(chance(50) ? op : op + (isWord ? " W#16#0FF0" : " DW#16#00FFFF00"));
    }
  }
  say("T " + (chance(50) ? word(true) : doubleWord(true)));
}

void ProgramGenerator::comparison() {
  if (chance(70)) {
    loadAny();
    loadAny();
    say(pick({"==I", "<>I", ">I", ">=I", "<I", "<=I", "==D", "<>D", ">D", ">=D", "<D", "<=D"}));
  } else {
    say("L " + realConstant());
    say("L " + (chance(50) ? realConstant() : doubleWord(false)));
    say(pick({"==R", "<>R", ">R", ">=R", "<R", "<=R"}));
  }
  if (chance(30)) scan();
  say("= " + bit(true));
}

void ProgramGenerator::shiftOrConversion() {
  switch (below(4)) {
    case 0: {
      loadAny();
      const std::string op = pick({"SSI", "SLW", "SRW", "SSD", "SLD", "SRD", "RLD", "RRD"});
      const bool isWord = op == "SSI" || op == "SLW" || op == "SRW";
      say(op + " " + number(isWord ? 16 : 33));
      break;
    }
    case 1:
      say(chance(70) ? "L " + number(40) : "L " + byteOperand(false));
      loadAny();
      say(pick({"SSI", "SLW", "SRW", "SSD", "SLD", "SRD", "RLD", "RRD", "RLDA", "RRDA"}));
      break;
    case 2:
      if (chance(30)) {
        say("L C#" + number(1000));
        if (chance(50)) say("OW W#16#F000");
        say(pick({"BTI", "BTD"}));
      } else {
        loadAny();
        say(pick({"ITB", "DTB", "ITD", "DTR", "INVI", "INVD", "NEGI", "NEGD", "CAW", "CAD"}));
      }
      break;
    default: say("L " + realConstant()); say(pick({"RND", "TRUNC", "RND+", "RND-", "NEGR", "ABS"}));
  }
  say("T " + doubleWord(true));
}

void ProgramGenerator::realMath() {
  say("L " + realConstant());
  if (choices_.functions && chance(30)) {
    say(pick({"SQR", "SQRT", "EXP", "LN", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN"}));
  } else {
    say("L " + (chance(80) ? realConstant() : doubleWord(false)));
    say(pick({"+R", "-R", "*R", "/R"}));
    if (chance(20)) say(pick({"SQR", "SQRT", "RND", "TRUNC"}));
  }
  say("T " + doubleWord(true));
}

void ProgramGenerator::jump() {
  const std::string label = newLabel();
  if (chance(50)) {
    if (chance(50)) {
      scan();
    } else {
      loadAny();
      loadAny();
      say(pick({"-I", "+D", "==I", "XOD", "-R"}));
    }
  }
  say(pick({"JU", "JC", "JC", "JCN", "JCB", "JNB", "JBI", "JNBI", "JO", "JOS", "JZ", "JN", "JP", "JM", "JPZ", "JMZ",
            "JUO"}) +
      " " + label);
  snippet(4);
  say(label + ": NOP " + number(2));
}

void ProgramGenerator::distributor() {
  const std::string first = newLabel(), second = newLabel(), other = newLabel(), end = newLabel();
  say(chance(60) ? "L " + number(4) : "L " + byteOperand(false));
  say("JL " + other);
  say("JU " + first);
  say("JU " + second);
  say(other + ": INC 7");
  say("JU " + end);
  say(first + ": T " + word(true));
  say("JU " + end);
  say(second + ": NOT");
  say(end + ": BLD 130");
}

void ProgramGenerator::loop() {
  const std::string label = newLabel(), count = "MW " + std::to_string(120 + 2 * loops_++);
  say("L " + std::to_string(1 + below(4)));
  say(label + ": T " + count);
  snippet(5);
  say("L " + count);
  say("LOOP " + label);
}

void ProgramGenerator::timerOrCounter() {
  if (!choices_.timers || chance(40)) {
    const std::string counter = "C " + std::to_string(1 + below(2));
    scan();
    switch (below(6)) {
      case 0: say("L C#" + number(1000)); return say("S " + counter);
      case 1: return say("R " + counter);
      case 2: return say("FR " + counter);
      case 3: return say("CD " + counter);
      case 4: say("LC " + counter); return say("T " + word(true));
      default: return say("CU " + counter);
    }
  }
  const std::uint32_t n = below(5);
  const std::string timer = "T " + std::to_string(n + 1);
  scan();
  switch (below(8)) {
    case 0: return say("R " + timer);
    case 1: return say("FR " + timer);
    case 2: say("L " + timer); return say("T " + word(true));
    case 3: say("LC " + timer); return say("T " + word(true));
    default: break;
  }
  say("L S5T#" + pick({"0MS", "10MS", "20MS", "50MS", "100MS", "300MS", "12S", "2S"}));
  say(std::vector<std::string>{"SP ", "SE ", "SD ", "SS ", "SF "}[n] + timer);
}

void ProgramGenerator::pointers() {
  const std::string byte = number(40), bitNumber = number(8);
  const std::string reg = isOb1_ ? pick({"AR1", "AR2"}) : "AR1";
  const std::string load = "L" + reg;
  switch (below(9)) {
    case 0:
      say("L P#" + byte + "." + bitNumber);
      say("T MD 100");
      say(pick({"A", "ON", "X"}) + " M [MD 100]");
      return say(pick({"= ", "S ", "FP "}) + "M [MD 100]");
    case 1:
      say("L L#" + std::to_string(8 * below(50)));
      say("T MD 100");
      say("L " + pick({"MB", "MW", "MD"}) + " [MD 100]");
      return say("T " + pick({"MW", "MB"}) + " [MD 100]");
    case 2:
      say(load + " P#" + number(8) + "." + bitNumber);
      say("A " + pick({"M", "DBX", "DIX", "Q"}) + " [" + reg + ",P#" + number(3) + "." + number(8) + "]");
      return say("= " + pick({"M", "DBX", "DIX"}) + " [" + reg + ",P#" + number(3) + "." + number(8) + "]");
    case 3:
      say(load + " P#" + number(8) + ".0");
      say("L " + pick({"MW", "DBW", "DIB", "MD"}) + " [" + reg + ",P#" + number(4) + ".0]");
      say("+" + reg + " P#1.0");
      return say("T " + pick({"MW", "DBB", "DIW", "MD"}) + " [" + reg + ",P#" + number(4) + ".0]");
    case 4:
      say(load + " P#" + pick({"M", "DBX", "DIX", "Q"}) + " " + number(4) + ".0");
      say("L " + pick({"B", "W", "D"}) + " [" + reg + ",P#" + number(3) + ".0]");
      say("A [" + reg + ",P#" + number(3) + "." + number(8) + "]");
      say("= [" + reg + ",P#" + number(3) + "." + number(8) + "]");
      return say("T " + pick({"B", "W", "D"}) + " [" + reg + ",P#0.0]");
    case 5:
      say("L " + number(3));
      say("SLD 3");
      say(load);
      say("L " + std::to_string(8 * below(5)));
      say("+" + reg);
      return say("L MB [" + reg + ",P#2.0]");
    case 6: say("T" + reg); return say("T " + doubleWord(true));
    case 7:
      say("L " + std::to_string(1 + below(2)));
      say("T MW 104");
      say(pick({"OPN DB [MW 104]", "OPN DI [MW 104]", "A C [MW 104]", "L T [MW 104]"}));
      return;
    default:
      if (!isOb1_) return say("LAR1 P#M 1.0");
      say(pick({"CAR", "LAR1 AR2", "TAR1 AR2", "TAR1 MD 108", "TAR2 MD 108", "LAR1 P#4.3", "LAR2 P#DBX 2.0"}));
  }
}

void ProgramGenerator::dataBlocks() {
  say(pick({"OPN DB 1", "OPN DB 2", "OPN DI 1", "OPN DI 2", "CDB"}));
  if (chance(40)) {
    say("L " + pick({"DBNO", "DINO", "DBLG", "DILG"}));
    say("T " + word(true));
  }
}

void ProgramGenerator::accumulators() {
  const int count = 1 + static_cast<int>(below(3));
  for (int i = 0; i < count; ++i) {
    switch (below(choices_.is400 ? 7 : 5)) {
      case 0: say("INC " + number(256)); break;
      case 1: say("DEC " + number(256)); break;
      case 2: say("TAK"); break;
      case 3: say("PUSH"); break;
      case 4: say("POP"); break;
      case 5: say("ENT"); break;
      default: say("LEAVE");
    }
  }
  if (chance(60)) say("T " + doubleWord(true));
}

void ProgramGenerator::status() {
  switch (below(3)) {
    case 0: say("L STW"); return say("T " + word(true));
    case 1: say("L W#16#" + pick({"01FF", "0000", "0155", "00AA", "01B7", "0092"})); return say("T STW");
    default: return say(pick({"SET", "CLR", "NOT", "SAVE"}));
  }
}

void ProgramGenerator::relay() {
  say("MCRA");
  scan();
  say("MCR(");
  snippet(6);
  if (chance(30)) {
    scan();
    say("MCR(");
    snippet(6);
    say(")MCR");
  }
  say(")MCR");
  say("MCRD");
}

/// After a call the registers that the description leaves open get values again.
void ProgramGenerator::calls() {
  const std::uint32_t kind = below(11);
  if (kind > 6) return pointerCalls(kind);
  if (kind == 0) return say(pick({"UC FC 2", "CC FC 2", "CALL FC 2"}));
  if (kind == 1) {
    say("L 2");
    say("T MW 106");
    return say(pick({"UC", "CC"}) + " FC [MW 106]");
  }
  if (kind == 2) {
    const std::string word1 = pick({"MW 10", "QW 2", "DB1.DBW 4", "LW 24"}),
                      word2 = pick({"MW 10", "MW 12", "DB2.DBW 6"});
    say("CALL FC 1 ( a := " + (chance(20) ? std::to_string(static_cast<int>(below(200)) - 100) : word1) +
        " , b := " + pick({"M 1.0", "I 0.1", "TRUE"}) + " , y := " + word2 +
        " , z := " + pick({"MW 14", "QW 4", "MW 10"}) + " , q := " + pick({"M 1.0", "M 2.1", "DB1.DBX 0.0"}) + " )");
  } else if (kind == 3 && choices_.timers) {
    say("CALL FC 3 ( t := T " + std::to_string(1 + below(5)) + " , c := C " + std::to_string(1 + below(2)) +
        " , y := MW 16 )");
  } else if (kind == 4) {
    const std::string input = " , n := " + pick({"MW 10", "5", "DB1.DBW 8"});
    say("CALL FB 1 , DB 3 ( x := " + pick({"M 0.0", "I 0.0", "Q 1.1"}) + (chance(70) ? input : "") +
        " , q := M 3.0 , m := " + pick({"MW 20", "MW 10"}) + " )");
  } else {
    say("CALL FB 2 , DB 4 ( k := " + pick({"MW 22", "7", "IW 0"}) + " , o := MW 24 )");
  }
  registersAgain();
}

void ProgramGenerator::error() {
  switch (below(7)) {
    case 0: say("L DBB 100"); return;
    case 1: say("T DB9.DBW 0"); return;
    case 2: say("L W#16#0A00"); return say("BTI");
    case 3:
      say("L L#9");
      say("T MD 100");
      return say("L MW [MD 100]");
    case 4: return say("OPN DI 77");
    case 5: say("L 0"); return say("T DBD 98");
    default: say("LAR1 P#M 1.1"); return say("T W [AR1,P#0.0]");
  }
}

void ProgramGenerator::snippet(int depth) {
  const std::uint32_t kind = below(depth > 3 ? 48 : 64);
  if (kind < 16) return logicString();
  if (kind < 21) return math();
  if (kind < 24) return comparison();
  if (kind < 28) return shiftOrConversion();
  if (kind < 31) return realMath();
  if (kind < 37) return timerOrCounter();
  if (kind < 41) return pointers();
  if (kind < 43) return dataBlocks();
  if (kind < 46) return accumulators();
  if (kind < 48) return status();
  if (kind < 53) return jump();
  if (kind < 55) return distributor();
  if (kind < 57) return loop();
  if (kind < 59) return relay();
  if (mayCall_) return calls();
  logicString();
}

void ProgramGenerator::body(int count) {
  for (int i = 0; i < count; ++i) snippet(0);
}

}  // namespace naive7
