// Names for several choices at once: how a known implementation of IEC 61131-3 answers what the standard leaves open.
// What is not known of it stays open. Tested by tests/cli/choice_bundle_test.cpp.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace rungproof {

using ChosenValue = std::pair<std::string_view, std::string_view>;  ///< key and value of a choice

struct ChoiceBundle {
  std::string_view key, name;
  std::span<const ChosenValue> choices;
};

namespace bundle {
/// OpenPLC Editor and Beremiz translate by the same compiler.
inline constexpr ChosenValue compiledByMatiec[] = {{"iec-div-zero", "fault"},
                                                   {"iec-mod-zero", "zero"},
                                                   {"iec-round", "half-even"},
                                                   {"iec-counter-limit", "preset"},
                                                   {"iec-ctd-limit", "zero"},
                                                   {"iec-timer-start", "next-call"},
                                                   {"iec-short-circuit", "yes"},
                                                   {"iec-task-order", "declaration"},
                                                   {"iec-time-number", "seconds"},
                                                   {"iec-network-feedback", "sequential"},
                                                   {"iec-en-false-result", "zero"},
                                                   {"iec-sfc-order", "transitions-first"},
                                                   {"iec-sfc-initial-edge", "no"},
                                                   {"iec-sfc-final-scan", "no"},
                                                   {"iec-sfc-action-order", "declaration"},
                                                   {"iec-intermediate", "wide"},
                                                   {"iec-timer-preset", "live"},
                                                   {"iec-for-bounds", "each-pass"},
                                                   {"iec-fbd-order", "execution-id"},
                                                   {"iec-ld-flow", "per-coil"},
                                                   {"iec-phase", "zero"},
                                                   {"iec-address-unit", "distinct"},
                                                   {"iec-ftrig-first", "edge"},
                                                   {"iec-ctud-edges", "always"},
                                                   {"iec-sema", "direct"},
                                                   {"iec-limit-crossed", "lower"},
                                                   {"iec-sfc-selection", "all-true"},
                                                   {"iec-inout", "copy"},
                                                   {"iec-timer-clock", "scan"},
                                                   {"iec-timer-expiry", "at-preset"},
                                                   {"iec-timer-done", "holds"},
                                                   {"iec-mux-range", "zero"},
                                                   {"iec-to-bool", "nonzero"},
                                                   {"iec-subrange", "stored"},
                                                   {"iec-preemption", "none"},
                                                   {"iec-condition-blocks", "each-scan"}};
inline constexpr ChosenValue codesys[] = {{"iec-div-zero", "fault"},
                                          {"iec-mod-zero", "fault"},
                                          {"iec-counter-limit", "preset"},
                                          {"iec-short-circuit", "no"},
                                          {"iec-task-order", "priority"},
                                          {"iec-time-number", "milliseconds"},
                                          {"iec-network-feedback", "sequential"},
                                          {"iec-sfc-order", "actions-first"},
                                          {"iec-sfc-initial-edge", "yes"},
                                          {"iec-sfc-final-scan", "yes"},
                                          {"iec-sfc-action-order", "alphabetical"},
                                          {"iec-for-bounds", "each-pass"},
                                          {"iec-ld-flow", "once"},
                                          {"iec-ftrig-first", "edge"},
                                          {"iec-sfc-selection", "one"},
                                          {"iec-inout", "reference"},
                                          {"iec-timer-expiry", "at-preset"},
                                          {"iec-to-bool", "nonzero"},
                                          {"iec-subrange", "stored"},
                                          {"iec-hex-literal", "pattern"}};
}  // namespace bundle

inline constexpr std::array<ChoiceBundle, 3> choiceBundles = {{{"iec", "openplc", bundle::compiledByMatiec},
                                                               {"iec", "beremiz", bundle::compiledByMatiec},
                                                               {"iec", "codesys", bundle::codesys}}};

/// The values of a key that names bundles, for messages: "openplc, beremiz, codesys"; empty: it names none.
inline std::string bundlesOf(std::string_view key) {
  std::string names;
  for (const ChoiceBundle& one : choiceBundles) {
    if (one.key == key) names += (names.empty() ? "" : ", ") + std::string(one.name);
  }
  return names;
}

}  // namespace rungproof
