// Counting.
#include "frontend/step7/mnemonic_vote.hpp"

#include "frontend/step7/step7_likeness.hpp"

namespace rungproof::step7 {

MnemonicVote::MnemonicVote(const std::vector<std::string_view>& texts, Mnemonics option)
    : ballots_(texts.size(), Ballot::Silent) {
  if (option != Mnemonics::Auto) {
    ofProject_ = option == Mnemonics::German ? MnemonicSet::German : MnemonicSet::International;
    return;
  }
  int german = 0, international = 0;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Step7Likeness likeness = step7Likeness(texts[i]);
    german += likeness.german;
    international += likeness.international;
    if (likeness.german > likeness.international) ballots_[i] = Ballot::German;
    if (likeness.german < likeness.international) ballots_[i] = Ballot::International;
    if (likeness.german == likeness.international && likeness.german > 0) ballots_[i] = Ballot::Tied;
  }
  if (german > international) ofProject_ = MnemonicSet::German;
}

MnemonicSet MnemonicVote::of(std::size_t text) const {
  switch (ballots_[text]) {
    case Ballot::German: return MnemonicSet::German;
    case Ballot::International: return MnemonicSet::International;
    default: return ofProject_;
  }
}

}  // namespace rungproof::step7
