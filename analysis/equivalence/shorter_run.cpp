// Leaves out ever smaller parts and judges again.
#include "analysis/equivalence/shorter_run.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace rungproof {

namespace {

class RunShortener {
 public:
  RunShortener(const BothRuns& runs, EquivalenceRun run, std::chrono::steady_clock::time_point deadline)
      : runs_(runs), best_(std::move(run)), deadline_(deadline) {}

  EquivalenceRun shortest() {
    if (best_.before.size() != best_.after.size()) return std::move(best_);
    holdEachStepOnce();
    leaveOutScans();
    quietenInputs();
    leaveOutScans();
    return std::move(best_);
  }

 private:
  bool isOver() const { return std::chrono::steady_clock::now() >= deadline_; }

  /// Keeps the candidate if it shows the same.
  bool accept(EquivalenceRun candidate) {
    auto judged = runs_.judged(std::move(candidate));
    if (!judged || judged->signal != best_.signal || judged->scan > best_.scan) return false;
    best_ = std::move(*judged);
    return true;
  }

  void holdEachStepOnce() {
    EquivalenceRun run = best_;
    for (std::vector<ReplayScan>* scans : {&run.before, &run.after}) {
      for (ReplayScan& scan : *scans) scan.repeats = 1;
    }
    accept(std::move(run));
  }
  void leaveOutScans() {
    for (std::size_t length = std::max<std::size_t>(best_.before.size() / 2, 1); length > 0; length /= 2) {
      for (std::size_t first = 0; first + length <= best_.before.size() && !isOver();) {
        if (best_.before.size() == length || !accept(without(first, length))) first += length;
      }
    }
    for (std::size_t i = 0; i < best_.before.size(); ++i) {
      std::uint32_t rounds = best_.before[i].repeats / 2;
      while (rounds > 0 && i < best_.before.size() && !isOver()) {
        if (best_.before[i].repeats <= rounds || !accept(withFewerRounds(i, rounds))) rounds /= 2;
      }
    }
  }
  EquivalenceRun without(std::size_t first, std::size_t length) const {
    EquivalenceRun run = best_;
    for (std::vector<ReplayScan>* scans : {&run.before, &run.after}) {
      const auto begin = scans->begin() + static_cast<std::ptrdiff_t>(first);
      scans->erase(begin, begin + static_cast<std::ptrdiff_t>(length));
    }
    return run;
  }
  EquivalenceRun withFewerRounds(std::size_t i, std::uint32_t rounds) const {
    EquivalenceRun run = best_;
    run.before[i].repeats -= rounds;
    run.after[i].repeats -= rounds;
    return run;
  }

  /// Each input of OLD with what stands for it in NEW, then inputs that NEW alone reads: off all the time. What is one
  /// byte in one program may be several bits in the other.
  void quietenInputs() {
    const std::vector<PresetValue> before = best_.before.empty() ? std::vector<PresetValue>{} : best_.before[0].inputs,
                                   after = best_.after.empty() ? std::vector<PresetValue>{} : best_.after[0].inputs;
    std::set<std::pair<Area, std::uint32_t>> tried;  // in NEW
    for (const PresetValue& input : before) {
      const std::vector<Address> own = addressesOf(input.operand);
      std::vector<Address> there;
      for (const Address& address : own) {
        if (const auto partner = runs_.options.pairs.after(address)) there.push_back(*partner);
      }
      for (const Address& address : there) tried.emplace(address.area, address.index);
      quieten(own, there);
    }
    for (const PresetValue& input : after) {
      std::vector<Address> alone = addressesOf(input.operand);
      std::erase_if(alone, [&](const Address& address) { return tried.contains({address.area, address.index}); });
      quieten({}, alone);
    }
  }
  static std::vector<Address> addressesOf(const Operand& operand) {
    const Address first = addressOf(operand);
    std::vector<Address> addresses;
    for (std::uint32_t i = 0; i < extentOf(operand); ++i) addresses.push_back({first.area, first.index + i});
    return addresses;
  }
  /// The value without the bits that stand at these addresses.
  static std::uint64_t without(const PresetValue& value, const std::vector<Address>& addresses) {
    const std::vector<Address> own = addressesOf(value.operand);
    std::uint64_t rest = value.value;
    if (isWholeValue(value.operand.area)) return std::ranges::find(addresses, own[0]) == addresses.end() ? rest : 0;
    const Place place = memoryPlace(value.operand.area, value.operand.offset, value.operand.width, value.operand.bit);
    for (std::uint32_t i = 0; i < place.width; ++i) {
      const bool isThere = std::ranges::find(addresses, bitOf(place, i)) != addresses.end();
      if (isThere) rest &= ~(std::uint64_t{1} << (place.width - 1 - i));
    }
    return rest;
  }
  void quieten(const std::vector<Address>& before, const std::vector<Address>& after) {
    if (isOver()) return;
    EquivalenceRun run = best_;
    bool isChanged = false;
    const auto quiet = [&](std::vector<ReplayScan>& scans, const std::vector<Address>& addresses) {
      for (ReplayScan& scan : scans) {
        for (PresetValue& value : scan.inputs) {
          const std::uint64_t rest = value.value == 0 ? 0 : without(value, addresses);
          isChanged = isChanged || rest != value.value;
          value.value = rest;
        }
      }
    };
    quiet(run.before, before);
    quiet(run.after, after);
    if (isChanged) accept(std::move(run));
  }

  const BothRuns& runs_;
  EquivalenceRun best_;
  const std::chrono::steady_clock::time_point deadline_;
};

}  // namespace

EquivalenceRun shorterRun(const BothRuns& runs, EquivalenceRun run, std::chrono::steady_clock::time_point deadline) {
  return RunShortener(runs, std::move(run), deadline).shortest();
}

}  // namespace rungproof
