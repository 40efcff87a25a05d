// The encoder's options of an S7-300/400 program: nothing but the choices. A statement that an error ends leaves values
// from outside unread.
#include "tests/agreement7/encoder_run.hpp"

namespace rungproof::agreement7 {

AgreementOutcome compareWithEngine(const Program& program, std::uint64_t seed, int scans,
                                   const std::function<void(const Place&, std::uint64_t)>& seen,
                                   const Choices& choices) {
  AgreementQuestion question{.options = {}, .asked = {}, .usesAllExternals = false, .seen = seen};
  question.options.choices = choices;
  return compareScans(program, seed, scans, question);
}

}  // namespace rungproof::agreement7
