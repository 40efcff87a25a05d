// Given values: what a script says about everything that the engine asks the world around the program for, handed out
// in the order in which a scan asks. Replay (engine/replay.hpp) and stimuli that give everything (engine/stimulus.hpp)
// run on it. Covered by tests/engine/replay_test.cpp.
#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "engine/concrete.hpp"
#include "ir/machine/choices.hpp"

namespace rungproof {

/// Value of an external site that the run reaches.
struct ExternalValue {
  ExternalSite site;
  std::uint64_t value;
};

/// The value of a site of which nothing is said: 0, but the clock shows what it shows after a loss of power (001:2918).
std::uint64_t quietExternal(const ExternalSite& site);

class GivenValues final : public Outside {
 public:
  explicit GivenValues(const Choices& choices) : unknown_(choices.is(Choice::UnknownBits, "one") ? ~0ULL : 0) {}

  /// Where reads of analog inputs that are not given look.
  void setState(const Concrete::Store& state) { state_ = &state; }
  /// The values of the scans to come, until others are loaded. Unknown bits that are all 0 need not be given.
  void load(const std::vector<ExternalValue>& values);
  /// Each scan starts with all of them.
  void begin();
  /// Whether unknown bits have other values than 0 in the scans to come.
  bool givesUnknownBits() const { return givesUnknownBits_; }
  std::uint64_t external(const ExternalSite& site, int width) override;
  void report(Hazard, const Instruction*) override {}
  /// Values that the run did not ask for.
  std::size_t unused() {
    finish();
    return unused_;
  }

 private:
  static bool isUnknown(External kind) {
    return kind == External::StackBottom || kind == External::LocalMemory || kind == External::UnknownStatus;
  }
  /// Where the engine reads 0 without a question as long as nothing else is given.
  static bool isOpen(External kind) { return isUnknown(kind) || kind == External::UnknownResult; }
  using Key = std::tuple<External, std::uint32_t, std::uint32_t>;
  static Key key(const ExternalSite& site) { return {site.kind, site.index, site.instruction}; }
  struct Site {
    Key key;
    std::vector<std::uint64_t> values;  ///< in the order in which they are asked for
    std::size_t next;
  };
  std::vector<Site>::iterator at(const Key& key);
  void finish();

  const Concrete::Store* state_ = nullptr;
  const std::uint64_t unknown_;
  std::vector<Site> sites_;  ///< by key
  std::size_t next_ = 0;     ///< where a scan looks next, mostly: it asks in this order
  bool isBegun_ = false;
  bool givesUnknownBits_ = false;
  std::size_t unused_ = 0;
};

}  // namespace rungproof
