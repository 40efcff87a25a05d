// Collects the panel's words and follows what the program does with each.
#include "analysis/panel/panel_words.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <unordered_map>

namespace rungproof {

namespace {

/// Parts of words, in small letters; Cyrillic ones in both spellings of their first letter.
constexpr std::array setParts = {"setpoint", "sollwert", "vorgabe", "eingabe", "preset", "recipe", "rezept",
                                 "param",    "уставк",   "Уставк",  "задан",   "Задан",  "рецепт", "Рецепт",
                                 "ввод",     "Ввод",     "设定",    "设置",    "配方",   "参数",   "给定"};
constexpr std::array setWords = {"set", "sp", "soll", "setting", "entry"};
constexpr std::array panelParts = {"hmi",   "panel", "touch",  "display unit", "bedienger",
                                   "панел", "Панел", "触摸屏", "人机",         "文本屏"};

bool isPanelLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
char asSmall(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::string smallLetters(std::string_view text) {
  std::string result;
  for (const char c : text) result += asSmall(c);
  return result;
}

template <class Parts>
bool holdsPart(std::string_view text, const Parts& parts) {
  return std::ranges::any_of(parts, [&](const char* part) { return text.find(part) != std::string_view::npos; });
}

/// "set" in "Speed_Set", "SpeedSet" and "set speed", not in "offset".
bool holdsWord(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    if (!isPanelLetter(text[i])) {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    const auto isSmall = [&](std::size_t k) { return text[k] >= 'a' && text[k] <= 'z'; };
    while (end < text.size() && isPanelLetter(text[end]) && !(isSmall(end - 1) && !isSmall(end))) ++end;
    const std::string word = smallLetters(text.substr(i, end - i));
    if (std::ranges::find(setWords, word) != setWords.end()) return true;
    i = end;
  }
  return false;
}

bool isChangedInPlace(const Instruction& instruction, const Access& access) {
  const Desc& desc = *instruction.desc;
  return desc.control != Control::Call && access.operand < desc.operandCount &&
         desc.operands[access.operand].direction == Direction::InOut;
}

/// Whether the value that is written comes from memory: neither a default nor a limit written as a constant.
bool isComputedValue(const Instruction& instruction, const Access& access) {
  if (instruction.desc->control == Control::Call) return true;
  for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
    if (i != access.operand && instruction.operands[i].isMemory()) return true;
  }
  return instruction.operands.size() == 1;
}

class ConflictFinder {
 public:
  ConflictFinder(const Facts& facts, const std::vector<PanelWord>& words) : facts_(facts), words_(words) {
    for (std::uint32_t w = 0; w < words.size(); ++w) {
      for (std::uint32_t k = 0; k < words[w].bytes; ++k) {
        const std::uint32_t cell = cells().cell(words[w].address.area, words[w].address.offset + k, 0);
        if (cell != cells().size()) byCell_[cell].push_back(w);
      }
    }
  }

  PanelConflicts run() {
    if (words_.empty()) return {};
    gather();
    for (const std::uint64_t key : order_) wordOfProgram(uses_.at(key));
    for (const PanelWord& word : words_) {
      if (word.access != TagAccess::Sets) continue;
      if (word.isBit())
        bitOfPanel(word);
      else if (!word.isRow && !word.isText)
        lostWord(word);
    }
    return std::move(conflicts_);
  }

 private:
  using Uses = std::vector<const Access*>;
  const CellMap& cells() const { return facts_.index().cells(); }

