// What a verdict rests on beside the program and its inputs: readings of open points (ir/machine/choices.hpp), and
// where the clocks stand when RUN begins. What was fixed is an assumption of the verdict; what a proof has left open it
// covers; of a run it is said under which of it the run shows what it shows. Covered by
// tests/environment/readings_test.cpp.
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

#include "analysis/encoding/encoder.hpp"
#include "analysis/witness/witness.hpp"

namespace rungproof {

struct Circumstances {
  std::vector<Choice> fixed;           ///< chosen by the user, or facts of the plant
  std::vector<Choice> open;            ///< covered in all their readings
  bool mayStop = false;                ///< STOP or a fatal error can end the run
  std::vector<std::string> anyValues;  ///< of devices: "HC1 = any value: ..."
};

/// Of a question that depends on those variables of the encoding, through any number of scans. Fixed readings are seen
/// in an encoding that covers them all the same (EncoderOptions::coversAllReadings).
Circumstances circumstancesOf(const EncodedScan& scan, const std::unordered_set<std::uint32_t>& variables);
/// Whether any question can depend on a device that has any value.
bool hasAnyValues(const EncodedScan& scan);
/// The fixed readings that some instruction of the program asks for.
std::vector<Choice> fixedReadingsOf(const EncodedScan& scan);

/// "inactive-scr = skipped", one text for each fixed choice; devices that give any value; what is not asked where the
/// CPU stops.
std::vector<std::string> assumptionsOf(const Circumstances& circumstances, const Choices& choices,
                                       const Target& target);

/// "under inactive-scr = skipped": the open readings without which the run would not show its goal, and where the
/// clocks start if not at 0. `judge`: tells what a changed run shows; nullptr: every reading that is not the default is
/// named.
std::vector<std::string> conditionsOf(const Circumstances& circumstances, const Witness& witness,
                                      const Program& program, const Choices& choices, const Judge* judge);

}  // namespace rungproof
