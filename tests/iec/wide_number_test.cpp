// Whole numbers of more than 32 bits, with and without a sign, beside REAL numbers in properties.
#include <gtest/gtest.h>

#include "tests/iec/iec_output.hpp"

namespace rungproof {
namespace {

TEST(IecWideNumbers, AreComparedWithRealNumbers) {
  // u, w, d and r are 5, l is 6: all of them are exact in a REAL.
  const IecOutput output = proofOfIec(
      "PROGRAM main VAR u : UDINT; l : LINT; w : DWORD; d : DINT; r : REAL; END_VAR\n"
      "//@ prove above: u > 4.5\n//@ prove same: u = r\n//@ prove half: u * 0.5 = 2.5\n//@ prove long: l > r\n"
      "//@ prove pattern: w > 4.5\n//@ prove less: r > d - 1\n//@ prove wrong: u > 5.5\n"
      "u := 5; l := 6; w := 16#5; d := 5; r := 5.0;\nEND_PROGRAM\n");
  for (const char* const name : {"above", "same", "half", "long", "pattern", "less"})
    EXPECT_TRUE(output.has(std::string("PROVED  ") + name)) << name << "\n" << output.text;
  EXPECT_TRUE(output.has("VIOLATED  wrong")) << output.text;
}

}  // namespace
}  // namespace rungproof