  /// Words, bytes and double words of the program that touch one of the panel, each with its accesses.
  void gather() {
    for (const Access& access : facts_.accesses().all()) {
      if (access.viaPointer || access.maybe || access.byNumber() || access.width == Width::Bit || access.most > 1 ||
          access.operand == impliedOperand || access.area == Area::L)
        continue;
      const std::uint32_t cell = facts_.cellOf(access);
      bool touches = false;
      for (std::uint32_t k = 0; k < access.certainLength(); ++k) touches = touches || byCell_.contains(cell + k);
      if (!touches || cell == cells().size()) continue;
      Uses& uses = uses_[keyOf(cell, access.width)];
      if (uses.empty()) order_.push_back(keyOf(cell, access.width));
      uses.push_back(&access);
    }
  }
  static std::uint64_t keyOf(std::uint32_t cell, Width width) {
    return std::uint64_t{cell} << 4 | static_cast<std::uint64_t>(width);
  }
  bool isUsed(Area area, std::uint32_t offset, Width width) const {
    return uses_.contains(keyOf(cells().cell(area, offset, 0), width));
  }
  bool isTouched(Area area, std::uint32_t first, std::uint32_t count) const {
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t cell = cells().cell(area, first + k, 0);
      if (cell == cells().size() || facts_.index().mayBeRead(cell) || facts_.index().mayBeWritten(cell)) return true;
    }
    return false;
  }

  void wordOfProgram(const Uses& uses) {
    const Access& use = *uses.front();
    const std::uint32_t cell = facts_.cellOf(use), length = use.certainLength();
    std::set<std::uint32_t> met;
    std::uint32_t inRows = 0, inRanges = 0;
    for (std::uint32_t k = 0; k < length; ++k) {
      const auto found = byCell_.find(cell + k);
      if (found == byCell_.end()) continue;
      met.insert(found->second.begin(), found->second.end());
      const auto holds = [&](bool PanelWord::*kind) {
        return std::ranges::any_of(found->second, [&](std::uint32_t w) { return words_[w].*kind; });
      };
      inRows += holds(&PanelWord::isRow) ? 1 : 0;
      inRanges += holds(&PanelWord::isOfRange) ? 1 : 0;
    }
    for (const std::uint32_t w : met) {
      const PanelWord& word = words_[w];
      if (word.isBit()) continue;
      if (word.isRow) {
        if (inRows == length)
          ofPanel(direct(use.area, use.width, use.offset), word, uses);
        else
          crossing(direct(use.area, Width::Byte, std::max(use.offset, word.address.offset)), word, use);
        break;
      }
      if (word.address.offset == use.offset && word.address.width == use.width)
        ofPanel(word.address, word, uses);
      else if (isMistaken(word, use) && (inRanges < length || use.offset != words_[*met.begin()].address.offset))
        crossing(word.address, word, use);
    }
  }

  /// Whether a word of the program and one of the panel that share bytes cannot be meant so. The low part of a larger
  /// number is often shown alone, and the parts of a word are bytes that the program packs.
  bool isMistaken(const PanelWord& word, const Access& use) const {
    if (word.isText || isUsed(use.area, word.address.offset, word.address.width)) return false;
    const std::uint32_t from = use.offset, to = from + use.certainLength();
    const std::uint32_t first = word.address.offset, last = first + word.bytes;
    const bool isInside = first <= from && to <= last, isAround = from <= first && last <= to;
    if (!isInside && !isAround) return true;
    if (from != first) return isAround && to != last;
    return isAround || !isTouched(use.area, to, last - to);
  }

  void crossing(Operand address, const PanelWord& word, const Access& use) {
    const std::string name = toString(address);
    if (crossed_.insert(name).second) conflicts_.crossing.push_back({std::move(address), &word, &use});
  }

  void ofPanel(Operand address, const PanelWord& word, const Uses& uses) {
    if (word.access == TagAccess::Reads) return;
    const Instruction* reader = nullptr;
    for (const Access* access : uses) {
      const Instruction& instruction = facts_.instruction(access->instruction);
      if (!access->write && !isChangedInPlace(instruction, *access)) reader = reader == nullptr ? &instruction : reader;
    }
    if (reader == nullptr) return;  // it is only shown
    const Instruction* first = nullptr;
    std::set<std::pair<std::uint32_t, std::uint32_t>> lives;
    for (const Access* access : uses) {
      if (!access->write || !overwrites(*access)) continue;
      const bool isConsumed = isReadBehind(*access, uses);
      if (!isConsumed && (word.access != TagAccess::Sets || !runsAlways(access->instruction))) continue;
      const InstructionPlace& place = facts_.place(access->instruction);
      lives.emplace(place.block, place.network);
      if (first == nullptr) first = place.instruction;
    }
    // A tag list does not say who writes: the result of one chain may be shown, but not that of two.
    const std::size_t needed = word.access == TagAccess::Sets ? 1 : 2;
    if (lives.size() >= needed && shared_.insert(toString(address)).second)
      conflicts_.shared.push_back({std::move(address), &word, first, reader});
  }

