// INC and DEC (001:4999-5054): bytes unsigned, words and double words signed; a byte leaves SM1.2. On overflow SM1.1
// is certain; the result is a choice and the other two bits are open.
#include "example.hpp"

namespace rungproof::manual {

TEST(Increment, StepsByOneAndSetsItsFlags) {
  check({
      {"INCB VB0", "VB0=41", "VB0=42 SM1.0=0 SM1.1=0"},
      {"INCB VB0", "VB0=127", "VB0=128 SM1.0=0 SM1.1=0"},
      {"DECB VB0", "VB0=1", "VB0=0 SM1.0=1 SM1.1=0"},
      {"DECB VB0", "VB0=128", "VB0=127 SM1.0=0 SM1.1=0"},
      {"INCW VW0", "VW0=125", "VW0=126 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"INCW VW0", "VW0=-1", "VW0=0 SM1.0=1 SM1.1=0 SM1.2=0"},
      {"INCW VW0", "VW0=-32768", "VW0=-32767 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"DECW VW0", "VW0=0", "VW0=-1 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"DECW VW0", "VW0=1", "VW0=0 SM1.0=1 SM1.1=0 SM1.2=0"},
      {"DECW VW0", "VW0=32767", "VW0=32766 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"INCD VD0", "VD0=127999", "VD0=128000 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"INCD VD0", "VD0=-1", "VD0=0 SM1.0=1 SM1.1=0 SM1.2=0"},
      {"INCD VD0", "VD0=-65536", "VD0=-65535 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"DECD VD0", "VD0=128000", "VD0=127999 SM1.0=0 SM1.1=0 SM1.2=0"},  // example 001:5046
      {"DECD VD0", "VD0=0", "VD0=-1 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"DECD VD0", "VD0=1", "VD0=0 SM1.0=1 SM1.1=0 SM1.2=0"},
      {"INCB AC0", "AC0=16#11223344", "AC0=16#11223345 SM1.0=0 SM1.1=0"},
  });
}

TEST(Increment, OverflowWrapsByDefault) {
  check({
      {"INCB VB0", "VB0=255", "VB0=0 SM1.0=? SM1.1=1", "SM1.1"},
      {"DECB VB0", "VB0=0", "VB0=255 SM1.0=? SM1.1=1", "SM1.1"},
      {"INCW VW0", "VW0=32767", "VW0=-32768 SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"DECW VW0", "VW0=-32768", "VW0=32767 SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"INCD VD0", "VD0=2147483647", "VD0=-2147483648 SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"DECD VD0", "VD0=-2147483648", "VD0=2147483647 SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
  });
}

TEST(Increment, OverflowKeepsTheOperandByChoice) {
  check({
      {"INCB VB0", "VB0=255", "SM1.0=? SM1.1=1", "SM1.1", "increment-overflow=keeps"},
      {"DECB VB0", "VB0=0", "SM1.0=? SM1.1=1", "SM1.1", "increment-overflow=keeps"},
      {"INCW VW0", "VW0=32767", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1", "increment-overflow=keeps"},
      {"DECD VD0", "VD0=-2147483648", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1", "increment-overflow=keeps"},
      {"DECW VW0", "VW0=-32768", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1", "increment-overflow=keeps"},
      {"INCD VD0", "VD0=2147483647", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1", "increment-overflow=keeps"},
      {"INCW VW0", "VW0=5", "VW0=6 SM1.0=0 SM1.1=0 SM1.2=0", "", "increment-overflow=keeps"},
  });
}

}  // namespace rungproof::manual
