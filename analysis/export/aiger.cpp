// AIGER: header "aag|aig M I L O A B C", latches with next and reset, bad states, constraints, gates, symbol table.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/export/system.hpp"

namespace rungproof {

std::string exportLine(std::string name) {
  const auto blank = [&](std::size_t at, std::size_t count) { name.replace(at, count, count, ' '); };
  for (std::size_t at = 0; at < name.size(); ++at) {
    const auto byte = [&](std::size_t i) {
      return at + i < name.size() ? static_cast<unsigned char>(name[at + i]) : 0U;
    };
    const unsigned last = byte(2);
    if (byte(0) < 0x20 || byte(0) == 0x7F) blank(at, 1);
    if (byte(0) == 0xC2 && byte(1) >= 0x80 && byte(1) <= 0x9F) blank(at, 2);  // U+0080 to U+009F
    if (byte(0) == 0xD8 && byte(1) == 0x9C) blank(at, 2);                     // U+061C
    const bool isBidi = byte(1) == 0x80 && (last == 0x8E || last == 0x8F || (last >= 0xA8 && last <= 0xAE));
    const bool isIsolate = byte(1) == 0x81 && last >= 0xA6 && last <= 0xA9;  // U+2066 to U+2069
    if (byte(0) == 0xE2 && (isBidi || isIsolate)) blank(at, 3);
  }
  return name;
}

namespace {

/// The same questions over latches that start with 0, without constraints.
BitSystem plainSystem(const BitSystem& bits) {
  BitSystem plain;
  std::vector<Lit> image(bits.variableCount(), falseLit);
  for (std::size_t i = 0; i < bits.inputs.size(); ++i) image[bits.inputs[i]] = plain.addInput(bits.inputNames[i]);
  std::vector<Lit> own;
  for (const Latch& latch : bits.latches) own.push_back(plain.addLatch(latch.name, LatchInit::Zero));
  const bool hasFree =
      std::any_of(bits.latches.begin(), bits.latches.end(), [](const Latch& l) { return l.init == LatchInit::Free; });
  const Lit started = hasFree ? plain.addLatch("started", LatchInit::Zero) : falseLit;
  const Lit broken = bits.constraints.empty() ? falseLit : plain.addLatch("constraint broken", LatchInit::Zero);
  for (std::size_t i = 0; i < bits.latches.size(); ++i) {
    const Latch& latch = bits.latches[i];
    Lit& value = image[latch.variable];
    value = latch.init == LatchInit::One ? negate(own[i]) : own[i];
    if (latch.init == LatchInit::Free) value = plain.addIte(started, own[i], plain.addInput(latch.name + " at start"));
  }
  const auto of = [&](Lit l) { return image[variableOf(l)] ^ (l & 1U); };
  for (std::size_t i = 0; i < bits.gates.size(); ++i)
    image[bits.gateVariables[i]] = plain.addAnd(of(bits.gates[i].left), of(bits.gates[i].right));
  for (std::size_t i = 0; i < bits.latches.size(); ++i) {
    const Lit next = of(bits.latches[i].next);
    plain.setNext(own[i], bits.latches[i].init == LatchInit::One ? negate(next) : next);
  }
  if (hasFree) plain.setNext(started, trueLit);
  Lit kept = negate(broken);
  for (const Lit constraint : bits.constraints) kept = plain.addAnd(kept, of(constraint));
  if (!bits.constraints.empty()) plain.setNext(broken, negate(kept));
  for (const Lit bad : bits.bads) plain.bads.push_back(plain.addAnd(kept, of(bad)));
  return plain;
}

class AigerText {
 public:
  AigerText(const BitSystem& bits, const std::vector<Question>& questions, const ExportRemarks& remarks)
      : bits_(bits), questions_(questions), remarks_(remarks), number_(bits.variableCount(), 0) {
    for (const std::uint32_t v : bits.inputs) number_[v] = ++last_;
    for (const Latch& latch : bits.latches) number_[latch.variable] = ++last_;
    for (const std::uint32_t v : bits.gateVariables) number_[v] = ++last_;
  }

