// The test is played with the property's monitor beside it. The bits that a mended program may make otherwise are tried
// with all values in the last scan, behind several courses of them in the scans before.
#include "frontend/testing/asked_values.hpp"

#include <algorithm>
#include <array>

#include "analysis/encoding/asked_properties.hpp"
#include "analysis/witness/follower.hpp"
#include "analysis/witness/state_pool.hpp"
#include "engine/testing/test_player.hpp"
#include "ir/overlap.hpp"
#include "ir/written_operand.hpp"

namespace rungproof {

namespace {

constexpr std::size_t mostFreeBits = 6;

/// Of the free bits in the scans before the last one: as played, 0, 1, in turns, in turns the other way round.
constexpr std::size_t courseCount = 5;
std::optional<bool> courseAt(std::size_t course, std::uint64_t scan) {
  constexpr std::size_t asPlayed = 0, firstOfTurns = 3;
  if (course == asPlayed) return std::nullopt;
  return course < firstOfTurns ? course == 2 : (scan + course) % 2 == 0;
}

/// What the surroundings decide: every program meets the same there.
bool isGivenOutside(const Program& program, const TestTable& table, const Operand& operand) {
  const bool isSet = std::ranges::any_of(
      table.sets, [&](const StimulusColumn& column) { return overlaps(column.signal.operand, operand); });
  const bool isTerminal = operand.area == Area::I || operand.area == Area::AI || operand.area == Area::PI;
  return isSet || operand.area == Area::SM || (isTerminal && !isWritten(program, operand, Actuals::Read));
}

/// The bits that the property reads and a program makes; nothing: it reads numbers, timers, or too much of the program.
std::optional<Operands> freeBits(const Program& program, const TestTable& table, const Property& property) {
  Operands free;
  for (const Operand* operand : addressesOf(property)) {
    const auto isIt = [&](const Operand& other) { return toString(other) == toString(*operand); };
    if (isGivenOutside(program, table, *operand) || std::ranges::any_of(free, isIt)) continue;
    if (operand->width != Width::Bit || hasBitAndWord(operand->area) || free.size() == mostFreeBits)
      return std::nullopt;
    free.push_back(*operand);
  }
  return free;
}

void putBit(Concrete::Store& state, const Operand& bit, bool value) {
  state.save(bit.area, bit.offset * 8 + bit.bit, 1, value ? 1 : 0, true);
}

/// Which values each bit has in the scans that keep to the property.
using AllowedValues = std::vector<std::array<bool, 2>>;

class BitQuestion {
 public:
  BitQuestion(const Property& property, const Operands& free) : free_(free) {
    for (std::size_t course = 0; course < courseCount; ++course) followers_.emplace_back(property);
  }

  void scan(const Simulator& simulator, bool isLast) {
    ReplayScan scan;
    scan.lengthMs = std::max<std::uint32_t>(simulator.lastScanUs() / 1000, 1);
    const std::uint64_t number = simulator.scanCount();
    Concrete::Store state = simulator.store();
    for (std::size_t course = 0; course < courseCount; ++course) {
      if (isLast) {
        end(course, state, scan, number == 1);
        continue;
      }
      for (const Operand& bit : free_) {
        if (const std::optional<bool> value = courseAt(course, number)) putBit(state, bit, *value);
      }
      followers_[course].evaluate(domain_, state, scan, number == 1);
    }
  }

  /// The value that the bit must have behind every course that a right program may have taken.
  std::optional<bool> asked(std::size_t bit) const {
    std::optional<bool> value;
    for (const AllowedValues& allowed : ends_) {
      const auto [zero, one] = allowed[bit];
      if (!zero && !one) continue;  // no program that keeps to the property comes there
      if (zero == one || (value && *value != one)) return std::nullopt;
      value = one;
    }
    return value;
  }

 private:
  void end(std::size_t course, Concrete::Store& state, const ReplayScan& scan, bool isFirst) {
    AllowedValues& allowed = ends_.emplace_back(free_.size());
    for (std::uint32_t values = 0; values < 1U << free_.size(); ++values) {
      for (std::size_t i = 0; i < free_.size(); ++i) putBit(state, free_[i], (values >> i & 1) != 0);
      Follower follower = followers_[course];
      if (follower.evaluate(domain_, state, scan, isFirst)) continue;
      for (std::size_t i = 0; i < free_.size(); ++i) allowed[i][values >> i & 1] = true;
    }
  }

  const Operands& free_;
  std::vector<Follower> followers_;
  std::vector<AllowedValues> ends_;
  StillOutside outside_;
  Concrete domain_{outside_};
};

}  // namespace

std::vector<std::optional<bool>> askedValues(const Program& program, const SimulatorOptions& engine,
                                             const TestTable& table, const Property& property,
                                             const std::vector<std::uint32_t>& lengths) {
  std::vector<std::optional<bool>> result(table.expects.size());
  if (property.first.empty()) return result;  // a built-in check asks about statements, not about values
  const std::optional<Operands> free = freeBits(program, table, property);
  if (!free) return result;
  bool isFirst = true;
  for (const std::uint32_t us : lengths) {
    TestPlayOptions play;
    play.engine = engine;
    play.length = [us](std::uint64_t) { return us; };
    const std::uint64_t last = stepTimesOf(table.tests.front(), play.length).back().compares;
    BitQuestion question(property, *free);
    play.afterScan = [&](const Simulator& now, std::size_t) { question.scan(now, now.scanCount() == last); };
    play.stopsAtFailure = false;
    Simulator simulator(program, engine);
    playTest(simulator, table, table.tests.front(), play);
    for (std::size_t i = 0; i < free->size(); ++i) {
      const auto column = std::ranges::find_if(
          table.expects, [&](const TraceSignal& signal) { return toString(signal.operand) == toString((*free)[i]); });
      if (column == table.expects.end()) continue;
      std::optional<bool>& value = result[static_cast<std::size_t>(column - table.expects.begin())];
      const std::optional<bool> asked = question.asked(i);
      value = isFirst || value == asked ? asked : std::nullopt;
    }
    isFirst = false;
  }
  return result;
}

}  // namespace rungproof
