// The table of the instructions of the S7-300/400.
#include "ir/s7300/isa.hpp"
#include "ir/s7300/isa/list.hpp"

namespace rungproof {

const InstructionTable& s7300Instructions() {
  static const InstructionTable table(isa::step7::instructionTable, {});
  return table;
}

std::string_view writtenMnemonic(const Desc& desc, bool german) {
  if (desc.stl == "OR") return "O";
  return german && !desc.german.empty() ? desc.german : desc.stl;
}

std::vector<const Desc*> instructionsWritten(std::string_view word, bool international, bool german) {
  std::vector<const Desc*> plain, further;
  for (const Desc& desc : s7300Instructions().all()) {
    if (desc.control == Control::LabelMark || desc.drawingOnly) continue;
    const auto isWritten = [&](bool inGerman) {
      return (inGerman ? german : international) && writtenMnemonic(desc, inGerman) == word;
    };
    const bool isVariant = desc.stl.size() > word.size() && desc.stl.starts_with(word) && desc.stl[word.size()] == ' ';
    if (isWritten(false) || isWritten(true)) {
      plain.push_back(&desc);
    } else if (isVariant) {
      further.push_back(&desc);
    }
  }
  plain.insert(plain.end(), further.begin(), further.end());
  return plain;
}

}  // namespace rungproof
