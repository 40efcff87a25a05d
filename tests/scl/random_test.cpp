// Random expressions and statements in SCL against the interpreter of naive_scl.hpp, which says their meaning a second
// time. RUNGPROOF_SCL_PROGRAMS sets how many programs of 100 expressions; the seed of each one is printed where it
// fails.
#include <cstdlib>

#include "tests/scl/naive_scl.hpp"
#include "tests/scl/scl_run.hpp"

namespace rungproof {
namespace {

using testscl::lastRow;
using testscl::mainOf;
using testscl::NaiveScl;
using testscl::NaiveType;

int programs() {
  const char* const wanted = std::getenv("RUNGPROOF_SCL_PROGRAMS");
  return wanted != nullptr ? std::atoi(wanted) : 100;
}

std::string literal(NaiveType type, std::int64_t value) {
  if (type == NaiveType::Bool) return value != 0 ? "TRUE" : "FALSE";
  return type == NaiveType::DInt ? "DINT#" + std::to_string(value) : std::to_string(value);
}

// Each expression equals its value and differs from another one.
TEST(SclRandom, Expressions) {
  constexpr int each = 100;
  constexpr NaiveType types[] = {NaiveType::Int, NaiveType::DInt, NaiveType::Bool, NaiveType::Word};
  for (int seed = 1; seed <= programs(); ++seed) {
    NaiveScl naive(static_cast<std::uint64_t>(seed));
    naive.randomState();
    std::string body = naive.initial() + "#good := 0; #wrong := 0;\n";
    for (int i = 0; i < each; ++i) {
      const NaiveType type = types[i % 4];
      std::int64_t value = 0;
      const std::string text = naive.expression(type, 4, value);
      const std::int64_t other = type == NaiveType::Bool ? 1 - value : value ^ 1;
      body += "IF " + text + " = " + literal(type, value) + " THEN #good := #good + 1; END_IF;\n";
      body += "IF " + text + " = " + literal(type, other) + " THEN #wrong := #wrong + 1; END_IF;\n";
    }
    body += "MW20 := #good; MW22 := #wrong;\n";
    ASSERT_EQ(lastRow(mainOf(body, NaiveScl::declarations()), "MW20,MW22"), "1," + std::to_string(each) + ",0")
        << "seed " << seed << "\n"
        << body;
  }
}

TEST(SclRandom, Statements) {
  for (int seed = 1; seed <= programs(); ++seed) {
    NaiveScl naive(static_cast<std::uint64_t>(seed) * 7919);
    naive.randomState();
    std::string body = naive.initial();
    body += naive.program(25);
    body += naive.comparison() + "MW20 := #good;\n";
    ASSERT_EQ(lastRow(mainOf(body, NaiveScl::declarations()), "MW20"), "1," + std::to_string(NaiveScl::compared))
        << "seed " << seed << "\n"
        << body;
  }
}

}  // namespace
}  // namespace rungproof
