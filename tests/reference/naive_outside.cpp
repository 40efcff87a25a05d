// The naive interpreter: what meets the world outside, as far as it is cheap: clock, immediate bytes, port address,
// attachment of interrupts.
#include "naive.hpp"

namespace rungproof::naive {

namespace {

/// A BCD byte from low to high.
bool isBcdWithin(std::uint32_t byte, std::uint32_t low, std::uint32_t high) {
  const std::uint32_t tens = byte >> 4, ones = byte & 15, number = tens * 10 + ones;
  return tens <= 9 && ones <= 9 && number >= low && number <= high;
}

/// The buffer of TODW and TODWX (001:2935-3005). Byte 6 does not count, bytes 9-18 for mode FF only.
bool isClockData(const std::vector<std::uint32_t>& buffer) {
  static constexpr std::array<std::array<std::uint32_t, 2>, 6> limits = {
      {{0, 99}, {1, 12}, {1, 31}, {0, 23}, {0, 59}, {0, 59}}};
  static constexpr std::array<std::array<std::uint32_t, 2>, 4> moment = {{{1, 12}, {1, 31}, {0, 23}, {0, 59}}};
  bool good = true;
  for (std::size_t k = 0; k < limits.size(); ++k) good = good && isBcdWithin(buffer[k], limits[k][0], limits[k][1]);
  if (buffer.size() == 8) return good && isBcdWithin(buffer[7], 0, 7);
  good = good && isBcdWithin(buffer[7], 1, 7);
  static const std::set<std::uint32_t> modes = {0, 1, 2, 3, 8, 0x10, 0x11, 0x12, 0x13, 0xFF};
  good = good && modes.contains(buffer[8]);
  if (buffer[8] != 0xFF) return good;
  good = good && isBcdWithin(buffer[9], 0, 23) && isBcdWithin(buffer[10], 0, 59);
  for (std::size_t k = 0; k < 8; ++k) good = good && isBcdWithin(buffer[11 + k], moment[k % 4][0], moment[k % 4][1]);
  return good;
}

}  // namespace

bool Interpreter::clockBox(const Instruction& i, const std::string& name) {
  if (name == "BITIM") {
    write(i.operands[0], 4, milliseconds);
    return true;
  }
  if (name == "CITIM") {
    write(i.operands[1], 4, milliseconds - read(i.operands[0], 4));
    return true;
  }
  if (!name.starts_with("TOD")) return false;
  const int size = name.back() == 'X' ? 19 : 8;
  const Operand& buffer = i.operands[0];
  if (!fits(buffer, size, 1)) return fail("0091");
  if (name[3] == 'R') {
    for (int k = 0; k < size; ++k) write(buffer, 1, k == 6 ? 0 : clock[static_cast<std::size_t>(k)], k);
    return true;
  }
  std::vector<std::uint32_t> data;
  for (int k = 0; k < size; ++k) data.push_back(read(buffer, 1, k));
  if (!isClockData(data)) return fail("0007");
  clockSetting.assign(data.begin(), data.end());
  told.push_back("clock " + std::to_string(size));
  return true;
}

/// BIR reads terminals past the image, BIW writes terminals and image; a pointer must lead to I or Q.
bool Interpreter::immediateMove(const Instruction& i, const std::string& name) {
  if (name != "BIR" && name != "BIW") return false;
  const Place place = placeOf(i.operands[name == "BIR" ? 0 : 1]);
  if (place.area != (name == "BIR" ? Area::I : Area::Q)) return fail("0006");
  if (name == "BIR") {
    write(i.operands[1], 1, inputs[place.offset]);
  } else {
    write(i.operands[1], 1, read(i.operands[0], 1));
    outputs[place.offset] = memory[Area::Q][place.offset];
  }
  return true;
}

bool Interpreter::interrupts(const Instruction& i, const std::string& name) {
  if (name == "ENI" || name == "DISI") {
    putBit(Area::SM, 4, 4, name == "ENI");
  } else if (name == "ATCH") {
    routine[static_cast<std::size_t>(i.operands[1].value)] = static_cast<int>(i.operands[0].value) + 1;
    told.push_back("attach " + std::to_string(i.operands[1].value));
  } else if (name == "DTCH") {
    routine[static_cast<std::size_t>(i.operands[0].value)] = 0;
    told.push_back("detach " + std::to_string(i.operands[0].value));
  } else if (name == "CEVNT") {
    told.push_back("clear " + std::to_string(i.operands[0].value));
  } else if (name == "WDR") {
    told.emplace_back("watchdog");
  } else if (name == "DLED") {
    diagnosticLed = read(i.operands[0], 1) != 0;
  } else {
    return false;
  }
  return true;
}

bool Interpreter::ports(const Instruction& i, const std::string& name) {
  if (name != "GPA" && name != "SPA") return false;
  const auto port = static_cast<std::size_t>(i.operands[1].value);
  if (name == "SPA")
    stationAddress[port] = static_cast<std::uint8_t>(read(i.operands[0], 1));
  else
    write(i.operands[0], 1, stationAddress[port]);
  return true;
}

}  // namespace rungproof::naive
