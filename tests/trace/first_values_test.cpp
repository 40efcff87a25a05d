// `sim --set`: values from the first scan on, beside a stimulus or without one.
#include "frontend/simulation/first_values.hpp"

#include "frontend/simulation/stimulus_reader.hpp"
#include "tests/engine/rig.hpp"

namespace rungproof {
namespace {

/// Values of Q0.0 at the ends of four scans under a stimulus and what is set before it.
std::string outputWith(const std::vector<std::string>& given, const std::string& stimulusText = "") {
  Rig rig("LD I0.0\nAW= VW100, -3\n= Q0.0\n");
  std::vector<Failure> failures;
  Stimulus stimulus;
  if (!stimulusText.empty()) stimulus = readStimulus("s.csv", stimulusText, rig.program, failures);
  setFirst(stimulus, given, rig.program, failures);
  for (const Failure& failure : failures) ADD_FAILURE() << failure.message;
  StimulusPlayer player(*rig.simulator, stimulus);
  std::string wave;
  for (int i = 0; i < 4; ++i) {
    rig.simulator->scan(player.next());
    wave += std::to_string(rig.get("Q0.0"));
  }
  return wave;
}

std::string mistakeOf(const std::string& given) {
  Rig rig("LD I0.0\n= Q0.0\n");
  std::vector<Failure> failures;
  Stimulus stimulus;
  setFirst(stimulus, std::vector<std::string>{given}, rig.program, failures);
  return failures.size() == 1 ? failures[0].message : std::to_string(failures.size()) + " mistakes";
}

TEST(FirstValues, HoldFromTheFirstScanOn) {
  EXPECT_EQ(outputWith({"I0.0=1", "VW100=-3"}), "1111");
  EXPECT_EQ(outputWith({"I0.0=1", "VW100=16#FFFD"}), "1111");
  EXPECT_EQ(outputWith({"VW100=-3"}), "0000");
}

TEST(FirstValues, AStimulusHasTheLastWord) {
  EXPECT_EQ(outputWith({"I0.0=1", "VW100=-3"}, "scan,I0.0\n1,0\n3,1\n"), "0011");
  EXPECT_EQ(outputWith({"VW100=-3", "I0.0=1"}, "time_ms,I0.0\n20,0\n"), "1100");
}

TEST(FirstValues, MistakesAreTold) {
  EXPECT_EQ(mistakeOf("I0.0"), "'I0.0' sets nothing");
  EXPECT_EQ(mistakeOf("=1"), "'=1' sets nothing");
  EXPECT_NE(mistakeOf("I0.0=2").find("I0.0 cannot be set"), std::string::npos);
  EXPECT_NE(mistakeOf("nothing=2").find("nothing"), std::string::npos);
}

}  // namespace
}  // namespace rungproof