  /// A computed value that takes the place of the panel's: no default, no limit, nothing that comes once.
  bool overwrites(const Access& access) const {
    const Instruction& instruction = facts_.instruction(access.instruction);
    if (isChangedInPlace(instruction, access) || !isComputedValue(instruction, access)) return false;
    if (!facts_.execution().at(instruction.id).isReachable) return false;
    if ((facts_.conditionOf(instruction.id) & (condition::FirstScan | condition::Pulse | condition::Never)) != 0)
      return false;
    return !asksItself(access);
  }
  bool runsAlways(std::uint32_t id) const {
    return (facts_.stack().at(id).flow & condition::Always) != 0 && !facts_.execution().at(id).isSkipped &&
           facts_.execution().runs(facts_.blockOf(id)) == Runs::Once;
  }
  /// Whether contacts in front of it in its network look at the place: it is limited or acknowledged.
  bool asksItself(const Access& access) const {
    const InstructionPlace& place = facts_.place(access.instruction);
    const Flow& flow = facts_.plan().flows[place.block];
    for (std::uint32_t at = place.step; at > 0 && flow.steps[at - 1].network == place.network; --at) {
      const Instruction& earlier = *flow.steps[at - 1].instruction;
      if (isContact(roleOf(earlier)) && reads(earlier, access)) return true;
    }
    return false;
  }
  bool reads(const Instruction& instruction, const Access& place) const {
    return std::ranges::any_of(facts_.accesses().of(instruction.id), [&](const Access& a) {
      return !a.write && !a.viaPointer && a.area == place.area && a.offset < place.offset + place.certainLength() &&
             place.offset < a.offset + a.certainLength() &&
             (a.width != Width::Bit || place.width != Width::Bit || a.bit == place.bit);
    });
  }
  /// Whether a later instruction of the same network takes the value on.
  bool isReadBehind(const Access& write, const Uses& uses) const {
    const InstructionPlace& place = facts_.place(write.instruction);
    return std::ranges::any_of(uses, [&](const Access* access) {
      const InstructionPlace& other = facts_.place(access->instruction);
      return !access->write && other.block == place.block && other.network == place.network &&
             other.step > place.step && !isChangedInPlace(*other.instruction, *access);
    });
  }

  /// A word that the program reads, and of which it has written a part in every scan before: by a move of whatever
  /// width, a block move, a fill. What the panel sets is never seen. Where something reads it first, the write may be
  /// the answer to it.
  void lostWord(const PanelWord& word) {
    const Access* reader = nullptr;
    std::vector<const Access*> reads, writes;
    for (std::uint32_t k = 0; k < word.bytes; ++k) {
      const std::uint32_t cell = cells().cell(word.address.area, word.address.offset + k, 0);
      if (cell == cells().size()) return;
      for (const std::uint32_t i : facts_.index().at(cell)) {
        const Access& access = facts_.access(i);
        if (access.maybe) return;
        const bool isInPlace = isChangedInPlace(facts_.instruction(access.instruction), access);
        const bool isWord = access.offset == word.address.offset && access.width == word.address.width;
        if (!access.write) reads.push_back(&access);
        if (!access.write && isWord && !isInPlace) reader = &access;
        if (access.write && !isInPlace && access.width != Width::Bit && runsAlways(access.instruction) &&
            !asksItself(access))
          writes.push_back(&access);
      }
    }
    if (reader == nullptr) return;
    for (const Access* write : writes) {
      const InstructionPlace& place = facts_.place(write->instruction);
      const bool isFirst = std::ranges::all_of(reads, [&](const Access* read) {
        const InstructionPlace& other = facts_.place(read->instruction);
        return other.block == place.block && other.step > place.step;
      });
      if (!isFirst || !shared_.insert(toString(word.address)).second) continue;
      conflicts_.shared.push_back({word.address, &word, place.instruction, &facts_.instruction(reader->instruction)});
      return;
    }
  }

