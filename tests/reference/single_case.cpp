// Drawing one instruction and its machine.
#include "single_case.hpp"

#include <fmt/format.h>

#include <bit>

#include "ir/s7200/isa.hpp"

namespace rungproof::reference {

namespace {

constexpr std::uint32_t lastV = 10240;

int bytesOf(char letter) {
  const std::string_view words = "wWqtf", wides = "dDrRm";
  return words.find(letter) != std::string_view::npos ? 2 : wides.find(letter) != std::string_view::npos ? 4 : 1;
}
std::uint32_t sizeOf(Area area) {
  return area == Area::V                      ? lastV
         : area == Area::I || area == Area::Q ? 16
         : area == Area::M || area == Area::S ? 32
         : area == Area::SM                   ? 550
         : area == Area::T || area == Area::C ? 256
                                              : 64;
}
char widthLetter(int bytes) { return bytes == 1 ? 'B' : bytes == 2 ? 'W' : 'D'; }

}  // namespace

bool isCompare(const std::string& mnemonic) {
  const std::size_t relation = mnemonic.find_first_of("<>=");
  return relation != std::string::npos && relation >= 2 && !mnemonic.starts_with("FND");
}

SingleCase::SingleCase(const std::string& mnemonic, std::uint64_t seed) : random_(seed) {
  const std::string_view signature = *naive::signatureOf(mnemonic);
  if (isCompare(mnemonic)) odds_ = 2;  // both operands in every form
  const std::string line = mnemonic + " " + operandsOf(mnemonic, signature);
  // Nine levels of the stack, power flow on top most of the time, now and then inside a segment.
  statements_ = oneIn(8) ? "LSCR S31.0; " : "";
  for (int level = 0; level < 8; ++level) statements_ += fmt::format("LD V1300.{}; ", level);
  statements_ += "LD I0.7; " + line;
  plant_ = std::make_unique<manual::Plant>(statements_);
  fillMemory(mnemonic);
}

const Instruction& SingleCase::instruction() const { return plant_->program().pous[0].networks[0].instructions.back(); }

void SingleCase::fillMemory(const std::string& mnemonic) {
  Concrete::Store& store = plant_->store;
  const auto fill = [&](Area area, std::size_t from, std::size_t to) {
    auto& bytes = store.area(area);
    std::uint64_t eight = 0;
    for (std::size_t at = from; at < to; ++at, eight >>= 8) {
      if ((at - from) % 8 == 0) eight = random_();
      bytes[at] = static_cast<std::uint8_t>(eight);
    }
  };
  fill(Area::V, 0, 1310);
  fill(Area::V, lastV - 300, lastV);
  for (const Area area : {Area::I, Area::Q, Area::M, Area::S, Area::AQ}) fill(area, 0, sizeOf(area));
  plant_->freshLocal = pick(256);
  fill(Area::SM, 200, 260);
  fill(Area::SM, 1, 2);
  const auto registers = [&](Reg reg) {
    for (std::uint32_t n = 0; n < registerCount(regInfo(reg), plant_->plan()); ++n)
      store.set(reg, n, random_() & (~0ULL >> (64 - regInfo(reg).width)), true);
  };
  for (const Reg reg : {Reg::Accumulator, Reg::TimerCurrent, Reg::TimerBit, Reg::CounterCurrent, Reg::CounterBit,
                        Reg::HscCurrent, Reg::PidHistory, Reg::Eno})
    registers(reg);
  store.set(Reg::FirstScan, 0, oneIn(4) ? 1 : 0, true);
  const auto outside = [&](External kind, std::uint32_t count, std::uint32_t step, std::uint64_t mask) {
    for (std::uint32_t n = 0; n < count; n += step) plant_->outside.values[{kind, n}] = random_() & mask;
  };
  outside(External::AnalogInput, 64, 2, 0xFFFF);
  outside(External::ImmediateInput, 128, 1, 1);
  outside(External::ClockByte, 19, 1, 0xFF);
  outside(External::IntervalClock, 1, 1, 0xFFFFFFFF);
  outside(External::StationAddress, 2, 1, 0xFF);
  settings_.insert(settings_.end(), pointers_.begin(), pointers_.end());
  Concrete domain(plant_->outside);
  for (const Setting& s : settings_) {
    const Width width = s.bytes == 1 ? Width::Byte : s.bytes == 2 ? Width::Word : Width::DWord;
    if (s.place.area == Area::AI)
      plant_->outside.values[{External::AnalogInput, s.place.offset}] = s.value & 0xFFFF;
    else if (s.place.area == Area::HC)
      store.set(Reg::HscCurrent, s.place.offset, s.value, true);
    else if (s.place.area == Area::AC)
      store.set(Reg::Accumulator, s.place.offset, s.value, true);
    else if (s.place.area == Area::T)
      store.set(Reg::TimerCurrent, s.place.offset, s.value & 0xFFFF, true);
    else if (s.place.area == Area::C)
      store.set(Reg::CounterCurrent, s.place.offset, s.value & 0xFFFF, true);
    else
      store.save(s.place.area, s.place.offset * 8, bits(width), s.value & Concrete::mask(bits(width)), true);
  }
  const bool joinsByOr = isCompare(mnemonic) && mnemonic[0] == 'O';   // its result shows without power flow only
  store.save(Area::I, 7, 1, oneIn(joinsByOr ? 2 : 8) ? 0 : 1, true);  // I0.7
  store.save(Area::S, 31 * 8, 1, oneIn(2) ? 0 : 1, true);             // S31.0
}

void SingleCase::put(const Spot& at, int bytes, std::uint32_t value, std::uint32_t element) {
  const bool numbered = at.area == Area::T || at.area == Area::C;
  const std::uint32_t offset = at.offset + element * (numbered ? 1 : static_cast<std::uint32_t>(bytes));
  const std::uint32_t step = numbered ? 1 : static_cast<std::uint32_t>(bytes);
  if (at.area != Area::AC && at.area != Area::HC && offset + step > sizeOf(at.area)) return;
  settings_.push_back({direct(at.area, Width::DWord, offset), bytes, value});
}

/// Values at which something changes: borders of types, powers of ten, signs, small numbers.
std::uint32_t SingleCase::special(char letter) {
  const std::string_view reals = "rR";
  if (oneIn(4)) return static_cast<std::uint32_t>(random_());
  if (reals.find(letter) != std::string_view::npos) {
    if (oneIn(12))
      return any({0x7F800000U, 0xFF800000U, 0x7FC00000U, 0x80000000U, 1U, 0x00800000U, 0x7F7FFFFFU, 0xFF7FFFFFU});
    const float number =
        oneIn(2)
            ? static_cast<float>(static_cast<std::int32_t>(pick(2'000'001)) - 1'000'000) /
                  any({1.0F, 2.0F, 8.0F, 1000.0F, 1e6F})
            : any({0.0F,        1.0F,       -1.0F,         0.5F,          -0.5F,          2.5F,           -2.5F,
                   1.5F,        0.05F,      0.95F,         9.5F,          9.95F,          -9.995F,        99999.5F,
                   999999.0F,   0.999999F,  88.0F,         89.0F,         1e-3F,          1e-5F,          1e-6F,
                   1e-20F,      1e10F,      1e14F,         9.99999e14F,   1e15F,          1e20F,          -1e20F,
                   3e38F,       -3e38F,     2147483520.0F, 2147483648.0F, -2147483648.0F, -2147483904.0F, 16777216.0F,
                   16777217.0F, 8388607.5F, 8388608.0F,    4194304.5F,    123.456F,       -0.0004F});
    return std::bit_cast<std::uint32_t>(number);
  }
  switch (bytesOf(letter)) {
    case 1:
      return any({0U,  1U,  2U,    3U,  4U,  5U,  6U,    7U,   8U,   9U,    11U,   15U,   16U,   17U,   31U,
                  32U, 33U, 0x30U, 63U, 64U, 65U, 0x63U, 127U, 128U, 0xC0U, 0xBFU, 0xC1U, 0xF0U, 0xFEU, 0xFFU});
    case 2:
      return any({0U,     1U,      2U,      7U,      9U,      10U,     99U,     100U,    101U,
                  255U,   256U,    999U,    1000U,   9999U,   10000U,  0x0999U, 0x9999U, 0x9A99U,
                  0x100U, 0x7FFFU, 0x8000U, 0x8001U, 0xFFFFU, 0xFFFEU, 0xFF00U});
    default:
      return any({0U, 1U, 10U, 32767U, 32768U, 65535U, 65536U, 99999U, 100000U, 0x7FFFFFFFU, 0x80000000U, 0x80000001U,
                  0xFFFFFFFFU, 0xFFFF8000U, 0xFFFF7FFFU, 0xFFFF0001U, 16777217U, 0x7FFFFFBFU, 0x46340000U});
  }
}

/// A direct place with `room` elements behind it, or with a few fewer where it stands at the end of an area.
SingleCase::Spot SingleCase::spot(int bytes, int room, bool written) {
  const auto step = static_cast<std::uint32_t>(bytes);
  const auto near = [&](Area area) {
    const std::uint32_t size = sizeOf(area), wish = (static_cast<std::uint32_t>(room) + pick(3)) * step;
    const std::uint32_t back = std::min(std::max(wish > step ? wish - step : step, step), size);
    return size - back;
  };
  const auto spelled = [&](Area area, std::uint32_t offset) {
    return Spot{area == Area::T || area == Area::C ? fmt::format("{}{}", areaName(area), offset)
                                                   : fmt::format("{}{}{}", areaName(area), widthLetter(bytes), offset),
                area, offset};
  };
  switch (pick(10)) {
    case 0: return spelled(Area::V, near(Area::V));
    case 1: return spelled(Area::M, oneIn(2) ? near(Area::M) : pick(16));
    case 2: return spelled(Area::Q, oneIn(2) ? near(Area::Q) : pick(8));
    case 3: return spelled(Area::L, oneIn(2) ? near(Area::L) : pick(30));
    case 4: return written ? spelled(Area::S, pick(20)) : spelled(Area::I, pick(8));
    case 5:
      if (bytes == 2)
        return spelled(any({Area::T, Area::C}),
                       oneIn(2) ? 256 - static_cast<std::uint32_t>(std::min(room, 200)) + (oneIn(3) && room > 1 ? 1 : 0)
                                : pick(200));
      return spelled(Area::SM, 200 + pick(20));
    default: return spelled(Area::V, pick(60));
  }
}

/// An operand that is one place, direct or behind a pointer. firstValue goes to its first element.
std::string SingleCase::reach(int bytes, int room, bool written, std::uint32_t firstValue, bool setFirst) {
  Spot at = spot(bytes, room, written);
  if (!oneIn(odds_)) {
    if (setFirst) put(at, bytes, firstValue);
    return at.text;
  }
  if (at.area == Area::L) at.area = Area::V;
  if (bytes == 2 && oneIn(4)) {
    at.area = written ? Area::AQ : Area::AI;
    at.offset = 2 * pick(32);
  }
  if (setFirst) put(at, bytes, firstValue);
  static const std::map<Area, std::uint32_t> tags = {{Area::I, 0}, {Area::Q, 1},  {Area::AI, 2}, {Area::AQ, 3},
                                                     {Area::M, 4}, {Area::SM, 5}, {Area::S, 6},  {Area::V, 8},
                                                     {Area::T, 9}, {Area::C, 10}};
  const bool numbered = at.area == Area::T || at.area == Area::C;
  std::uint32_t pointer = tags.at(at.area) << 24 | (numbered ? 2 * at.offset : at.offset);
  if (oneIn(8))
    pointer = any({pointer | 0x80000000U, pointer | 0x10000U, 0x0B000000U, 0x07000000U,
                   0x08000000U | (lastV - static_cast<std::uint32_t>(bytes) + 1), 0x02000001U, 0x09000001U, 0x09000200U,
                   0x0400001FU});
  const auto n = static_cast<std::uint32_t>(pointers_.size());
  const bool inMemory = oneIn(2);
  pointers_.push_back(
      {inMemory ? direct(Area::V, Width::DWord, 1200 + 4 * n) : direct(Area::AC, Width::DWord, 1 + n % 3), 4, pointer});
  return fmt::format("*{}{}", inMemory ? "VD" : "AC", pointers_.back().place.offset);
}

std::string SingleCase::value(char letter) {
  const bool written = std::isupper(static_cast<unsigned char>(letter)) != 0;
  const int bytes = bytesOf(letter);
  // Most of the second operands lie next to the first, or are the same.
  const std::uint32_t v = neighbour_ && !oneIn(4) ? *neighbour_ + any({0U, 0U, 1U, 0xFFFFFFFFU}) : special(letter);
  neighbour_ = v;
  if (!written && oneIn(4)) return fmt::format("16#{:X}", bytes == 4 ? v : v & ((1U << bytes * 8) - 1));
  if (oneIn(odds_ + 1)) {
    const std::uint32_t number = pick(4);
    settings_.push_back(
        {direct(Area::AC, Width::DWord, number), 4,
         bytes == 4 ? v : (static_cast<std::uint32_t>(random_()) << 8 * bytes) | (v & ((1U << bytes * 8) - 1))});
    return fmt::format("AC{}", number);
  }
  if (!written && letter == 'd' && oneIn(8)) {
    const std::uint32_t number = pick(6);
    settings_.push_back({direct(Area::HC, Width::DWord, number), 4, v});
    return fmt::format("HC{}", number);
  }
  if (!written && letter == 'w' && oneIn(8)) {
    const std::uint32_t at = 2 * pick(32);
    settings_.push_back({direct(Area::AI, Width::Word, at), 2, v});
    return fmt::format("AIW{}", at);
  }
  return reach(bytes, 1, written, v, true);
}

std::string SingleCase::bit(const std::string& mnemonic, bool written) {
  if (mnemonic == "=I" || mnemonic == "SI" || mnemonic == "RI") return fmt::format("Q{}.{}", pick(16), pick(8));
  if (mnemonic.size() > 1 && (mnemonic.ends_with("I"))) return fmt::format("I{}.{}", pick(16), pick(8));
  const std::uint32_t number = pick(8);
  if (mnemonic == "SHRB" && written)
    return any({fmt::format("V{}.{}", pick(20), number), fmt::format("V{}.{}", lastV - 1 - pick(9), number),
                fmt::format("M{}.{}", 23 + pick(9), number), fmt::format("Q{}.{}", 7 + pick(9), number)});
  switch (pick(9)) {
    case 0: return fmt::format("M{}.{}", pick(32), number);
    case 1: return fmt::format("Q{}.{}", pick(16), number);
    case 2: return fmt::format("S{}.{}", pick(31), number);
    case 3: return mnemonic == "SR" || mnemonic == "RS" ? "I1.3" : fmt::format("L{}.{}", pick(64), number);
    case 4:
      return mnemonic == "SR" || mnemonic == "RS"
                 ? "Q2.1"
                 : fmt::format("{}{}", any({"T", "C"}), any({pick(250), 250 + pick(6)}));
    case 5: return fmt::format("V{}.{}", lastV - 1 - pick(3), number);
    case 6: return written ? fmt::format("SM{}.{}", 200 + pick(10), number) : fmt::format("SM0.{}", pick(2));
    default: return fmt::format("V{}.{}", pick(20), number);
  }
}

/// Text for conversions: hexadecimal digits, numbers with and without faults.
std::string SingleCase::characters(const std::string& mnemonic) {
  std::string text;
  if (mnemonic == "ATH") {
    for (std::uint32_t n = pick(20); n > 0; --n) text += "0123456789ABCDEF"[pick(16)];
    if (oneIn(3) && !text.empty())
      text[pick(static_cast<std::uint32_t>(text.size()))] = any({'/', ':', '@', 'G', 'a', ' ', 'O'});
    return text;
  }
  if (mnemonic == "STI" || mnemonic == "STD" || mnemonic == "STR") {
    if (oneIn(8))
      return any<std::string>({"32767",
                               "32768",
                               "-32768",
                               "-32769",
                               "2147483647",
                               "2147483648",
                               "-2147483648",
                               "-2147483649",
                               "+0",
                               "65536",
                               "4294967296",
                               "00000000000000000032767",
                               "",
                               "-",
                               "+",
                               " ",
                               ".5",
                               "5.",
                               "+ 1",
                               "++1",
                               "-+1",
                               "1e5",
                               "99999999999999999999",
                               "A1",
                               "340282346638528859811704183484516925440",
                               "9999999999999999999999999999999999999999",
                               "-1,25X",
                               "00.000000123",
                               "1234567",
                               "16777216",
                               "0.0000001",
                               "1:2",
                               "/1",
                               "10000000000",
                               "12345678901"});
    text = std::string(pick(3), ' ') + any({"", "", "-", "+"});
    for (std::uint32_t n = pick(oneIn(4) ? 12 : 7); n > 0; --n) text += static_cast<char>('0' + pick(10));
    if (oneIn(2)) text += any({".", ",", ":"});
    for (std::uint32_t n = pick(5); n > 0; --n) text += static_cast<char>('0' + pick(10));
    return text + any({"", "", "E6", "F", " ", "-", ".", "9"});
  }
  for (std::uint32_t n = oneIn(12) ? 120 + pick(135) : pick(9); n > 0; --n) text += any({'a', 'b', 'c'});
  return text.substr(0, 254);
}

std::string SingleCase::buffer(const std::string& mnemonic, char letter) {
  const int bytes = bytesOf(letter);
  const bool isClock = mnemonic.starts_with("TOD");
  if (mnemonic == "PID") {
    const std::uint32_t base = 800;
    const auto real = [&](float v) { return std::bit_cast<std::uint32_t>(v); };
    const auto share = [&] { return static_cast<float>(pick(1001)) / 1000; };
    const std::array<float, 9> field = {share(),
                                        share(),
                                        share(),
                                        oneIn(6) ? 0.0F : share() * 8 - 4,
                                        oneIn(15) ? 0.0F : 0.1F + share(),
                                        oneIn(15) ? 0.0F : 0.1F + share() * 3,
                                        oneIn(3) ? 0.0F : share() / 20,
                                        share(),
                                        share()};
    for (std::uint32_t k = 0; k < field.size(); ++k) put({"", Area::V, base}, 4, real(field[k]), k);
    return fmt::format("VB{}", base);
  }
  const int room = isClock             ? (mnemonic.ends_with("X") ? 19 : 8)
                   : mnemonic == "ITA" ? 8
                   : mnemonic == "DTA" ? 12
                   : mnemonic == "RTA" ? 3 + static_cast<int>(pick(13))
                                       : 1 + static_cast<int>(pick(16));
  Spot at = spot(bytes, room, true);
  if (at.area == Area::SM || at.area == Area::S) at = {fmt::format("V{}{}", widthLetter(bytes), 20), Area::V, 20};
  if (isClock) {
    static constexpr std::array<std::array<std::uint32_t, 2>, 19> limits = {{{0, 99},
                                                                             {1, 12},
                                                                             {1, 31},
                                                                             {0, 23},
                                                                             {0, 59},
                                                                             {0, 59},
                                                                             {0, 99},
                                                                             {1, 7},
                                                                             {0, 0},
                                                                             {0, 23},
                                                                             {0, 59},
                                                                             {1, 12},
                                                                             {1, 31},
                                                                             {0, 23},
                                                                             {0, 59},
                                                                             {1, 12},
                                                                             {1, 31},
                                                                             {0, 23},
                                                                             {0, 59}}};
    for (std::uint32_t k = 0; k < limits.size(); ++k) {
      const auto [low, high] = limits[k];
      std::uint32_t v = oneIn(3) ? low : oneIn(2) ? high : low + pick(high - low + 1);
      if (oneIn(60)) v = oneIn(2) && low > 0 ? low - 1 : high + 1;
      v = v / 10 * 16 + v % 10;
      if (oneIn(60)) v = any({v + 10, 0xA0U, 0x0AU, 0x9AU});
      if (k == 8) v = oneIn(2) ? 0xFF : any({0U, 1U, 2U, 3U, 8U, 0x10U, 0x13U, 4U, 0x14U, 0x0FU, 0x12U, 0x11U});
      put(at, 1, v, k);
    }
    if (oneIn(6)) put(at, 1, 0, 7);  // weekday 0
  } else {
    const std::string text = characters(mnemonic);
    for (std::uint32_t k = 0; mnemonic == "ATH" && k < text.size(); ++k)
      put(at, 1, static_cast<std::uint8_t>(text[k]), k);
  }
  if (oneIn(5) && at.area != Area::L) {
    return reach(bytes, room, true, 0, false);
  }
  return at.text;
}

std::string SingleCase::table(char letter) {
  const std::uint32_t entries = any({0U, 1U, 2U, 3U, 5U, 99U, 100U, 101U, pick(8)});
  const std::uint32_t head = letter == 't' ? 2 : 1;
  const std::uint32_t base = oneIn(4) ? lastV - 2 * (head + entries + pick(3)) + (oneIn(2) ? 2 : 0) : 700;
  Spot at{fmt::format("VW{}", std::min(base, lastV - 2)), Area::V, std::min(base, lastV - 2)};
  if (letter == 't') put(at, 2, any({entries, entries + 1, 100U, pick(7), 101U}), 0);
  put(at, 2, entries, head - 1);
  for (std::uint32_t k = 0; k < std::min(entries, 101U); ++k) {
    const std::uint32_t entry = oneIn(2) ? pick(4) : special('w');
    if (oneIn(4)) neighbour_ = entry;
    put(at, 2, entry, head + k);
  }
  if (!oneIn(5)) return at.text;
  pointers_.push_back({direct(Area::AC, Width::DWord, 1 + static_cast<std::uint32_t>(pointers_.size()) % 3), 4,
                       0x08000000U | at.offset});
  return fmt::format("*AC{}", pointers_.back().place.offset);
}

std::string SingleCase::stringOperand(const std::string& mnemonic, bool constant) {
  std::string text = neighbourText_ && oneIn(2) ? *neighbourText_ : characters(mnemonic);
  neighbourText_ = text;
  if (constant && oneIn(4) && text.size() <= 126) return "\"" + text + "\"";
  std::uint32_t base = nextSlot_;
  nextSlot_ += oneIn(8) ? 2 : 270;  // now and then two strings overlap
  if (oneIn(6)) base = lastV - static_cast<std::uint32_t>(text.size()) - 1 - pick(2) + pick(2);
  base = std::min(base, lastV - 1);
  const Spot at{fmt::format("VB{}", base), Area::V, base};
  put(at, 1, oneIn(30) ? any({254U, 255U}) : static_cast<std::uint32_t>(text.size()));
  for (std::uint32_t k = 0; k < text.size(); ++k) put(at, 1, static_cast<std::uint8_t>(text[k]), k + 1);
  if (!oneIn(5)) return at.text;
  pointers_.push_back({direct(Area::AC, Width::DWord, 1 + static_cast<std::uint32_t>(pointers_.size()) % 3), 4,
                       (oneIn(10) ? 0xFF000000U : 0x08000000U) | base});
  return fmt::format("*AC{}", pointers_.back().place.offset);
}

std::string SingleCase::number(const std::string& mnemonic, std::size_t at) {
  if (mnemonic == "LDS") return fmt::format("{}", pick(9));
  if (mnemonic == "PID") return fmt::format("{}", pick(8));
  if (mnemonic == "GPA" || mnemonic == "SPA") return fmt::format("{}", pick(2));
  if (mnemonic == "NOP") return fmt::format("{}", pick(256));
  if (mnemonic == "ATCH" && at == 0) return fmt::format("{}", pick(128));
  return fmt::format("{}", pick(34));  // events
}

std::string SingleCase::operand(const std::string& mnemonic, char letter, std::size_t at) {
  switch (letter) {
    case 'x': return bit(mnemonic, false);
    case 'X': return bit(mnemonic, true);
    case 'k': return number(mnemonic, at);
    case 'p':
    case 'q':
    case 'm': return buffer(mnemonic, letter);
    case 't':
    case 'f': return table(letter);
    case 's': return stringOperand(mnemonic, true);
    case 'S': return stringOperand(mnemonic, false);
    default: break;
  }
  const bool isDigitCount = mnemonic == "ATH" || mnemonic == "HTA" || mnemonic.starts_with("BM") || mnemonic == "FILL";
  if (letter == 'b' && at > 0 && isDigitCount && !oneIn(4)) return fmt::format("{}", pick(17));
  const bool isFormat =
      mnemonic.size() == 3 && mnemonic[1] == 'T' && (mnemonic[2] == 'A' || mnemonic[2] == 'S') && at > 0;
  if (letter == 'b' && isFormat && mnemonic[0] == 'R' && !oneIn(4))
    return fmt::format("16#{:X}", (3 + pick(13)) << 4 | pick(14));
  if (letter == 'b' && isFormat && mnemonic[0] != 'R' && !oneIn(4)) return fmt::format("16#{:X}", pick(15));
  if ((mnemonic == "BIR" && at == 0) || (mnemonic == "BIW" && at == 1))
    return oneIn(3) ? reach(1, 1, at == 1, 0, false) : fmt::format("{}B{}", at == 0 ? "I" : "Q", pick(16));
  if (letter == 'b' && (mnemonic == "STI" || mnemonic == "STD" || mnemonic == "STR" || mnemonic == "SSCPY") &&
      !oneIn(4))
    return fmt::format("{}", pick(8));
  if (letter == 'B' && (mnemonic == "SFND" || mnemonic == "CFND") && !oneIn(4)) {
    put({"VB60", Area::V, 60}, 1, pick(7));
    return "VB60";
  }
  if (letter == 'W' && mnemonic.starts_with("FND") && !oneIn(4)) {
    put({"VW60", Area::V, 60}, 2, pick(4));
    return "VW60";
  }
  if (letter == 'b' && (mnemonic == "S" || mnemonic == "R" || mnemonic == "SI" || mnemonic == "RI") && !oneIn(3))
    return fmt::format("{}", pick(20));
  return value(letter);
}

std::string SingleCase::operandsOf(const std::string& mnemonic, std::string_view signature) {
  std::string text;
  for (std::size_t at = 0; at < signature.size(); ++at)
    text += (at == 0 ? "" : ", ") + operand(mnemonic, signature[at], at);
  return text;
}

}  // namespace rungproof::reference
