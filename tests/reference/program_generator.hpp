// Random programs for the comparison of engine and naive interpreter: a main program, one subroutine and an interrupt
// routine that no event starts, as a text export. Every mnemonic of STL that the naive interpreter knows can occur, but
// for those whose result depends on the moment within a scan (TODR, TODRX, BITIM, CITIM) or ends the program (STOP).
//
// Places: VB8-VB31, MB4-7, AC: bytes to double words; VD40-48: REAL, exact; VD52-VD76: REAL results that the manual
// leaves to rounding, read by nothing else; VW100: a table; VD140: a pointer; VB300, VB600, VB900: strings;
// VB1200-VB1250: characters; VD1260: a PID table.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace rungproof::reference {

class ProgramGenerator {
 public:
  explicit ProgramGenerator(std::uint64_t seed) : random_(seed) {}

  std::string program();

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
  std::string any(std::initializer_list<const char*> list) {
    return *(list.begin() + pick(static_cast<int>(list.size())));
  }
  std::string one(const std::vector<std::string>& list) {
    return list[static_cast<std::size_t>(pick(static_cast<int>(list.size())))];
  }

  std::string bit();
  std::string target();
  std::string byte(bool constant);
  std::string byteOut();
  std::string word(bool constant);
  std::string wordOut();
  std::string dword(bool constant);
  std::string dwordOut();
  std::string real();
  std::string realOut();
  std::string roundedOut();
  std::string text(bool constant);

  std::string start();
  std::string compare(const std::string& joint);
  std::string load();
  std::string box();
  std::string wordBox();
  std::string realBox();
  std::string conversion();
  std::string characterBox();
  std::string stringBox();
  std::string tableBox();
  std::string outsideBox();
  std::string rung();
  std::string loop();
  std::string jump(int n);
  std::string segment(int n);
  std::string counter(int n);
  std::string timer(int n);
  std::string pid();

  std::mt19937_64 random_;
};

}  // namespace rungproof::reference
