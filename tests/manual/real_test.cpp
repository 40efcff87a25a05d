// REAL arithmetic and functions (001:4786-4872, 001:4938-4995). Expected values are exact in single precision or the
// single nearest to the mathematical value.
#include "example.hpp"

namespace rungproof::manual {

TEST(Real, ArithmeticAndFlags) {
  check({
      {"+R VD0, VD4", "VD0=1.5 VD4=2.25", "VD4=3.75 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"+R VD0, VD4", "VD0=-1.5 VD4=1.5", "VD4=0.0 SM1.0=1 SM1.1=0 SM1.2=0"},
      {"+R VD0, VD4", "VD0=-4.0 VD4=1.5", "VD4=-2.5 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"+R 1.0, VD4", "VD4=100000000.0", "VD4=100000000.0 SM1.0=0 SM1.1=0 SM1.2=0"},  // 001:1410
      {"-R VD0, VD4", "VD0=1.5 VD4=2.25", "VD4=0.75 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"-R VD0, VD4", "VD0=3.5 VD4=2.25", "VD4=-1.25 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"-R VD0, VD0", "VD0=3.5", "VD0=0.0 SM1.0=1 SM1.1=0 SM1.2=0"},
      {"*R VD0, VD4", "VD0=-1.5 VD4=2.5", "VD4=-3.75 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"*R VD0, VD4", "VD4=2.5", "VD4=0.0 SM1.0=1 SM1.1=0 SM1.2=0"},
      {"*R AC0, AC1", "AC0=-2.0 AC1=-8.0", "AC1=16.0 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"/R VD0, VD4", "VD0=4.0 VD4=10.0", "VD4=2.5 SM1.0=0 SM1.1=0 SM1.2=0 SM1.3=0"},
      {"/R VD0, VD4", "VD0=-4.0 VD4=10.0", "VD4=-2.5 SM1.0=0 SM1.1=0 SM1.2=1 SM1.3=0"},
      {"/R VD0, VD4", "VD0=3.0 VD4=0.0", "VD4=0.0 SM1.0=1 SM1.1=0 SM1.2=0 SM1.3=0"},
  });
}

TEST(Real, DivisionByZeroLeavesTheOtherBits) {
  check({
      {"/R VD0, VD4", "VD4=10.0", "SM1.3=1", "SM1.3"},
      {"/R VD0, VD4", "VD0=-0.0 VD4=10.0", "SM1.3=1", "SM1.3"},
      {"/R VD0, VD4", "VD4=0.0", "SM1.3=1", "SM1.3"},
  });
}

TEST(Real, IllegalNumbersAndOverflowKeepTheOperands) {
  check({
      {"+R VD0, VD4", "VD0=3.0e38 VD4=3.0e38", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"-R VD0, VD4", "VD0=3.0e38 VD4=-3.0e38", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"*R VD0, VD4", "VD0=1.0e30 VD4=1.0e30", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"/R VD0, VD4", "VD0=1.0e-30 VD4=1.0e30", "SM1.0=? SM1.1=1 SM1.2=? SM1.3=0", "SM1.1"},
      {"+R VD0, VD4", "VD0=16#7FC00000 VD4=1.0", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},          // not a number
      {"*R VD0, VD4", "VD0=1.0 VD4=16#7F800000", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},          // infinite
      {"/R VD0, VD4", "VD0=16#7F800000 VD4=1.0", "SM1.0=? SM1.1=1 SM1.2=? SM1.3=0", "SM1.1"},  // would give a legal 0
      {"/R VD0, VD4", "VD0=16#7FC00000 VD4=1.0", "SM1.0=? SM1.1=1 SM1.2=? SM1.3=0", "SM1.1"},
  });
}

TEST(Real, Functions) {
  check({
      {"SQRT VD0, VD4", "VD0=6.25", "VD4=2.5 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"SQRT VD0, VD4", "VD4=7.0", "VD4=0.0 SM1.0=1 SM1.1=0 SM1.2=0"},
      {"SQRT VD0, VD4", "VD0=-1.0", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"SIN VD0, VD4", "VD4=7.0", "VD4=0.0 SM1.0=1 SM1.1=0 SM1.2=0"},
      {"SIN VD0, VD4", "VD0=-0.5", "VD4=-0.479425538604 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"SIN VD0, VD4", "VD0=1.5707963267949", "VD4=1.0 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"COS VD0, VD4", "", "VD4=1.0 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"COS VD0, VD4", "VD0=3.0", "VD4=-0.98999249660 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"COS VD0, VD4", "VD0=16#7F800000", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"TAN VD0, VD4", "VD0=0.5", "VD4=0.54630248984 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"TAN VD0, VD4", "VD0=-0.5", "VD4=-0.54630248984 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"TAN VD0, VD4", "VD0=16#7FC00000", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"LN VD0, VD4", "VD0=1.0", "VD4=0.0 SM1.0=1 SM1.1=0 SM1.2=0"},
      {"LN VD0, VD4", "VD0=0.5", "VD4=-0.69314718056 SM1.0=0 SM1.1=0 SM1.2=1"},
      {"LN VD0, VD4", "VD0=10.0", "VD4=2.30258509299 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"LN VD0, VD4", "", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"LN VD0, VD4", "VD0=-1.0", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
      {"EXP VD0, VD4", "VD0=1.0", "VD4=2.71828182846 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"EXP 0.0, VD4", "", "VD4=1.0 SM1.0=0 SM1.1=0 SM1.2=0"},
      {"EXP VD0, VD4", "VD0=100.0 VD4=5.0", "SM1.0=? SM1.1=1 SM1.2=?", "SM1.1"},
  });
}

}  // namespace rungproof::manual
