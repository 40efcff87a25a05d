// The set of mnemonics of each source of a project: what an option says, what the source's own words say, and where
// they say nothing, what the other sources are written in. Tested by tests/step7/likeness_test.cpp.
#pragma once

#include <string_view>
#include <vector>

#include "frontend/files/read_options.hpp"
#include "frontend/step7/constant_parser.hpp"

namespace rungproof::step7 {

class MnemonicVote {
 public:
  MnemonicVote(const std::vector<std::string_view>& texts, Mnemonics option);

  /// As many words of one set as of the other.
  bool isTied(std::size_t text) const { return ballots_[text] == Ballot::Tied; }
  MnemonicSet of(std::size_t text) const;
  MnemonicSet ofProject() const { return ofProject_; }

 private:
  enum class Ballot : std::uint8_t { Silent, International, German, Tied };
  std::vector<Ballot> ballots_;
  MnemonicSet ofProject_ = MnemonicSet::International;
};

}  // namespace rungproof::step7
