// Which networks and instructions of two programs stand for each other. Equal networks are found first, wherever they
// stand; then those in between that share most of their instructions. Layout, comments, titles, network numbers and
// symbol names do not count. Used to give the same moment inside a scan to both programs, and to say what a change has
// changed. Tested by tests/equivalence/network_match_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/equivalence/address_pairs.hpp"
#include "ir/program.hpp"

namespace rungproof {

struct NetworkRef {
  std::size_t pou = 0;
  std::size_t network = 0;
  friend bool operator==(const NetworkRef&, const NetworkRef&) = default;
};

/// A network of OLD, of NEW, or of both.
struct NetworkPair {
  std::optional<NetworkRef> before, after;
  bool isSame = false;  ///< the same instructions
};

struct ProgramMatch {
  /// In the order of NEW; what only OLD has stands behind what it followed there.
  std::vector<NetworkPair> networks;
  /// By Instruction::id of NEW: the instruction of OLD that stands for it, or noPartner (flow.hpp).
  std::vector<std::uint32_t> beforeOf;
};

ProgramMatch matchPrograms(const Program& before, const Program& after, const AddressPairs& pairs = {});

/// The instruction as it would be written in OLD: "A I0.0". An address without partner there is marked.
std::string textInOld(const Instruction& after, const AddressPairs& pairs);

}  // namespace rungproof
