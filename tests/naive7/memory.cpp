// How the naive interpreter finds and reaches memory: direct addresses, local names, pointers in memory and in address
// registers, big-endian bytes, the ends of each area.
#include <cctype>

#include "tests/naive7/machine.hpp"

namespace naive7 {
namespace {

/// "10.3" -> 83, "12" -> 96.
std::uint32_t bitAddress(const std::string& text) {
  const std::size_t dot = text.find('.');
  const auto byte = static_cast<std::uint32_t>(std::atoi(text.c_str()));
  return byte * 8 + (dot == std::string::npos ? 0 : static_cast<std::uint32_t>(std::atoi(text.c_str() + dot + 1)));
}

/// Area and width of the letters before a number: "DBW" is D and 16; false if they are no area.
bool areaLetters(const std::string& letters, char& area, bool& isInstance, int& width) {
  struct Row {
    const char* prefix;
    char area;
    bool isInstance;
  };
  static const Row rows[] = {{"PI", 'P', false}, {"PQ", 'P', false}, {"DB", 'D', false}, {"DI", 'D', true},
                             {"I", 'I', false},  {"Q", 'Q', false},  {"M", 'M', false},  {"L", 'L', false}};
  for (const Row& row : rows) {
    if (!letters.starts_with(row.prefix)) continue;
    const std::string rest = letters.substr(std::string(row.prefix).size());
    area = row.area;
    isInstance = row.isInstance;
    if (row.area == 'D' ? rest == "X" : rest.empty() && row.area != 'P') {
      width = 1;
    } else if (rest == "B") {
      width = 8;
    } else if (rest == "W") {
      width = 16;
    } else if (rest == "D") {
      width = 32;
    } else {
      continue;
    }
    return true;
  }
  return false;
}

std::string lettersOf(const std::string& text) {
  std::size_t n = 0;
  while (n < text.size() && std::isalpha(static_cast<unsigned char>(text[n])) != 0) ++n;
  return text.substr(0, n);
}

}  // namespace

Place Machine::direct(const std::string& text) const {
  Place p;
  std::string rest = text;
  int block = 0;
  const std::size_t dot = rest.find('.');
  const bool isFull = rest.starts_with("DB") && dot != std::string::npos && dot + 1 < rest.size() &&
                      std::isalpha(static_cast<unsigned char>(rest[dot + 1])) != 0;
  if (isFull) {
    block = std::atoi(rest.c_str() + 2);
    rest = rest.substr(dot + 1);
  }
  const std::string letters = lettersOf(rest);
  bool isInstance = false;
  if (!areaLetters(letters, p.area, isInstance, p.width)) throw Stop{0xFF, "no address: " + text};
  p.bit = bitAddress(rest.substr(letters.size()));
  if (p.area == 'D') p.number = isFull ? block : isInstance ? di : db;
  if (p.area == 'L') p.number = static_cast<int>(frames_.size()) - 1;
  return p;
}

Place Machine::local(const std::string& name) const {
  const Frame& f = frames_.back();
  if (const auto found = f.references.find(name); found != f.references.end()) return found->second;
  for (const Variable& v : f.block->variables) {
    if (v.name != name) continue;
    Place p;
    p.width = widthOfType(v.type);
    if (v.section == Section::Temp) {
      p.area = 'L';
      p.number = static_cast<int>(frames_.size()) - 1;
      p.bit = v.bit;
    } else {
      p.area = 'D';
      p.number = f.instance;
      p.bit = f.base + v.bit;
    }
    return p;
  }
  throw Stop{0xFF, "no local name: " + name};
}

std::uint32_t Machine::pointerOf(const std::string& inside) const {
  if (inside.starts_with("AR1,") || inside.starts_with("AR2,")) {
    return ar[inside[2] - '1'] + bitAddress(inside.substr(6));
  }
  return read(place(inside));
}

Place Machine::crossing(std::uint32_t pointer, int width) const {
  Place p;
  p.width = width;
  p.bit = pointer & 0x7FFFF;
  const std::uint32_t code = pointer >> 24 & 7;
  const char areas[] = {'P', 'I', 'Q', 'M', 'D', 'D', 'L', 'L'};
  if ((pointer & 0x80000000U) == 0) throw Stop{0x24, "pointer without area"};
  p.area = areas[code];
  const int depth = static_cast<int>(frames_.size());
  p.number = code == 4 ? db : code == 5 ? di : code == 6 ? depth - 1 : code == 7 ? depth - 2 : 0;
  return p;
}

Place Machine::place(const std::string& operand) const {
  if (operand.starts_with("#")) return local(operand.substr(1));
  const std::size_t open = operand.find('[');
  if (open == std::string::npos) return direct(operand);
  const std::string letters = operand.substr(0, open);
  const std::uint32_t pointer = pointerOf(operand.substr(open + 1, operand.size() - open - 2));
  if (letters.empty() || letters == "B" || letters == "W" || letters == "D") {
    return crossing(pointer, letters.empty() ? 1 : letters == "B" ? 8 : letters == "W" ? 16 : 32);
  }
  Place p;
  bool isInstance = false;
  if (!areaLetters(letters, p.area, isInstance, p.width)) throw Stop{0xFF, "no address: " + operand};
  p.bit = pointer & 0x7FFFF;
  if (p.area == 'D') p.number = isInstance ? di : db;
  if (p.area == 'L') p.number = static_cast<int>(frames_.size()) - 1;
  return p;
}

std::uint32_t Machine::read(const Place& p, int fault) const {
  if (p.isConstant) return p.value;
  if (p.width > 1 && p.bit % 8 != 0) throw Stop{0x28, "bit address of a byte"};
  const std::vector<std::uint8_t>* bytes = nullptr;
  switch (p.area) {
    case 'I': bytes = &inputs; break;
    case 'Q': bytes = &outputs; break;
    case 'M': bytes = &memory; break;
    case 'P': bytes = &peripheralIn; break;
    case 'L': bytes = &frames_.at(static_cast<std::size_t>(p.number)).local; break;
    default: {
      const auto found = dataBlocks.find(p.number);
      if (found == dataBlocks.end()) throw Stop{0x3A, "no data block"};
      bytes = &found->second;
    }
  }
  const std::size_t byte = p.bit / 8, count = p.width == 1 ? 1 : static_cast<std::size_t>(p.width) / 8;
  if (byte + count > bytes->size()) throw Stop{fault, "beyond the area"};
  if (p.width == 1) return (*bytes)[byte] >> p.bit % 8 & 1U;
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < count; ++i) value = value << 8 | (*bytes)[byte + i];
  return value;
}

