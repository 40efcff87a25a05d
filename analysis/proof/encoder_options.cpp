// What of the options of a proof the encoder is told.
#include "analysis/proof/prover.hpp"

namespace rungproof {

EncoderOptions encoderOptionsOf(const ProverOptions& options, bool relaxed) {
  EncoderOptions result;
  result.followsContracts = true;
  result.choices = options.choices;
  result.retentive = options.retentive;
  result.time = options.time;
  result.time.relaxed = relaxed;
  return result;
}

}  // namespace rungproof
