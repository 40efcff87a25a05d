// What is remembered of a shape is what drawing each network anew says: over the corpus, and where the addresses of a
// network decide.
#include "analysis/drawing/picture_shapes.hpp"

#include <gtest/gtest.h>

#include "analysis/drawing/raise.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/rules/lint.hpp"

namespace rungproof {
namespace {

/// By drawing it.
bool isDrawn(const Network& network, const Target& target) {
  return raise(network, Form::Ladder, target).drawing || raise(network, Form::Fbd, target).drawing;
}

TEST(PictureShapes, SayOfTheCorpusWhatDrawingEachNetworkSays) {
  std::size_t networks = 0, drawn = 0, shapes = 0;
  for (const std::filesystem::path& file : test::corpusFiles()) {
    const Program program = test::corpusInput(file).program;
    if (program.syntax != nullptr) continue;  // its drawings stand in the file
    PictureShapes own(program.target);
    for (const Pou& pou : program.pous) {
      for (const Network& network : pou.networks) {
        const bool isPicture = isDrawn(network, program.target);
        EXPECT_EQ(own.canBeDrawn(network), isPicture) << file << ", " << pou.name << ", network " << network.number;
        EXPECT_EQ(own.canBeDrawn(network), isPicture) << "asked again";
        ++networks;
        drawn += isPicture ? 1 : 0;
      }
    }
    shapes += own.size();
  }
  EXPECT_GT(drawn, networks / 2);
  EXPECT_LT(drawn, networks);
  EXPECT_LT(shapes, networks) << "no shape was met twice";
}

/// One set of shapes asked about all these networks, in this order.
std::vector<bool> picturesOf(const std::vector<std::string>& networks) {
  std::string text = "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n";
  for (std::size_t i = 0; i < networks.size(); ++i) text += "Network " + std::to_string(i + 1) + "\n" + networks[i];
  const Program program = readText("shapes.awl", text + "END_ORGANIZATION_BLOCK\n");
  PictureShapes shapes(program.target);
  std::vector<bool> answers;
  for (const Network& network : program.pous.at(0).networks) {
    answers.push_back(shapes.canBeDrawn(network));
    EXPECT_EQ(answers.back(), isDrawn(network, program.target)) << network.number;
    if (answers.back()) continue;
    const Raised fbd = raise(network, Form::Fbd, program.target);
    EXPECT_EQ(shapes.refusalOf(network).reason, fbd.reason) << network.number;
    EXPECT_EQ(shapes.refusalOf(network).at, fbd.at) << network.number;
  }
  return answers;
}

TEST(PictureShapes, OneShapeWithOtherAddresses) {
  EXPECT_EQ(picturesOf({"LD I0.0\n= Q0.0\n", "LD M3.1\n= V7.2\n", "LD I0.0\n= Q0.0\nLD I0.1\n= Q0.1\n",
                        "LD M0.0\n= M0.0\nLD M0.0\n= M0.0\n"}),
            (std::vector<bool>{true, true, false, false}));
}

// The second branch reads its contact in front of the first coil, the picture behind it: the same only if the coil
// does not write that contact. Each is asked in front of and behind the other.
TEST(PictureShapes, AddressesDecideWhereACoilStandsBetween) {
  const std::string apart = "LD I0.0\nLPS\nA I0.1\n= Q0.0\nLPP\nA I0.2\n= Q0.1\n";
  const std::string own = "LD I0.0\nLPS\nA I0.1\n= Q0.0\nLPP\nA Q0.0\n= Q0.1\n";
  const std::string late = "LD I0.0\nLD I0.1\n= Q0.0\nALD\n= Q0.1\n";
  const std::string lateOwn = "LD Q0.0\nLD I0.1\n= Q0.0\nALD\n= Q0.1\n";
  picturesOf({apart, own, apart, late, lateOwn, late, lateOwn, late});
  picturesOf({own, apart, own, lateOwn, late, lateOwn});
}

// The same contacts and boxes, but the editor's own bits hold the flow inputs of a call.
TEST(PictureShapes, LocalMemoryAndCallsAreDrawnOneByOne) {
  picturesOf({"LD I0.0\n= L60.0\nLD L60.0\nCALL SBR0\n", "LD I0.0\n= M60.0\nLD M60.0\nCALL SBR0\n",
              "LD I0.0\n= L60.0\nLD L60.0\n= Q0.0\n", "LD I0.0\n= L0.0\nLD L0.0\n= Q0.0\n"});
}

}  // namespace
}  // namespace rungproof
