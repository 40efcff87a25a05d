// Programs with counting words that are compared with each other: the engines on bits alone leave each of these
// properties open for ten seconds, the engine on words decides it within a limit of CPU time for the whole run of
// `prove`.
#include <gtest/gtest.h>

#include "tests/timing/measured_proof.hpp"

namespace rungproof {
namespace {

constexpr double mostForWords = 3;  ///< CPU seconds, check of the certificate included

struct WordProgram {
  const char* name;
  const char* property;
  const char* networks;
};

constexpr const char* queue = R"(Network 1
LD I0.0
EU
AW< VW4, 6
AW< VW0, 32000
INCW VW0
INCW VW4
Network 2
LD I0.1
EU
AW> VW4, 0
INCW VW2
DECW VW4
)";
constexpr const char* circuit = R"(Network 1
LD SM0.1
MOVW 100, VW0
Network 2
LD I0.0
AW> VW0, 0
DECW VW0
INCW VW2
Network 3
LD I0.1
AW> VW2, 0
DECW VW2
INCW VW4
Network 4
LD I0.2
AW> VW4, 0
DECW VW4
INCW VW0
)";
constexpr const char* sorting = R"(Network 1
LD I0.0
EU
AW< VW0, 30000
INCW VW0
A I0.1
INCW VW2
Network 2
LD I0.0
EU
AW< VW6, 30000
INCW VW6
AN I0.1
INCW VW4
)";
constexpr const char* lift = R"(Network 1
LDW>= AIW0, 0
AW<= AIW0, 4000
AN Q0.0
AN Q0.1
MOVW AIW0, VW2
Network 2
LD I0.0
EU
A Q0.0
INCW VW0
Network 3
LD I0.1
EU
A Q0.1
DECW VW0
Network 4
LDW< VW0, VW2
= Q0.0
LDW> VW0, VW2
= Q0.1
)";
constexpr const char* axis = R"(Network 1
LDD>= VD100, 0
AD<= VD100, 250000
AN Q0.0
AN Q0.1
MOVD VD100, VD4
Network 2
LD I0.0
EU
A Q0.0
INCD VD0
Network 3
LD I0.1
EU
A Q0.1
DECD VD0
Network 4
LDD< VD0, VD4
= Q0.0
LDD> VD0, VD4
= Q0.1
)";

constexpr WordProgram wordPrograms[] = {
    {"QueueLength", "never more than six: VW0 - VW2 <= 6", queue},
    {"QueueOrder", "none that was not there: VW2 <= VW0", queue},
    {"CircuitRanges", "each in range: VW0 >= 0 and VW0 <= 100 and VW2 >= 0 and VW4 >= 0", circuit},
    {"CircuitSecond", "second at most all: VW2 <= 100", circuit},
    {"SortingRest", "rest: VW0 - VW2 = VW4", sorting},
    {"SortingSum", "all sorted: VW2 + VW4 = VW6", sorting},
    {"LiftFloor", "floor: VW0 >= 0 and VW0 <= 4000", lift},
    {"AxisTravel", "travel: VD0 >= 0 and VD0 <= 250000", axis},
};

class WordPrograms : public ::testing::TestWithParam<WordProgram> {};

TEST_P(WordPrograms, DecidedWithinTheLimit) {
  const WordProgram& given = GetParam();
  const std::string program = std::string("ORGANIZATION_BLOCK MAIN:OB1\n//@ external VD100\n//@ prove ") +
                              given.property + "\nBEGIN\n" + given.networks + "END_ORGANIZATION_BLOCK\n";
  const MeasuredProof measured = measureProof(program, {"--timeout", "120s", "--jobs", "1"}, 3, mostForWords);
  ASSERT_EQ(measured.verdicts.size(), 1U);
  EXPECT_EQ(measured.verdicts.begin()->second, "PROVED");
  std::printf("%.3f s of %.3f s\n", measured.cpuSeconds, mostForWords);
  EXPECT_LE(measured.cpuSeconds, mostForWords);
}

INSTANTIATE_TEST_SUITE_P(Programs, WordPrograms, ::testing::ValuesIn(wordPrograms),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace rungproof
