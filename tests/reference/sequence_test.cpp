// What shows only over several scans: edges, timers of every kind and resolution, counters, at random inputs, presets
// and times, from current values near the borders. Engine and naive interpreter must agree after each scan; so must the
// moments at which 1 and 10 ms timers come to their preset (events 21 and 22).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "likeness.hpp"

namespace rungproof::reference {
namespace {

class Sequence {
 public:
  Sequence(const std::string& mnemonic, std::uint64_t seed) : random_(seed) {
    const bool isTimer = mnemonic.starts_with("TO") || mnemonic == "TP.IEC", isCounter = mnemonic.starts_with("CT");
    const std::string preset = oneIn(2) ? "VW0" : fmt::format("{}", any({0, 1, 2, 3, 5, 10, -1, 32767, -32768}));
    if (isTimer) {
      number_ = mnemonic == "TONR" ? any({0, 64, 1, 4, 65, 68, 5, 31, 69, 95})
                                   : any({32, 96, 33, 36, 97, 100, 37, 63, 101, 255});
      line_ = fmt::format("{} T{}, {}", mnemonic, number_, preset);
    } else if (isCounter) {
      number_ = static_cast<int>(pick(256));
      line_ = fmt::format("{} C{}, {}", mnemonic, number_, preset);
    } else {
      line_ = mnemonic;
    }
    if (mnemonic.ends_with(".IEC") && !oneIn(4))
      line_ += mnemonic == "CTUD.IEC" ? ", Q0.0, Q0.1, VW10" : ", Q0.0, VW10";
    text_ = oneIn(4) ? "LSCR S0.0; " : "";
    text_ += "LD I0.0; LD I0.1; LD I0.2; LD I0.3; " + line_ + (isTimer || isCounter ? "" : "; = Q0.2");
    if (isTimer || isCounter)
      text_ += fmt::format("; LD I0.4; R {}{}, 1; LD {}{}; = Q0.3", isTimer ? 'T' : 'C', number_, isTimer ? 'T' : 'C',
                           number_);
  }

  std::string run() {
    manual::Plant plant(text_);
    plant.freshLocal = 0;
    plant.store.set(Reg::FirstScan, 0, 1, true);
    const std::uint64_t start = any({0, 0, 0, 1, -1, 2, 9, 32766, 32767, -32768}) & 0xFFFF;
    if (line_[0] == 'T') plant.store.set(Reg::TimerCurrent, static_cast<std::uint32_t>(number_), start, true);
    if (line_[0] == 'C') plant.store.set(Reg::CounterCurrent, static_cast<std::uint32_t>(number_), start, true);
    naive::Interpreter plain(plant.program());
    for (int scan = 0; scan < 30; ++scan) {
      plant.set("IB0", random_() & random_() & 0x10 & (oneIn(4) ? 0x10 : 0) ? (random_() & 0x1F) : (random_() & 0x0F));
      plant.set("S0.0", oneIn(5) ? 0 : 1);
      if (oneIn(6)) plant.set("VW0", static_cast<std::uint64_t>(any({0, 1, 2, 3, 4, 8, -1, 32767})));
      copyMemory(plant, plain);
      const int ten = ticks(), hundred = ticks(), ms = ticks();
      plant.ms = {{0, ms}};
      plain.errors.clear();
      plain.expired.clear();
      plant.scan(ten, hundred);
      plain.pass(ms);
      plain.scan(ten, hundred);
      if (const std::string wrong = difference(plant, plain, nullptr); !wrong.empty())
        return fmt::format("scan {}: {}", scan, wrong);
      std::set<std::uint32_t> expired;
      for (const auto& [timer, now] : plant.reached) {
        if (now) expired.insert(timer);
      }
      if (expired != plain.expired) return fmt::format("scan {}: the moment of the preset differs", scan);
    }
    return {};
  }
  const std::string& text() const { return text_; }

 private:
  std::uint32_t pick(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
  bool oneIn(std::uint32_t n) { return pick(n) == 0; }
  int any(std::initializer_list<int> list) { return *(list.begin() + pick(static_cast<std::uint32_t>(list.size()))); }
  int ticks() { return any({0, 0, 1, 1, 1, 2, 3, 10, oneIn(10) ? 40000 : 1}); }
  /// What the plant's surroundings have written, and at the beginning its registers.
  void copyMemory(const manual::Plant& plant, naive::Interpreter& plain) {
    if (isFirst_) copyState(plant, plain);
    isFirst_ = false;
    for (const Area area : {Area::I, Area::S, Area::V})
      std::copy(plant.store.area(area).begin(), plant.store.area(area).end(), plain.memory[area].begin());
    std::fill_n(plain.memory[Area::L].begin(), 64, 0);
  }

  std::mt19937_64 random_;
  std::string line_, text_;
  int number_ = 0;
  bool isFirst_ = true;
};

class OverScans : public testing::TestWithParam<std::string> {};

TEST_P(OverScans, AgreesWithTheNaiveInterpreter) {
  const auto fromOutside = [](const char* name, std::uint64_t otherwise) {
    const char* given = std::getenv(name);
    return given == nullptr ? otherwise : std::strtoull(given, nullptr, 10);
  };
  const std::uint64_t first = fromOutside("RUNGPROOF_SEED", 1), cases = fromOutside("RUNGPROOF_CASES", 30);
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    Sequence sequence(GetParam(), seed * 7919);
    ASSERT_EQ(sequence.run(), "") << "seed " << seed << ": " << sequence.text();
  }
}

INSTANTIATE_TEST_SUITE_P(Every, OverScans,
                         testing::Values("EU", "ED", "TON", "TOF", "TONR", "TON.IEC", "TOF.IEC", "TP.IEC", "CTU", "CTD",
                                         "CTUD", "CTU.IEC", "CTD.IEC", "CTUD.IEC"),
                         [](const auto& info) {
                           return info.param.substr(0, info.param.find('.')) +
                                  (info.param.find('.') == std::string::npos ? "" : "_IEC");
                         });

}  // namespace
}  // namespace rungproof::reference
