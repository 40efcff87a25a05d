// The engine against the naive interpreter on random programs. Both run the same scans; memory, accumulators, timers
// and counters must agree after each. The seed is printed with every failure (RUNGPROOF_SEED sets it); at least
// 200,000 instructions are executed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "engine/simulator.hpp"
#include "frontend/project.hpp"
#include "naive.hpp"

namespace rungproof {
namespace {

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : random_(seed) {}

  /// A main program and one subroutine as a text export.
  std::string program() {
    std::string text = "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nMOVW 5, VW100\nMOVW 0, VW102\n";
    const int rungs = 8 + pick(8);
    for (int n = 0; n < rungs; ++n) {
      text += fmt::format("Network {}\n", n + 2);
      switch (pick(12)) {
        case 0: text += loop(); break;
        case 1: text += jump(n); break;
        case 2: text += segment(n); break;
        case 3: text += load() + "CALL SBR0\n"; break;
        case 4: text += counter(n); break;
        case 5: text += timer(n); break;
        default: text += rung(); break;
      }
    }
    text += "END_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\n" + rung() + "Network 2\n" + rung() + "END_SUBROUTINE_BLOCK\n";
    return text;
  }
  int pick(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }

 private:
  std::string one(const std::vector<std::string>& list) { return list[static_cast<std::size_t>(pick(static_cast<int>(list.size())))]; }
  std::string any(std::initializer_list<const char*> list) { return *(list.begin() + pick(static_cast<int>(list.size()))); }
  std::string bit() {
    switch (pick(7)) {
      case 0: case 1: return fmt::format("I0.{}", pick(8));
      case 2: return fmt::format("Q0.{}", pick(8));
      case 3: return fmt::format("M{}.{}", pick(3), pick(8));
      case 4: return fmt::format("V{}.{}", pick(6), pick(8));
      case 5: return fmt::format("SM1.{}", any({"0", "1", "2", "3"}));
      default: return any({"T40", "T33", "C10", "C12", "T97", "T101"});
    }
  }
  std::string target() {
    switch (pick(3)) {
      case 0: return fmt::format("Q0.{}", pick(8));
      case 1: return fmt::format("M{}.{}", pick(3), pick(8));
      default: return fmt::format("V{}.{}", pick(6), pick(8));
    }
  }
  std::string byte(bool constant) { return constant && pick(3) == 0 ? fmt::format("{}", pick(256)) : any({"VB8", "VB9", "VB20", "MB4", "AC0", "AC1", "IB0", "QB0"}); }
  std::string byteOut() { return any({"VB8", "VB9", "VB20", "MB4", "AC0", "AC1"}); }
  std::string word(bool constant) {
    if (constant && pick(3) == 0) return fmt::format("{}", any({"0", "1", "-1", "32767", "-32768", "100", "9999", "16#1234", "7"}));
    return any({"VW8", "VW9", "VW12", "MW4", "AC0", "AC2", "C11", "T41", "VW20"});
  }
  std::string wordOut() { return any({"VW8", "VW9", "VW12", "MW4", "AC0", "AC2", "VW20"}); }
  std::string dword(bool constant) { return constant && pick(3) == 0 ? any({"0", "1", "-1", "2147483647", "-2147483648", "65536", "16#80000001"}) : any({"VD8", "VD20", "VD24", "MD4", "AC0", "AC3"}); }
  std::string dwordOut() { return any({"VD8", "VD20", "VD24", "MD4", "AC0", "AC3"}); }
  std::string real(bool constant) { return constant && pick(2) == 0 ? any({"0.0", "1.0", "-2.5", "1.0E+20", "0.1"}) : any({"VD40", "VD44", "VD48"}); }

