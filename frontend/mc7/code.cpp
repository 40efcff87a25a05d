// Decoding.
#include "frontend/mc7/code.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rungproof::mc7 {

namespace {

constexpr std::uint16_t jumpAlways = 0x700B;

std::uint16_t wordAt(std::string_view code, std::size_t at) {
  return static_cast<std::uint16_t>(static_cast<std::uint8_t>(code[at]) << 8 | static_cast<std::uint8_t>(code[at + 1]));
}

class CodeReader {
 public:
  explicit CodeReader(std::string_view code) : code_(code) {}

  DecodedCode read() {
    while (at_ < code_.size() && !result_.fault) item();
    if (!result_.fault) checkTargets();
    return std::move(result_);
  }

 private:
  void fail(std::size_t at, std::string reason) {
    result_.fault = CodeFault{static_cast<std::uint32_t>(at), std::move(reason)};
  }

  void item() {
    if (code_.size() - at_ < 2) return fail(at_, "half a word is left over");
    const std::uint16_t word = wordAt(code_, at_);
    CodeItem item;
    item.opcode = opcodeOf(word);
    item.at = static_cast<std::uint32_t>(at_);
    if (item.opcode == nullptr) return fail(at_, fmt::format("{:04X} is no instruction", word));
    if (code_.size() - at_ < item.opcode->bytes) return fail(at_, "the code ends within an instruction");
    for (std::size_t i = 0; i < item.opcode->bytes; ++i) item.bytes[i] = static_cast<std::uint8_t>(code_[at_ + i]);
    at_ += item.opcode->bytes;
    if (hasParameterList(*item.opcode) && !list(item)) return;
    result_.items.push_back(std::move(item));
  }

  /// A jump over k words, counted from itself, and (k - 2) / 2 pointers.
  bool list(CodeItem& item) {
    if (code_.size() - at_ < 4 || wordAt(code_, at_) != jumpAlways) {
      fail(at_, "no list of parameters stands behind the call");
      return false;
    }
    const std::uint16_t words = wordAt(code_, at_ + 2);
    if (words < 2 || words % 2 != 0 || std::size_t{words} * 2 > code_.size() - at_) {
      fail(at_, "the list of parameters has no possible length");
      return false;
    }
    item.hasList = true;
    for (std::size_t entry = at_ + 4; entry < at_ + std::size_t{words} * 2; entry += 4)
      item.list.push_back(std::uint32_t{wordAt(code_, entry)} << 16 | wordAt(code_, entry + 2));
    at_ += std::size_t{words} * 2;
    return true;
  }

  void checkTargets() {
    for (const CodeItem& item : result_.items) {
      if (item.opcode->form != Form::Jump) continue;
      const auto found = std::ranges::lower_bound(result_.items, item.target(), {},
                                                  [](const CodeItem& one) { return std::int64_t{one.at}; });
      if (found == result_.items.end() || std::int64_t{found->at} != item.target())
        return fail(item.at, fmt::format("{} leads to byte {}, where no instruction begins", item.opcode->mnemonic,
                                         item.target()));
    }
  }

  std::string_view code_;
  std::size_t at_ = 0;
  DecodedCode result_;
};

}  // namespace

std::int64_t CodeItem::target() const {
  if (opcode->mnemonic == "JL") return std::int64_t{at} + 4 + 4 * std::int64_t{word()};
  return std::int64_t{at} + 2 * std::int64_t{static_cast<std::int16_t>(word())};
}

std::size_t DecodedCode::instructionCount() const {
  return items.size() + static_cast<std::size_t>(std::ranges::count_if(items, &CodeItem::hasList));
}

DecodedCode decodeCode(std::string_view code) { return CodeReader(code).read(); }

std::string_view areaLetters(unsigned area, Size size, bool isLoad) {
  constexpr std::array<std::array<std::string_view, 4>, 8> letters = {{{"", "PIB", "PIW", "PID"},
                                                                       {"I", "IB", "IW", "ID"},
                                                                       {"Q", "QB", "QW", "QD"},
                                                                       {"M", "MB", "MW", "MD"},
                                                                       {"DBX", "DBB", "DBW", "DBD"},
                                                                       {"DIX", "DIB", "DIW", "DID"},
                                                                       {"L", "LB", "LW", "LD"},
                                                                       {"V", "VB", "VW", "VD"}}};
  constexpr std::array<std::string_view, 4> outputs = {"", "PQB", "PQW", "PQD"};
  const auto index = static_cast<std::size_t>(size);
  return area == 0 && !isLoad ? outputs[index] : letters[area & 7U][index];
}

}  // namespace rungproof::mc7
