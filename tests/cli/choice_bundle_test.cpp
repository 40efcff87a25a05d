// Several choices by the name of an implementation. What each of them does is the facts' table of the family: OpenPLC
// and Beremiz count TIME in seconds, CODESYS in milliseconds; x MOD 0 is 0 there and a fault here.
#include "frontend/settings/choice_bundle.hpp"

#include <gtest/gtest.h>

#include "ir/machine/choices.hpp"
#include "tests/iec/iec_output.hpp"

namespace rungproof {
namespace {

TEST(ChoiceBundles, NameChoicesAndValuesThatThereAre) {
  for (const ChoiceBundle& one : choiceBundles) {
    Choices choices;
    for (const auto& [key, value] : one.choices) EXPECT_TRUE(choices.set(key, value)) << key << " " << value;
    EXPECT_FALSE(one.choices.empty());
  }
}

TEST(ChoiceBundles, DecideWhatIsOpen) {
  const std::string text =
      "//@ prove s: n <> 2500\nPROGRAM m\nVAR n : DINT; END_VAR\nn := TIME_TO_DINT(T#2500ms);\nEND_PROGRAM\n";
  EXPECT_TRUE(proofOfIec(text, {"--choice", "iec=openplc"}).has("PROVED  s"));
  EXPECT_TRUE(proofOfIec(text, {"--choice", "iec=beremiz"}).has("PROVED  s"));
  EXPECT_TRUE(proofOfIec(text, {"--choice", "iec=codesys"}).has("VIOLATED  s"));
  EXPECT_TRUE(proofOfIec(text).has("VIOLATED  s"));
}

TEST(ChoiceBundles, AWrongNameIsAnError) {
  const IecOutput output = proofOfIec("PROGRAM m\nEND_PROGRAM\n", {"--choice", "iec=twincat"});
  EXPECT_EQ(output.exit, 2);
  EXPECT_TRUE(output.has("openplc, beremiz, codesys")) << output.text;
}

}  // namespace
}  // namespace rungproof
