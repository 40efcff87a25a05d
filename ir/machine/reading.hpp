// Readings of open points as part of the machine's state: Reg::Reading holds which value of each choice is in force. It
// never changes in a run. The engine sets it from the choices at power-up; in proofs it starts with any value unless
// the choice is fixed (Choices::isFixed), so that one run of the encoder covers all readings and a witness says which
// one it needs. Covered by tests/environment/readings_test.cpp.
#pragma once

#include "ir/dialect.hpp"
#include "ir/machine/register.hpp"

namespace rungproof {

/// Index in Reg::Reading of the bit that says that `value` (from 1) is the reading of a choice.
constexpr std::uint32_t readingIndex(Choice choice, std::uint8_t value) {
  return 2 * static_cast<std::uint32_t>(choice) + value - 1;
}
constexpr Choice choiceOfReading(std::uint32_t index) { return static_cast<Choice>(index / 2); }
constexpr std::uint8_t valueOfReading(std::uint32_t index) { return static_cast<std::uint8_t>(index % 2 + 1); }

/// The choices with what the CPU itself makes of those that nobody has made.
inline Choices choicesFor(const Target& target, Choices choices) {
  if (dialectOf(target).memory.samplesAtRead(target) && !choices.isChosen(Choice::AnalogSampling))
    choices.value[static_cast<std::size_t>(Choice::AnalogSampling)] =
        NamedReading(Choice::AnalogSampling, "each-read").value;
  return choices;
}

/// Puts the chosen readings in force in a state of the engine.
template <class Store>
void setReading(Store& store, Choice choice, std::uint8_t value) {
  for (std::uint8_t other = 1; other <= 2; ++other)
    store.set(Reg::Reading, readingIndex(choice, other), other == value ? 1 : 0, true);
}
template <class Store>
void setReadings(Store& store, const Choices& choices) {
  for (const ChoiceInfo& info : choiceTable) setReading(store, info.choice, choices[info.choice]);
}
/// The reading that is in force in a state of the engine, as an index into ChoiceInfo::values. Both bits on: the
/// second.
template <class Store>
std::uint8_t readingIn(const Store& store, Choice choice) {
  if (store.get(Reg::Reading, readingIndex(choice, 1)) != 0) return 1;
  const bool hasThird = !choiceInfo(choice).values[2].empty();
  return hasThird && store.get(Reg::Reading, readingIndex(choice, 2)) != 0 ? 2 : 0;
}

}  // namespace rungproof