  std::string ascii() const {
    std::string text = header("aag");
    for (const std::uint32_t v : bits_.inputs) text += fmt::format("{}\n", 2 * number_[v]);
    for (const Latch& latch : bits_.latches) {
      const std::uint32_t self = 2 * number_[latch.variable];
      const std::uint32_t reset = latch.init == LatchInit::Free ? self : latch.init == LatchInit::One ? 1 : 0;
      text += fmt::format("{} {} {}\n", self, literal(latch.next), reset);
    }
    text += marked();
    for (std::size_t i = 0; i < bits_.gates.size(); ++i) {
      text += fmt::format("{} {} {}\n", 2 * number_[bits_.gateVariables[i]], literal(bits_.gates[i].right),
                          literal(bits_.gates[i].left));
    }
    return text + symbols();
  }

  /// Inputs are implied; a gate is two differences of literals, seven bits a byte, lowest first.
  std::string binary() const {
    std::string text = header("aig");
    for (const Latch& latch : bits_.latches) text += fmt::format("{}\n", literal(latch.next));
    text += marked();
    for (std::size_t i = 0; i < bits_.gates.size(); ++i) {
      const std::uint32_t self = 2 * number_[bits_.gateVariables[i]], a = literal(bits_.gates[i].left),
                          b = literal(bits_.gates[i].right);
      appendDifference(text, self - std::max(a, b));
      appendDifference(text, std::max(a, b) - std::min(a, b));
    }
    return text + symbols();
  }

 private:
  std::uint32_t literal(Lit l) const { return 2 * number_[variableOf(l)] + (l & 1U); }
  std::string header(const char* magic) const {
    std::string text = fmt::format("{} {} {} {} 0 {} {}", magic, last_, bits_.inputs.size(), bits_.latches.size(),
                                   bits_.gates.size(), bits_.bads.size());
    if (!bits_.constraints.empty()) text += fmt::format(" {}", bits_.constraints.size());
    return text + "\n";
  }
  std::string marked() const {
    std::string text;
    for (const Lit l : bits_.bads) text += fmt::format("{}\n", literal(l));
    for (const Lit l : bits_.constraints) text += fmt::format("{}\n", literal(l));
    return text;
  }
  std::string symbols() const {
    std::string text;
    std::set<std::string> given;  // readers refuse a name that stands twice
    const auto add = [&](char kind, std::size_t i, const std::string& name) {
      const std::string plain = exportLine(name);
      std::string unique = plain;
      for (int k = 2; !given.insert(unique).second; ++k) unique = fmt::format("{}#{}", plain, k);
      text += fmt::format("{}{} {}\n", kind, i, unique);
    };
    for (std::size_t i = 0; i < bits_.inputs.size(); ++i) add('i', i, bits_.inputNames[i]);
    for (std::size_t i = 0; i < bits_.latches.size(); ++i) add('l', i, bits_.latches[i].name);
    for (std::size_t i = 0; i < questions_.size(); ++i) add('b', i, questions_[i].name);
    if (!remarks_.empty()) text += "c\n";
    for (const std::string& remark : remarks_) text += exportLine(remark) + "\n";
    return text;
  }
  static void appendDifference(std::string& text, std::uint32_t difference) {
    for (; difference >= 0x80; difference >>= 7) text += static_cast<char>(0x80 | (difference & 0x7F));
    text += static_cast<char>(difference);
  }

  const BitSystem& bits_;
  const std::vector<Question>& questions_;
  const ExportRemarks& remarks_;
  std::vector<std::uint32_t> number_;  ///< AIGER numbers inputs, then latches, then gates
  std::uint32_t last_ = 0;
};

BitBlast blastAll(const TransitionSystem& system) {
  std::vector<std::size_t> all;
  for (std::size_t q = 0; q < system.questions.size(); ++q) all.push_back(q);
  return BitBlast(system, all);
}

}  // namespace

std::string exportAiger(const TransitionSystem& system, const ExportRemarks& remarks) {
  const BitSystem plain = plainSystem(blastAll(system).bits());
  return AigerText(plain, system.questions, remarks).binary();
}

std::string exportAigerText(const TransitionSystem& system, const ExportRemarks& remarks) {
  const BitBlast blast = blastAll(system);
  return AigerText(blast.bits(), system.questions, remarks).ascii();
}

}  // namespace rungproof
