// Subroutines with parameters against the same code written out: values go in and come back by copy (001:6782), and
// each call has its own local memory, but an edge or a timer inside is one for all calls.
#include "tests/equivalence/pair.hpp"

namespace rungproof::test {
namespace {

struct ParameterPair {
  const char* name;
  const char* calls;  ///< networks of MAIN that call the starter, as in Pair
  const char* inlined;
  Equality truth;
  const char* why;
  const char* body = "LD #START;O #ON;AN #STOP;= #ON";
};

std::string withBlock(const std::string& networks, const std::string& body) {
  std::string text = exportOf(networks);
  return text +
         "SUBROUTINE_BLOCK STARTER:SBR0\nVAR_INPUT\nSTART:BOOL;\nSTOP:BOOL;\nEND_VAR\nVAR_IN_OUT\nON:BOOL;\nEND_VAR\n"
         "BEGIN\nNetwork 1\n" +
         lines(body) + "END_SUBROUTINE_BLOCK\n";
}

const ParameterPair parameterPairs[] = {
    {"one_call", "LD SM0.0;CALL SBR0, I0.0, I0.1, Q0.0", "LD I0.0;O Q0.0;AN I0.1;= Q0.0", Equality::Equal,
     "the copies are the operands themselves"},
    {"two_calls", "LD SM0.0;CALL SBR0, I0.0, I0.1, Q0.0;CALL SBR0, I0.2, I0.3, Q0.1",
     "LD I0.0;O Q0.0;AN I0.1;= Q0.0|LD I0.2;O Q0.1;AN I0.3;= Q0.1", Equality::Equal, "the calls share nothing"},
    {"parameters_swapped", "LD SM0.0;CALL SBR0, I0.1, I0.0, Q0.0", "LD I0.0;O Q0.0;AN I0.1;= Q0.0", Equality::Different,
     "start and stop are swapped"},
    {"conditional_call", "LD I0.7;CALL SBR0, I0.0, I0.1, Q0.0", "LD I0.0;O Q0.0;AN I0.1;= Q0.0", Equality::Different,
     "without the call the coil stays as it is"},
    {"conditional_code", "LD I0.7;CALL SBR0, I0.0, I0.1, Q0.0",
     "LD I0.0;O Q0.0;AN I0.1;A I0.7;LDN I0.7;A Q0.0;OLD;= Q0.0", Equality::Equal, "the coil keeps its state by itself"},
    {"chained", "LD SM0.0;CALL SBR0, I0.0, I0.1, Q0.0;CALL SBR0, Q0.0, I0.1, Q0.1",
     "LD I0.0;O Q0.0;AN I0.1;= Q0.0|LD Q0.0;O Q0.1;AN I0.1;= Q0.1", Equality::Equal,
     "the second call reads what the first one has written back"},
    {"same_output_twice", "LD SM0.0;CALL SBR0, I0.0, I0.1, Q0.0;CALL SBR0, I0.2, I0.3, Q0.0",
     "LD I0.0;O I0.2;O Q0.0;AN I0.1;AN I0.3;= Q0.0", Equality::Different,
     "the stop of the first call is undone by the start of the second"},
    {"shared_edge", "LD SM0.0;CALL SBR0, I0.0, I0.1, Q0.0;CALL SBR0, I0.2, I0.3, Q0.1",
     "LD I0.0;EU;O Q0.0;AN I0.1;= Q0.0|LD I0.2;EU;O Q0.1;AN I0.3;= Q0.1", Equality::Different,
     "the edge inside has one memory for both calls (001:2763)", "LD #START;EU;O #ON;AN #STOP;= #ON"},
};

TEST(Parameters, CallsAreWhatTheirCodeIs) {
  for (const ParameterPair& pair : parameterPairs) {
    SCOPED_TRACE(std::string(pair.name) + ": " + pair.why);
    const ProgramInput before = pairSide("old.awl", withBlock(pair.calls, pair.body), "");
    const ProgramInput after = pairSide("new.awl", exportOf(pair.inlined), "");
    EquivalenceOptions options;
    options.prover.timeout = 60;
    const Equivalence found =
        compareBehaviour({&before.program, before.properties}, {&after.program, after.properties}, options);
    EXPECT_EQ(equalityText(found.equality), equalityText(pair.truth));
    EXPECT_TRUE(found.disagreements.empty());
  }
}

}  // namespace
}  // namespace rungproof::test