  std::string compare(const std::string& joint) {
    const std::string relation = any({"=", "<>", "<", "<=", ">", ">="});
    switch (pick(3)) {
      case 0: return fmt::format("{}B{} {}, {}\n", joint, relation, byte(false), byte(true));
      case 1: return fmt::format("{}W{} {}, {}\n", joint, relation, word(false), word(true));
      default: return fmt::format("{}D{} {}, {}\n", joint, relation, dword(false), dword(true));
    }
  }
  std::string load() {
    std::string text = pick(4) == 0 ? compare("LD") : fmt::format("{} {}\n", any({"LD", "LDN"}), bit());
    for (int n = pick(4); n > 0; --n) {
      switch (pick(9)) {
        case 0: text += fmt::format("LD {}\nAN {}\n{}\n", bit(), bit(), any({"ALD", "OLD"})); break;
        case 1: text += compare(any({"A", "O"})); break;
        case 2: text += any({"NOT\n", "EU\n", "ED\n", "AENO\n", "LDS 1\nLPP\n"}); break;
        case 3: text += fmt::format("LPS\nA {}\n= {}\nLRD\nAN {}\n= {}\nLPP\n", bit(), target(), bit(), target()); break;
        default: text += fmt::format("{} {}\n", any({"A", "AN", "O", "ON"}), bit()); break;
      }
    }
    return text;
  }
  std::string box() {
    switch (pick(17)) {
      case 0: return fmt::format("{} {}, {}\n", any({"S", "R"}), target(), 1 + pick(12));
      case 1: return fmt::format("{} {}, {}\n", any({"+I", "-I", "*I", "/I"}), word(true), wordOut());
      case 2: return fmt::format("{} {}, {}\n", any({"+D", "-D", "*D", "/D"}), dword(true), dwordOut());
      case 3: return fmt::format("{} {}, {}\n", any({"+R", "-R", "*R", "/R"}), real(true), any({"VD40", "VD44", "VD48"}));
      case 4: return any({"INCB ", "DECB "}) + byteOut() + "\n";
      case 5: return any({"INCW ", "DECW ", "INVW ", "SWAP "}) + wordOut() + "\n";
      case 6: return any({"INCD ", "DECD ", "INVD "}) + dwordOut() + "\n";
      case 7: return fmt::format("{} {}, {}\n", any({"ANDB", "ORB", "XORB"}), byte(true), byteOut());
      case 8: return fmt::format("{} {}, {}\n", any({"ANDW", "ORW", "XORW", "MOVW"}), word(true), wordOut());
      case 9: return fmt::format("{} {}, {}\n", any({"ANDD", "ORD", "XORD", "MOVD"}), dword(true), dwordOut());
      case 10: return fmt::format("{} {}, {}\n", any({"SLB", "SRB", "RLB", "RRB"}), byteOut(), pick(20));
      case 11: return fmt::format("{} {}, {}\n", any({"SLW", "SRW", "RLW", "RRW"}), wordOut(), pick(36));
      case 12: return fmt::format("{} {}, {}\n", any({"SLD", "SRD", "RLD", "RRD"}), dwordOut(), pick(70));
      case 13: return fmt::format("SHRB {}, V60.{}, {}\n", bit(), pick(8), any({"1", "5", "14", "-3", "-14", "32"}));
      case 14: return one({fmt::format("BTI {}, {}\n", byte(true), wordOut()), fmt::format("ITB {}, {}\n", word(true), byteOut()), fmt::format("ITD {}, {}\n", word(true), dwordOut()),
                           fmt::format("DTI {}, {}\n", dword(true), wordOut()), fmt::format("DTR {}, VD40\n", dword(true)), fmt::format("SEG {}, {}\n", byte(true), byteOut()),
                           fmt::format("DECO {}, {}\n", byte(true), wordOut()), fmt::format("BCDI {}\n", wordOut()), fmt::format("IBCD {}\n", wordOut()), fmt::format("MUL {}, {}\n", word(true), dwordOut())});
      case 15: return one({fmt::format("ATT {}, VW100\n", word(true)), fmt::format("FIFO VW100, {}\n", wordOut()), fmt::format("LIFO VW100, {}\n", wordOut()), fmt::format("FILL {}, VW80, {}\n", word(true), 1 + pick(5))});
      default: return one({fmt::format("BMB VB8, VB70, {}\n", 1 + pick(6)), fmt::format("BMW VW70, VW72, {}\n", 1 + pick(4)), fmt::format("BMD VD20, VD84, {}\n", 1 + pick(2)), fmt::format("MOVB {}, {}\n", byte(true), byteOut())});
    }
  }
  std::string rung() {
    std::string text = load();
    for (int n = 1 + pick(3); n > 0; --n) text += pick(3) == 0 ? fmt::format("= {}\n", target()) : box();
    return text;
  }
  std::string loop() { return load() + fmt::format("FOR VW124, {}, {}\n", pick(3), pick(5)) + rung() + rung() + "NEXT\n"; }
  std::string jump(int n) { return load() + fmt::format("JMP {}\n", n) + rung() + fmt::format("LBL {}\n", n) + rung(); }
  std::string segment(int n) {
    return fmt::format("{}S S0.{}, 1\nNetwork {}\nLSCR S0.{}\n", load(), n % 8, 100 + n, n % 8) + rung() + fmt::format("LD {}\nSCRT S0.{}\n", bit(), (n + 1) % 8) + "SCRE\n";
  }
  std::string counter(int n) {
    const std::string name = any({"CTU", "CTD", "CTUD"});
    return load() + load() + (name == "CTUD" ? load() : "") + fmt::format("{} C{}, {}\n", name, 10 + n, any({"1", "2", "3", "0"}));
  }
  std::string timer(int n) {
    static constexpr int numbers[] = {33, 34, 35, 36, 97, 98, 99, 100, 40, 41, 42, 43, 101, 102, 103, 104};
    return load() + fmt::format("{} T{}, {}\n", any({"TON", "TOF"}), numbers[n], any({"1", "3", "10"}));
  }