  /// A coil gives the bit its own value in every scan.
  void bitOfPanel(const PanelWord& word) {
    const std::uint32_t cell = cells().cell(word.address.area, word.address.offset, 0);
    if (cell == cells().size()) return;
    const Instruction* writer = nullptr;
    for (const std::uint32_t i : facts_.bits().at(cell * 8 + word.address.bit)) {
      const Access& access = facts_.access(i);
      const Instruction& instruction = facts_.instruction(access.instruction);
      if (isCoil(roleOf(instruction)) && facts_.execution().at(instruction.id).isReachable && !asksItself(access))
        writer = writer == nullptr ? &instruction : writer;
    }
    if (writer == nullptr) return;
    for (const std::uint32_t i : facts_.index().at(cell)) {
      const Access& access = facts_.access(i);
      const bool isThis = access.width == Width::Bit && !access.write && access.bit == word.address.bit;
      if (!isThis || !shared_.insert(toString(word.address)).second) continue;
      conflicts_.shared.push_back({word.address, &word, writer, &facts_.instruction(access.instruction)});
    }
  }

  const Facts& facts_;
  const std::vector<PanelWord>& words_;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> byCell_;
  std::unordered_map<std::uint64_t, Uses> uses_;
  std::vector<std::uint64_t> order_;
  std::set<std::string> shared_, crossed_;
  PanelConflicts conflicts_;
};

void addPanelRange(std::vector<PanelWord>& words, const ExternalRange& range) {
  PanelWord word{.address = range.first, .declared = range.span};
  if (hasBitAndWord(range.first.area)) return;
  if (range.first.width == Width::Byte && range.last.offset > range.first.offset) {
    word.bytes = range.last.offset + 1 - range.first.offset;
    word.isRow = true;
    words.push_back(std::move(word));
    return;
  }
  word.bytes = static_cast<std::uint32_t>(rungproof::bytes(range.first.width));
  if (range.first.width == Width::Bit && toString(range.first) != toString(range.last)) return;
  word.isOfRange = range.last.offset > range.first.offset;
  for (; word.address.offset <= range.last.offset; word.address.offset += word.bytes) words.push_back(word);
}

}  // namespace

bool speaksOfSetting(std::string_view text) { return holdsPart(smallLetters(text), setParts) || holdsWord(text); }

std::vector<PanelWord> panelWords(const Facts& facts) {
  std::vector<PanelWord> words;
  for (const ExternalRange& range : facts.externals()) {
    if (!range.isPanelTag) addPanelRange(words, range);
  }
  const auto add = [&](const Operand& address, TagAccess access, std::string name, Span declared, bool isText) {
    if (address.kind != OperandKind::Direct || addressedByNumber(address.area) || isAnalogue(address.area)) return;
    words.push_back({.address = address,
                     .bytes = static_cast<std::uint32_t>(rungproof::bytes(address.width)),
                     .access = access,
                     .isText = isText,
                     .name = std::move(name),
                     .declared = declared});
  };
  for (const PanelTag& tag : facts.surroundings().tags)
    add(tag.address, tag.access, tag.name, tag.span, tag.type == TagType::Text);
  for (const Symbol& symbol : facts.program().symbols) {
    const std::string comment = smallLetters(symbol.comment);
    if (isMemoryArea(symbol.address.area) && holdsPart(comment, panelParts) && speaksOfSetting(symbol.comment))
      add(symbol.address, TagAccess::Sets, symbol.name, symbol.span, false);
  }
  return words;
}

PanelConflicts panelConflicts(const Facts& facts, const std::vector<PanelWord>& words) {
  return ConflictFinder(facts, words).run();
}

}  // namespace rungproof
