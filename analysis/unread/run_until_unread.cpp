// Networks that end a run: unread ones, and those that need data of which nobody knows what it holds.
#include "analysis/unread/run_until_unread.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rungproof {

RunUntilUnread::RunUntilUnread(const UnreadCode& unread) : unread_(unread) {
  const Facts& facts = unread.facts();
  if (facts.form() != StatementForm::Accumulators) {
    hindrance_ = unread.hindrance();
    if (hindrance_.empty()) program_ = unread.executable();
    return;
  }
  const std::span<const UnreadPart> parts = unread.parts();
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> whys;
  ofData_ = std::make_unique<StatementInfluence>(facts);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const UnreadPart& part = parts[i];
    const std::uint32_t cause = static_cast<std::uint32_t>(i) + 1;
    for (const NetworkPlace place : part.networks)
      whys.try_emplace({place.block, place.network}, fmt::format("it comes to what was not read: {}", part.reason));
    if (!part.networks.empty()) continue;
    if (part.isUnlimited && hindrance_.empty()) hindrance_ = unread.textOf(part);
    for (const PlaceRow& row : part.places) ofData_->addPlace(row, cause);
    for (const std::uint32_t number : part.dataBlocks) ofData_->addDataBlock(number, cause);
  }
  ofData_->spread();
  if (const std::uint32_t cause = ofData_->everything(); cause != Influence::none && hindrance_.empty())
    hindrance_ = unread.textOf(parts[cause - 1]);
  if (!hindrance_.empty()) return;

  const Program& program = facts.program();
  for (std::uint32_t block = 0; block < program.pous.size(); ++block) {
    for (std::uint32_t n = 0; n < program.pous[block].networks.size(); ++n) {
      const std::uint32_t cause = ofData_->causeAt(NetworkPlace{block, n});
      if (cause != Influence::none)
        whys.try_emplace({block, n}, fmt::format("what comes next needs it, and {}", unread.textOf(parts[cause - 1])));
    }
  }
  std::vector<NetworkPlace> networks;
  for (const auto& [place, why] : whys) networks.push_back({place.first, place.second});
  program_ = unread.without(networks);
  for (const auto& [place, why] : whys) {
    const Pou& pou = program_.pous[place.first];
    const Network& network = pou.networks[place.second];
    ends_.emplace(network.instructions.back().id, fmt::format("{}, network {}: {}", pou.name, network.number, why));
  }
}

RunUntilUnread::~RunUntilUnread() = default;

std::string RunUntilUnread::unknownAt(const Operand& place) const {
  if (ofData_ == nullptr) {
    const std::vector<std::string> reasons = unread_.reasons(place);
    return reasons.empty() ? std::string() : reasons.front();
  }
  if (place.kind != OperandKind::Direct) return {};
  const std::uint32_t cause = ofData_->causeAt(rowOf(place));
  return cause == Influence::none ? std::string() : unread_.textOf(unread_.parts()[cause - 1]);
}

}  // namespace rungproof