  std::mt19937_64 random_;
};

/// What differs between the two after a scan, or nothing.
std::string difference(const Simulator& engine, const naive::Interpreter& plain) {
  const Concrete::Store& s = engine.store();
  for (const auto& [area, first, last] : {std::tuple{Area::V, 0U, 130U}, {Area::M, 0U, 31U}, {Area::Q, 0U, 15U}, {Area::S, 0U, 3U}, {Area::SM, 1U, 1U}}) {
    for (std::uint32_t byte = first; byte <= last; ++byte) {
      const auto expected = plain.memory.at(area)[byte];
      const auto actual = s.area(area)[byte];
      if (expected != actual) return fmt::format("{}B{}: naive {}, engine {}", areaName(area), byte, expected, actual);
    }
  }
  for (std::uint32_t n = 0; n < 4; ++n) {
    if (s.get(Reg::Accumulator, n) != plain.accumulator[n]) return fmt::format("AC{}: naive {:x}, engine {:x}", n, plain.accumulator[n], s.get(Reg::Accumulator, n));
  }
  for (std::uint32_t n = 0; n < 256; ++n) {
    if (static_cast<std::int16_t>(s.get(Reg::TimerCurrent, n)) != plain.timer[n] || (s.get(Reg::TimerBit, n) != 0) != plain.timerBit[n]) {
      return fmt::format("T{}: naive {} {}, engine {} {}", n, plain.timer[n], plain.timerBit[n], s.get(Reg::TimerCurrent, n), s.get(Reg::TimerBit, n));
    }
    if (static_cast<std::int16_t>(s.get(Reg::CounterCurrent, n)) != plain.counter[n] || (s.get(Reg::CounterBit, n) != 0) != plain.counterBit[n]) {
      return fmt::format("C{}: naive {} {}, engine {} {}", n, plain.counter[n], plain.counterBit[n], s.get(Reg::CounterCurrent, n), s.get(Reg::CounterBit, n));
    }
  }
  return {};
}

/// Whether loops, jumps and segments are whole; the naive interpreter needs that.
bool isWhole(const Program& program) {
  for (const Pou& pou : program.pous) {
    if (!flowOf(pou).faults.empty()) return false;
  }
  return true;
}

/// Runs both for `scans` scans with inputs and lengths drawn from `seed`; gives the first difference.
std::string firstDifference(const std::string& text, std::uint64_t seed, int scans, std::size_t* executed) {
  const Program program = readText("random.awl", text);
  if (hasReadErrors(program) || !isWhole(program)) return "unreadable";
  std::mt19937_64 random(seed);
  const auto pick = [&](std::uint64_t n) { return random() % n; };
  Simulator engine(program, SimulatorOptions{});
  naive::Interpreter plain(program);
  std::uint64_t now = 0, before = 0;
  for (int scan = 0; scan < scans; ++scan) {
    const auto inputs = static_cast<std::uint8_t>(pick(256));
    plain.memory[Area::I][0] = inputs;
    for (unsigned bit = 0; bit < 8; ++bit) engine.write(direct(Area::I, Width::Bit, 0, bit), inputs >> bit & 1U);
    const std::uint32_t length = 5 + static_cast<std::uint32_t>(pick(150));
    engine.scan({.lengthUs = length * 1000});
    plain.scan(static_cast<int>(now / 10 - before / 10), static_cast<int>(now / 100 - before / 100));
    before = now;
    now += length;
    if (executed != nullptr) *executed += program.instructionCount();
    if (const std::string wrong = difference(engine, plain); !wrong.empty()) return fmt::format("scan {}: {}", scan + 1, wrong);
  }
  return {};
}

/// The same failure with as few lines as can be had by taking out lines one by one.
std::string shrunk(std::string text, std::uint64_t seed, int scans) {
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = text.find('\n', begin) + 1;
      std::string shorter = text.substr(0, begin) + text.substr(end);
      const std::string wrong = firstDifference(shorter, seed, scans, nullptr);
      if (!wrong.empty() && wrong.rfind("unreadable", 0) != 0) {
        text = std::move(shorter);
        smaller = true;
      } else {
        begin = end;
      }
    }
  }
  return text;
}

TEST(Reference, EngineAgreesWithTheNaiveInterpreter) {
  const char* given = std::getenv("RUNGPROOF_SEED");
  const std::uint64_t seed = given == nullptr ? 20040601 : std::strtoull(given, nullptr, 10);
  std::size_t executed = 0;
  for (std::uint64_t round = 0; executed < 250000; ++round) {
    const std::string text = Generator(seed + round).program();
    const std::string wrong = firstDifference(text, seed + round, 40, &executed);
    ASSERT_EQ(wrong, "") << "seed " << seed + round << "\n" << shrunk(text, seed + round, 40);
  }
  RecordProperty("seed", std::to_string(seed));
  RecordProperty("instructions", std::to_string(executed));
}

}  // namespace
}  // namespace rungproof
