// Integer arithmetic (001:4786-4936): order of the operands, halves of MUL and DIV, overflow and division by zero.
#include "example.hpp"

namespace rungproof::manual {

TEST(Integer, FirstOperandIsTheRightOne) {
  check({
      // Example 001:4843: AC1 = 4000, AC0 = 6000, VW10 = 20, VW100 = 2000 for +I, *I and /I.
      {"+I AC1, AC0", "AC1=4000 AC0=6000", "AC0=10000 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"*I AC1, VW100", "AC1=40 VW100=20", "VW100=800 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"/I VW10, VW200", "VW10=40 VW200=4000", "VW200=100 SM1.0=0 SM1.1=0 SM1.2=0 SM1.3=0"},
      {"-I VW0, VW2", "VW0=7 VW2=5", "VW2=-2 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"-I VW0, VW2", "VW0=5 VW2=5", "VW2=0 SM1.0=1 SM1.1=0 SM1.2=0"},
      {"/I VW0, VW2", "VW0=2 VW2=-7", "VW2=-3 SM1.0=0 SM1.1=0 SM1.2=1 SM1.3=0"},
      {"/I VW0, VW2", "VW0=8 VW2=7", "VW2=0 SM1.0=1 SM1.1=0 SM1.2=0 SM1.3=0"},
      {"+D VD0, VD4", "VD0=100000 VD4=-300000", "VD4=-200000 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"-D VD0, VD4", "VD0=-1 VD4=65535", "VD4=65536 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"*D VD0, VD4", "VD0=-70000 VD4=3", "VD4=-210000 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"/D VD0, VD4", "VD0=-1000 VD4=7000999", "VD4=-7000 SM1.0=0 SM1.1=0 SM1.2=1 SM1.3=0"},
  });
}

TEST(Integer, OverflowKeepsTheOperands) {
  check({
      {"+I VW0, VW2", "VW0=1 VW2=32767", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"-I VW0, VW2", "VW0=1 VW2=-32768", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"*I VW0, VW2", "VW0=256 VW2=128", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"*I VW0, VW2", "VW0=-256 VW2=128", "VW2=-32768 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"/I VW0, VW2", "VW0=-1 VW2=-32768", "SM1.0=? SM1.1=1 SM1.2=? SM1.3=0", "SM1.1"},
      {"+D VD0, VD4", "VD0=-1 VD4=-2147483648", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"-D VD0, VD4", "VD0=-1 VD4=2147483647", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"*D VD0, VD4", "VD0=65536 VD4=32768", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"/D VD0, VD4", "VD0=-1 VD4=-2147483648", "SM1.0=? SM1.1=1 SM1.2=? SM1.3=0", "SM1.1"},
  });
}

TEST(Integer, DivisionByZeroChangesOnlyItsOwnBit) {
  check({
      {"/I VW0, VW2", "VW2=5", "SM1.3=1", "SM1.3"},
      {"/D VD0, VD4", "VD4=5", "SM1.3=1", "SM1.3"},
      {"DIV VW0, VD4", "VD4=5", "SM1.3=1", "SM1.3"},
  });
}

TEST(Integer, MulTakesTheLowWordOfOut) {
  check({
      // Example 001:4929: AC1 = 400, VD100 with VW102 = 200: product 80000 = VW100 1, VW102 14464.
      {"MUL AC1, VD100", "AC1=400 VW100=-5 VW102=200", "VD100=80000 SM1.0=0 SM1.1=0 SM1.2=0 SM1.3=0"},
      {"MUL VW0, AC0", "VW0=-2 AC0=16#7777FFFF", "AC0=2 SM1.0=0 SM1.1=0 SM1.2=0 SM1.3=0"},
      {"MUL VW0, VD4", "VW0=-32768 VD4=32767", "VD4=-1073709056 SM1.0=0 SM1.1=0 SM1.2=1 SM1.3=0"},
      {"MUL VW0, VD4", "VW4=9 VW0=3", "VD4=0 SM1.0=1 SM1.1=0 SM1.2=0 SM1.3=0"},
  });
}

TEST(Integer, DivPutsTheRemainderIntoTheHighWord) {
  check({
      // Example 001:4934: VW10 = 41, VW202 = 4000: quotient 97, remainder 23.
      {"DIV VW10, VD200", "VW10=41 VW200=99 VW202=4000", "VW200=23 VW202=97 SM1.0=0 SM1.1=0 SM1.2=0 SM1.3=0"},
      {"DIV VW0, VD4", "VW0=2 VW6=-7", "VW4=-1 VW6=-3 SM1.0=0 SM1.1=0 SM1.2=1 SM1.3=0"},
      {"DIV VW0, VD4", "VW0=-2 VW6=7", "VW4=1 VW6=-3 SM1.0=0 SM1.1=0 SM1.2=0 SM1.3=0"},
      {"DIV VW0, VD4", "VW0=-2 VW6=7", "VW4=1 VW6=-3 SM1.0=0 SM1.1=0 SM1.2=1 SM1.3=0", "", "div-flags=quotient"},
      {"DIV VW0, VD4", "VW0=9 VW6=7", "VW4=7 VW6=0 SM1.0=1 SM1.1=0 SM1.2=0 SM1.3=0", "", "div-flags=quotient"},
      {"DIV VW0, VD4", "VW0=7 VD4=0", "SM1.0=1 SM1.1=0 SM1.2=0 SM1.3=0"},
      {"DIV VW0, VD4", "VW0=-1 VW6=-32768", "SM1.0=? SM1.1=1 SM1.2=? SM1.3=0", "SM1.1"},
      {"DIV VW0, AC0", "VW0=10 AC0=16#FFFF0019", "AC0=16#00050002 SM1.0=0 SM1.1=0 SM1.2=0 SM1.3=0"},
  });
}

}  // namespace rungproof::manual
