// Programs without networks: those that nobody can run.
#include <algorithm>
#include <vector>

#include "analysis/unread/unread_code.hpp"
#include "ir/s7200/call_contract.hpp"
#include "ir/s7300/statement_role.hpp"

namespace rungproof {

namespace {

/// Leaves the labels, where jumps from elsewhere may end, and begins a new logic string, as the network may have done:
/// what would go on with its own depends on it.
void leaveOut(Network& network) {
  Instruction set;
  set.desc = setRloStatement();
  set.span = network.instructions.empty() ? Span{network.span.file, network.span.offset, 0}
                                          : network.instructions.front().mnemonic();
  set.mnemonicLength = set.span.length;
  std::erase_if(network.instructions, [](const Instruction& each) { return each.desc->control != Control::LabelMark; });
  network.instructions.push_back(std::move(set));
  network.drawing = nullptr;
}

}  // namespace

Program UnreadCode::without(std::span<const NetworkPlace> networks) const {
  Program program = program_;
  for (const NetworkPlace place : networks) {
    Network& network = program.pous[place.block].networks[place.network];
    if (statements_ != nullptr)
      leaveOut(network);
    else
      network.instructions.clear();
  }
  for (Pou& pou : program.pous) {
    for (Network& network : pou.networks) {
      for (Instruction& instruction : network.instructions) {
        const CallContract* contract = facts_->contracts().of(instruction);
        if (contract == nullptr) continue;
        instruction.operands[0].kind = OperandKind::Symbol;
        instruction.operands[0].text = contract->name;
      }
    }
  }
  program.number();
  return program;
}

Program UnreadCode::executable() const {
  std::vector<NetworkPlace> networks;
  for (const UnreadPart& part : parts_) networks.insert(networks.end(), part.networks.begin(), part.networks.end());
  for (std::uint32_t block = 0; statements_ != nullptr && block < program_.pous.size(); ++block) {
    for (std::uint32_t n = 0; n < program_.pous[block].networks.size(); ++n) {
      if (causeAt(NetworkPlace{block, n}) != Influence::none) networks.push_back({block, n});
    }
  }
  return without(networks);
}

}  // namespace rungproof
