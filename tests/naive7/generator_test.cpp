// Random programs are legal: the naive interpreter knows every statement of them and they stop only where they are
// meant to.
#include <gtest/gtest.h>

#include "tests/naive7/machine.hpp"
#include "tests/naive7/program_generator.hpp"

namespace naive7 {
namespace {

TEST(Generator7, ProgramsAreLegal) {
  int stops = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    GeneratorChoices choices;
    choices.is400 = seed % 2 == 0;
    ProgramGenerator generator(seed, choices);
    const std::string text = generator.program();
    const Program program = readProgram(text);
    ASSERT_TRUE(program.errors.empty()) << program.errors[0];
    Machine machine(program, choices.is400);
    for (int scan = 0; scan < 10; ++scan) {
      machine.advance(generator.below(60));
      for (int i = 0; i < 4; ++i)
        machine.inputs[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(generator.below(256));
      try {
        machine.run("OB1");
      } catch (const Stop& stop) {
        ++stops;
        ASSERT_NE(stop.fault, 0xFF) << "seed " << seed << ": " << stop.text << "\n" << text;
        break;
      }
    }
  }
  EXPECT_GT(stops, 5);
  EXPECT_LT(stops, 120);
}

}  // namespace
}  // namespace naive7