void Machine::write(const Place& p, std::uint32_t value) {
  if (p.isConstant) throw Stop{0xFF, "a constant is written"};
  if (p.width > 1 && p.bit % 8 != 0) throw Stop{0x29, "bit address of a byte"};
  std::vector<std::uint8_t>* bytes = nullptr;
  switch (p.area) {
    case 'I': bytes = &inputs; break;
    case 'Q': bytes = &outputs; break;
    case 'M': bytes = &memory; break;
    case 'P': bytes = &peripheralOut; break;
    case 'L': bytes = &frames_.at(static_cast<std::size_t>(p.number)).local; break;
    default: {
      const auto found = dataBlocks.find(p.number);
      if (found == dataBlocks.end()) throw Stop{0x3A, "no data block"};
      bytes = &found->second;
    }
  }
  const std::size_t byte = p.bit / 8, count = p.width == 1 ? 1 : static_cast<std::size_t>(p.width) / 8;
  if (byte + count > bytes->size()) throw Stop{0x23, "beyond the area"};
  if (p.width == 1) {
    const auto mask = static_cast<std::uint8_t>(1U << p.bit % 8);
    (*bytes)[byte] = static_cast<std::uint8_t>(value != 0 ? (*bytes)[byte] | mask : (*bytes)[byte] & ~mask);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto one = static_cast<std::uint8_t>(value >> 8 * (count - 1 - i));
    (*bytes)[byte + i] = one;
    if (p.area == 'P' && byte + i < outputs.size()) outputs[byte + i] = one;  // the image follows
  }
}

int Machine::objectNumber(const std::string& operand, char letter) const {
  if (operand.starts_with("#")) return static_cast<int>(local(operand.substr(1)).value);
  if (operand.empty() || operand[0] != letter) throw Stop{0xFF, "no timer or counter: " + operand};
  if (operand[1] == '[') return static_cast<int>(read(place(operand.substr(2, operand.size() - 3))));
  return std::atoi(operand.c_str() + 1);
}

void Machine::openFor(const std::string& operand) {
  const std::size_t dot = operand.find('.');
  if (!operand.starts_with("DB") || dot == std::string::npos || dot + 1 >= operand.size()) return;
  if (std::isalpha(static_cast<unsigned char>(operand[dot + 1])) == 0) return;
  const int number = std::atoi(operand.c_str() + 2);
  if (!dataBlocks.contains(number)) throw Stop{0x3A, "no data block"};
  db = number;
}

}  // namespace naive7
