// The blocks of random S7-300/400 programs: their declarations, and statements of the generator in them.
#include "tests/naive7/program_generator.hpp"

namespace naive7 {

std::string ProgramGenerator::fc1() {
  text_.clear();
  locals_ = {{"#b", "#q", "#tb"}, {"#a", "#y", "#z", "#tw"}, {"#td"}};
  for (const char* s : {"L 0", "T #td", "T #tw", "CLR", "= #tb", "L #a", "T #y", "A #b", "= #q"}) say(s);
  // The inputs are only read, so the body writes results and temporary data.
  locals_ = {{"#tb"}, {"#tw", "#z"}, {"#td"}};
  body(1 + static_cast<int>(below(2)));
  say("L #a");
  say("L #z");
  say("+I");
  say("T #y");
  say("A #b");
  say("AN #tb");
  say("= #q");
  if (chance(40)) {
    say("BEC");
    say("INC 3");
  }
  if (chance(40)) say("CALL FC 4 ( p := " + pick({"#y", "#z", "#q"}) + " )");
  locals_ = {};
  return "FUNCTION FC 1 : VOID\nVAR_INPUT\n  a : INT ;\n  b : BOOL ;\nEND_VAR\nVAR_OUTPUT\n  y : INT ;\n  q : BOOL ;\n"
         "END_VAR\nVAR_IN_OUT\n  z : INT ;\nEND_VAR\nVAR_TEMP\n  tb : BOOL ;\n  tw : WORD ;\n  td : DWORD ;\nEND_VAR\n"
         "BEGIN\nNETWORK\n" +
         text_ + "END_FUNCTION\n";
}

std::string ProgramGenerator::fc2() {
  text_.clear();
  body(1 + static_cast<int>(below(3)));
  if (chance(50)) {
    const std::string label = newLabel();
    scan();
    say("JC " + label);
    say(pick({"BE", "BEU"}));
    say(label + ": NEGI");
  }
  return "FUNCTION FC 2 : VOID\nBEGIN\nNETWORK\n" + text_ + "END_FUNCTION\n";
}

std::string ProgramGenerator::fc3() {
  text_.clear();
  say("L #t");
  say("L #c");
  say("+I");
  say("T #y");
  say("A #t");
  say("A #c");
  say("= M 5.5");
  say("R " + pick({"#t", "#c"}));
  if (chance(40)) say("CALL FC 6 ( p := " + pick({"#t", "#c"}) + " )");
  return "FUNCTION FC 3 : VOID\nVAR_INPUT\n  t : TIMER ;\n  c : COUNTER ;\nEND_VAR\nVAR_OUTPUT\n  y : INT ;\nEND_VAR\n"
         "BEGIN\nNETWORK\n" +
         text_ + "END_FUNCTION\n";
}

std::string ProgramGenerator::fb1() {
  text_.clear();
  say("L 0");
  say("T #w");
  say("A #x");
  say("FP #e");
  say("= #q");
  const std::string label = newLabel();
  say("A #q");
  say("JCN " + label);
  say("L #s");
  say("L #n");
  say(pick({"+I", "-I", "*I"}));
  say("T #s");
  say(label + ": L #s");
  say("T #m");
  // Words and bits of the instance; the registers that reach the instance stay alone.
  for (int i = 0; i < 2; ++i) {
    say(pick({"A ", "ON ", "X "}) + pick({"#x", "#q", "#e", "M 4.4"}));
    say(pick({"= ", "S ", "R "}) + pick({"#q", "#e", "M 4.5"}));
    say("L " + pick({"#n", "#s", "#m", "#w"}));
    say("T " + pick({"#m", "#w", "#s"}));
  }
  return "FUNCTION_BLOCK FB 1\nVAR_INPUT\n  x : BOOL ;\n  n : INT ;\nEND_VAR\nVAR_OUTPUT\n  q : BOOL ;\n  m : INT "
         ";\nEND_VAR\n"
         "VAR\n  e : BOOL ;\n  s : INT ;\nEND_VAR\nVAR_TEMP\n  w : INT ;\nEND_VAR\nBEGIN\nNETWORK\n" +
         text_ + "END_FUNCTION_BLOCK\n";
}

std::string ProgramGenerator::fb2() {
  text_.clear();
  say("CALL #p ( x := I 0.3 , n := #k , m := #o )");
  say("L #o");
  say("T #last");
  say("CALL #r ( x := M 4.0 , q := M 4.1 , m := MW 26 )");
  if (chance(50)) say("CALL #p ( x := M 4.1 )");
  return "FUNCTION_BLOCK FB 2\nVAR_INPUT\n  k : INT ;\nEND_VAR\nVAR_OUTPUT\n  o : INT ;\nEND_VAR\nVAR\n  p : FB 1 ;\n"
         "  last : INT ;\n  r : FB 1 ;\nEND_VAR\nBEGIN\nNETWORK\n" +
         text_ + "END_FUNCTION_BLOCK\n";
}

/// Of an organization block.
void ProgramGenerator::ownRegisters() {
  // Every register has a value before it is used.
  for (const char* s : {"CLR", "SAVE", "L 0", "T LD 20", "T LD 24", "T LD 28", "T LD 32", "T LD 36", "T LD 40", "L 0",
                        "+I", "JOS p1", "p1: OPN DB 1", "OPN DI 2", "LAR1 P#1.0", "LAR2 P#2.0", "L 1", "L 2"}) {
    say(s);
  }
  if (choices_.is400) {
    say("ENT");
    say("ENT");
  }
}

std::string ProgramGenerator::ob1() {
  text_.clear();
  isOb1_ = mayCall_ = true;
  ownRegisters();
  const int wrong =
      choices_.errors && chance(12) ? static_cast<int>(below(static_cast<std::uint32_t>(choices_.snippets))) : -1;
  for (int i = 0; i < choices_.snippets; ++i) {
    if (i == wrong) {
      const std::string label = newLabel();  // the error comes only in some scans
      say("A I 3.7");
      say("A I 3.6");
      say("JCN " + label);
      error();
      say(label + ": NOP 0");
    }
    snippet(0);
  }
  isOb1_ = mayCall_ = false;
  for (const char* s : {"T MD 200", "TAK", "T MD 204", "L STW", "T MW 208", "TAR1 MD 212", "TAR2 MD 216", "L DBNO",
                        "T MW 220", "L DINO", "T MW 222"}) {
    say(s);
  }
  if (choices_.is400) {
    for (const char* s : {"LEAVE", "TAK", "T MD 224", "LEAVE", "TAK", "T MD 228"}) say(s);
  }
  return "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n  start : ARRAY [0 .. 19] OF BYTE ;\n  own : ARRAY [0 .. 23] OF BYTE ;\n"
         "END_VAR\nBEGIN\nNETWORK\n" +
         text_ + "END_ORGANIZATION_BLOCK\n";
}

/// A block that interrupts: its registers have values of its own before they are used.
std::string ProgramGenerator::interruptBlock(int number) {
  text_.clear();
  isOb1_ = mayCall_ = true;
  ownRegisters();
  for (int i = 1 + static_cast<int>(below(3)); i > 0; --i) snippet(0);
  isOb1_ = mayCall_ = false;
  return "ORGANIZATION_BLOCK OB " + std::to_string(number) +
         "\nVAR_TEMP\n  start : ARRAY [0 .. 19] OF BYTE ;\n  own : ARRAY [0 .. 23] OF BYTE "
         ";\nEND_VAR\nBEGIN\nNETWORK\n" +
         text_ + "END_ORGANIZATION_BLOCK\n";
}

/// The source with marks in front of some of its statements, but not within the list of a JL.
std::string ProgramGenerator::interrupted(const std::string& source, const std::vector<std::string>& marks) {
  std::string result;
  bool isBody = false;
  std::string listEnd;  // the label behind the list of a JL
  for (std::size_t at = 0; at < source.size();) {
    const std::size_t end = source.find('\n', at) + 1;
    const std::string line = source.substr(at, end - at);
    at = end;
    if (line == "NETWORK\n") isBody = true;
    if (line.starts_with("END_")) isBody = false;
    const bool isListed = !listEnd.empty();
    if (isListed && line.starts_with("  " + listEnd + ":")) listEnd.clear();
    if (const std::size_t list = line.find(" JL "); list != std::string::npos)
      listEnd = line.substr(list + 4, line.find(' ', list + 4) - list - 4);
    if (isBody && line.starts_with("  ") && !isListed && chance(4)) result += "  " + pick(marks) + " ;\n";
    result += line;
  }
  return result;
}

std::string ProgramGenerator::program() {
  std::string sources =
      "DATA_BLOCK DB 1\nSTRUCT\n  b : ARRAY [0 .. 99] OF BYTE ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n"
      "DATA_BLOCK DB 2\nSTRUCT\n  b : ARRAY [0 .. 19] OF BYTE ;\nEND_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n";
  sources += fb1() + fb2() + fb3();
  for (const char* number : {"3\nFB 1", "4\nFB 2", "5\nFB 3"})
    sources += std::string("DATA_BLOCK DB ") + number + "\nBEGIN\nEND_DATA_BLOCK\n";
  sources += fc1() + fc2() + fc3() + fc4() + fc5() + fc6() + ob1();
  if (!choices_.interrupts) return sources;
  const std::uint32_t which = below(3);  // OB35, OB40, both; OB40 has the higher priority and interrupts OB35
  std::vector<std::string> marks;
  if (which != 1) marks.emplace_back("BLD 235");
  if (which != 0) marks.emplace_back("BLD 240");
  sources = interrupted(sources, marks);
  if (which != 1) sources += which == 0 ? interruptBlock(35) : interrupted(interruptBlock(35), {"BLD 240"});
  return which == 0 ? sources : sources + interruptBlock(40);
}

}  // namespace naive7
