// From stack instructions to a drawing: the stack is followed symbolically, every level holds a wire. A network has a
// picture if it is one circuit (001:2230-2232), takes nothing from other networks, and its branches close as those of
// a ladder or of an FBD do; otherwise the reason is told, which is also what rule STK006 reports. The manual states
// few conditions; the rest is: a picture that is executed element by element does what the network does, and the
// picture can be written back without passing values through memory.
//
// Ladder: Contacts in series and Or; FBD: And and Or gates of at most 32 inputs (001:2268) on Contacts at the rail,
// NOT as negation circle. Tested by tests/drawing/raise_test.cpp and round_trip_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ir/drawing.hpp"
#include "ir/program.hpp"

namespace rungproof {

inline constexpr std::size_t maxGateInputs = 32;  ///< 001:2268, 001:2727

struct Raised {
  std::optional<Drawing> drawing;
  std::string reason;  ///< without a drawing: why, as one clause, "LD I0.1 begins a second rung in the network"
  const Instruction* at = nullptr;  ///< the instruction concerned
  /// What `reason` says behind nameInReason(*at), where it is no more than these two; otherwise empty.
  std::string_view clause = {};
  bool comparedAddresses = false;  ///< whether it depends on which addresses of the network overlap
};

/// "LD I0.1": mnemonic and first operand.
std::string nameInReason(const Instruction& instruction);

/// Draws a network of STL. `form`: Ladder or Fbd. Does not look at Network::drawing.
Raised raise(const Network& network, Form form, const Target& target = {});

/// The same circuit with gates in place of contacts in series and of joined branches; exists for every ladder. In
/// the elements `instruction` stays; a gate made from a contact has that of the contact.
Drawing asFbd(const Drawing& ladder);

}  // namespace rungproof
