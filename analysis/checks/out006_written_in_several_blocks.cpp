// OUT006: memory written in several blocks. Every writer of a place is compared with every other; what hangs together -
// bits that one instruction writes at once, and of which the same blocks write each - is one range, and all the ranges
// of the same blocks become one finding, outputs apart from memory. Writes
// in the first scan only are initialisation; a flag that an interrupt routine sets and another block resets (or the
// reverse) is a handshake, and between DISI and ENI no interrupt comes; code that never runs writes nothing. Blocks of
// which the text lets one run at a time (exclusion.hpp) may share their outputs; where it leaves that open, the prover
// is asked. Tested by its examples and tests/rules/output_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/bit_ranges.hpp"
#include "analysis/flow/exclusion.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/flow/protected_code.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

constexpr std::size_t mostPlaces = 8;   ///< of one range that are shown beside the finding
constexpr std::size_t mostOthers = 24;  ///< further ranges that are shown beside it

/// Whether what was lost of its network, or of that of a call, may say that it runs in the first scan only.
bool mayBeInitial(const Facts& facts, std::uint32_t id) {
  if (!facts.hasUnreadCode()) return false;
  const std::span<const std::uint32_t> calls = facts.calls().callsOf(facts.blockOf(id));
  return facts.isUnread(id) || std::any_of(calls.begin(), calls.end(), [&](std::uint32_t s) {
           return facts.isUnread(facts.calls().sites()[s].instruction->id);
         });
}

bool counts(const Facts& facts, const Access& access) {
  if (!access.write || access.maybe || access.operand == impliedOperand || access.isBox || access.viaPointer)
    return false;
  if (access.area != Area::Q && access.area != Area::V && access.area != Area::M && access.area != Area::AQ)
    return false;
  const Desc& desc = *facts.instruction(access.instruction).desc;
  if (desc.execution == Execution::Control && desc.control != Control::Call) return false;
  const bool runs = facts.execution().at(access.instruction).isReachable &&
                    facts.execution().runs(facts.blockOf(access.instruction)) != Runs::Never;
  return runs && (facts.conditionOf(access.instruction) & condition::FirstScan) == 0 &&
         !mayBeInitial(facts, access.instruction);
}

/// What an instruction does to a bit, as far as it may be one half of a handshake.
enum class WritingHand : std::uint8_t { Set, Reset, Other };

WritingHand handOf(const Facts& facts, const Access& access) {
  if (access.width != Width::Bit) return WritingHand::Other;
  const Role role = roleOf(facts.instruction(access.instruction));
  return isSet(role) ? WritingHand::Set : isReset(role) ? WritingHand::Reset : WritingHand::Other;
}

/// The bits of a cell that an access writes, one bit each.
unsigned maskOf(const Facts& facts, const Access& access, std::uint32_t cell) {
  if (access.width != Width::Bit) return 0xFF;
  const std::uint32_t low = facts.index().cells().offsetOf(cell) * 8;
  const std::uint32_t from = access.offset * 8 + access.bit, end = from + access.count;
  unsigned mask = 0;
  for (unsigned bit = 0; bit < 8; ++bit) {
    if (low + bit >= from && low + bit < end) mask |= 1U << bit;
  }
  return mask;
}

/// Writers of one block that do the same on the same ways, on one cell.
struct WriterClass {
  std::uint32_t block;
  WritingHand hand;
  bool isProtected;    ///< between DISI and ENI
  std::uint32_t ways;  ///< Exclusion::waysTo
  unsigned mask = 0;
};

bool isInterruptBlock(const Facts& facts, std::uint32_t block) {
  return facts.program().pous[block].kind == PouKind::Interrupt;
}

/// Whether an interrupt routine and the scan keep out of each other's way: interrupts wait, or a flag is handed over.
bool keepApart(const Facts& facts, const WriterClass& a, const WriterClass& b) {
  if (isInterruptBlock(facts, a.block) == isInterruptBlock(facts, b.block)) return false;
  if (a.isProtected || b.isProtected) return true;
  return (a.hand == WritingHand::Set && b.hand == WritingHand::Reset) ||
         (a.hand == WritingHand::Reset && b.hand == WritingHand::Set);
}

/// Whether both only set, or only reset: in any order the same comes of it.
bool doTheSame(const WriterClass& a, const WriterClass& b) { return a.hand == b.hand && a.hand != WritingHand::Other; }

/// Whether the text lets one of the two run at a time.
bool takeTurns(const Facts& facts, const Exclusion& exclusion, const WriterClass& a, const WriterClass& b) {
  return !isInterruptBlock(facts, a.block) && !isInterruptBlock(facts, b.block) && exclusion.exclude(a.ways, b.ways);
}

/// The bits of the cell that two blocks write against each other.
unsigned contested(const Facts& facts, Exclusion& exclusion, const std::vector<std::uint8_t>& isProtected,
                   std::uint32_t cell) {
  std::vector<WriterClass> classes;
  for (const std::uint32_t i : facts.index().at(cell)) {
    const Access& access = facts.access(i);
    if (!counts(facts, access)) continue;
    const WriterClass own{facts.blockOf(access.instruction), handOf(facts, access),
                          isProtected[access.instruction] != 0, exclusion.waysTo(access.instruction)};
    auto found = std::find_if(classes.begin(), classes.end(), [&](const WriterClass& other) {
      return other.block == own.block && other.hand == own.hand && other.isProtected == own.isProtected &&
             other.ways == own.ways;
    });
    if (found == classes.end()) found = classes.insert(classes.end(), own);
    found->mask |= maskOf(facts, access, cell);
  }
  unsigned bits = 0;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    for (std::size_t k = i + 1; k < classes.size(); ++k) {
      const unsigned both = classes[i].mask & classes[k].mask;
      if ((both & ~bits) == 0) continue;  // nothing that is not known already
      if (classes[i].block != classes[k].block && !doTheSame(classes[i], classes[k]) &&
          !keepApart(facts, classes[i], classes[k]) && !takeTurns(facts, exclusion, classes[i], classes[k]))
        bits |= both;
    }
  }
  return bits;
}

/// Contested bits, joined where one instruction writes several of them and the same blocks write each.
class Contested {
 public:
  explicit Contested(const Facts& facts) : facts_(facts) {
    const std::vector<std::uint8_t> isProtected = protectedCode(facts);
    Exclusion exclusion(facts);
    for (std::uint32_t cell = 0; cell < facts.index().cells().size(); ++cell) {
      if (facts.index().at(cell).size() < 2) continue;
      if (!isInSeveralBlocks(cell)) continue;
      const unsigned bits = contested(facts, exclusion, isProtected, cell);
      for (unsigned bit = 0; bit < 8; ++bit) {
        if ((bits >> bit & 1) == 0) continue;
        number_.emplace(cell * 8 + bit, static_cast<std::uint32_t>(keys_.size()));
        keys_.push_back(cell * 8 + bit);
      }
    }
    root_.resize(keys_.size());
    std::iota(root_.begin(), root_.end(), 0U);
    if (keys_.empty()) return;
    for (const Access& access : facts.accesses().all()) {
      if (access.certainLength() <= AccessIndex::longest && counts(facts, access)) join(access);
    }
  }

  struct Group {
    std::vector<std::uint32_t> keys{};
    std::vector<const Access*> writers{};
  };
  /// In the order of their first writers.
  std::vector<Group> groups() {
    std::vector<std::vector<std::uint32_t>> blocks(keys_.size());  // that write the bit
    for (const Writer& writer : writers_) {
      const std::uint32_t block = facts_.blockOf(writer.access->instruction);
      for (std::uint32_t i = writer.first; i < writer.end; ++i) {
        const auto at = std::ranges::lower_bound(blocks[i], block);
        if (at == blocks[i].end() || *at != block) blocks[i].insert(at, block);
      }
    }
    std::map<std::pair<std::uint32_t, std::vector<std::uint32_t>>, std::size_t> place;
    std::vector<std::size_t> groupOf(keys_.size());
    std::vector<Group> groups;
    for (const Writer& writer : writers_) {
      for (std::uint32_t i = writer.first; i < writer.end; ++i) {
        const auto [found, isNew] = place.try_emplace({find(i), blocks[i]}, groups.size());
        if (isNew) groups.emplace_back();
        groupOf[i] = found->second;
        std::vector<const Access*>& writers = groups[found->second].writers;
        if (writers.empty() || writers.back() != writer.access) writers.push_back(writer.access);
      }
    }
    for (std::uint32_t i = 0; i < keys_.size(); ++i) groups[groupOf[i]].keys.push_back(keys_[i]);
    return groups;
  }

 private:
  bool isInSeveralBlocks(std::uint32_t cell) const {
    const auto block = [&](std::uint32_t i) { return facts_.blockOf(facts_.access(i).instruction); };
    const std::span<const std::uint32_t> all = facts_.index().at(cell);
    return std::any_of(all.begin(), all.end(), [&](std::uint32_t i) { return block(i) != block(all.front()); });
  }
  std::uint32_t find(std::uint32_t i) {
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }
  void join(const Access& access) {
    const std::uint32_t start = facts_.cellOf(access);
    if (start == facts_.index().cells().size()) return;
    const bool isBits = access.width == Width::Bit;
    const std::uint32_t first = start * 8 + (isBits ? access.bit : 0U);
    const std::uint32_t end = first + (isBits ? access.count : access.certainLength() * 8);
    auto at = number_.lower_bound(first);
    if (at == number_.end() || at->first >= end) return;
    Writer& writer = writers_.emplace_back(&access, at->second, at->second);
    const std::uint32_t root = find(at->second);
    for (; at != number_.end() && at->first < end; ++at) {
      root_[find(at->second)] = root;
      writer.end = at->second + 1;
    }
  }

  const Facts& facts_;
  std::vector<std::uint32_t> keys_;
  std::map<std::uint32_t, std::uint32_t> number_;  ///< by key: position in keys_
  std::vector<std::uint32_t> root_;
  struct Writer {
    const Access* access;
    std::uint32_t first, end;  ///< positions in keys_ of the bits that it writes
  };
  std::vector<Writer> writers_;
};

struct ContestedName {
  std::string name, address;
  bool isOne;  ///< an operand, not a range
};

/// An operand where the group is just that, else bytes or bits.
ContestedName nameOf(const Facts& facts, const Contested::Group& group) {
  const CellMap& cells = facts.index().cells();
  const Access& sample = *group.writers.front();
  BitRow row{sample.area};
  for (const std::uint32_t key : group.keys)
    row.bits.push_back(bitPosition(sample.area, cells.offsetOf(key / 8), key % 8));
  row.order();
  for (const Access* access : group.writers) {
    const std::uint32_t length = access->width == Width::Bit ? access->count : access->certainLength() * 8;
    const bool isWhole =
        row.bits.size() == length &&
        row.bits.front() == bitPosition(access->area, access->offset, access->width == Width::Bit ? access->bit : 0U);
    if (!isWhole || access->count > 1) continue;
    const Operand& operand = facts.instruction(access->instruction).operands[access->operand];
    return {facts.name(operand), toString(operand), true};
  }
  const bool isBytes = std::all_of(group.writers.begin(), group.writers.end(),
                                   [](const Access* access) { return access->width != Width::Bit; });
  const bool isOneRange = row.bits.back() - row.bits.front() + 1 == row.bits.size();
  if (!isBytes || !isOneRange) return {row.text(), row.first(), row.bits.size() == 1};
  const std::string first = addressName(row.area, Width::Byte, row.bits.front() / 8);
  return {fmt::format("{} to {}", first, addressName(row.area, Width::Byte, row.bits.back() / 8)), first, false};
}

/// The blocks that write a group, each with its first writer.
struct Sharers {
  std::vector<std::uint32_t> blocks{};
  std::vector<const Access*> firsts{};

  Sharers(const Facts& facts, const Contested::Group& group) {
    for (const Access* access : group.writers) {
      const std::uint32_t block = facts.blockOf(access->instruction);
      if (std::find(blocks.begin(), blocks.end(), block) != blocks.end()) continue;
      blocks.push_back(block);
      firsts.push_back(access);
    }
  }
  bool haveInterrupt(const Facts& facts) const {
    return std::any_of(blocks.begin(), blocks.end(), [&](std::uint32_t block) {
      return isInterruptBlock(facts, block) != isInterruptBlock(facts, blocks.front());
    });
  }
  /// Blocks that run in every scan do so in the same one.
  bool runTogether(const Facts& facts) const {
    const auto always = std::count_if(firsts.begin(), firsts.end(), [&](const Access* access) {
      const ExecutionPoint& point = facts.execution().at(access->instruction);
      return !point.isSkipped && !access->conditional &&
             facts.execution().runs(facts.blockOf(access->instruction)) == Runs::Once;
    });
    return always >= 2;
  }
};

/// All that the same blocks write against each other: one finding.
struct Rivalry {
  std::vector<Contested::Group> groups{};
  Sharers sharers;        ///< of the first group
  bool isInterrupted;     ///< one of the blocks is an interrupt routine
  bool runTogether;       ///< two of the blocks write in every scan
  std::string names{};    ///< of the places
  std::string address{};  ///< of the first
  bool isOne = true;      ///< an operand, no range and no list
};

std::vector<Rivalry> rivalries(const Facts& facts) {
  constexpr std::size_t mostNames = 4;
  std::vector<Rivalry> all;
  std::map<std::tuple<std::vector<std::uint32_t>, bool, bool>, std::size_t> place;
  for (Contested::Group& group : Contested(facts).groups()) {
    Sharers sharers(facts, group);
    std::vector<std::uint32_t> blocks = sharers.blocks;
    std::ranges::sort(blocks);
    const Area area = group.writers.front()->area;
    const bool isOutput = area == Area::Q || area == Area::AQ, isInterrupted = sharers.haveInterrupt(facts);
    const bool together = sharers.runTogether(facts);
    const auto [found, isNew] = place.try_emplace({std::move(blocks), isOutput, isInterrupted || together}, all.size());
    if (isNew) all.push_back({.sharers = std::move(sharers), .isInterrupted = isInterrupted, .runTogether = together});
    all[found->second].groups.push_back(std::move(group));
  }
  for (Rivalry& rivalry : all) {
    std::vector<std::string> names;
    for (const Contested::Group& group : rivalry.groups) {
      ContestedName name = nameOf(facts, group);
      if (names.empty()) rivalry.address = name.address;
      rivalry.isOne = rivalry.groups.size() == 1 && name.isOne;
      if (names.size() < mostNames) names.push_back(std::move(name.name));
    }
    if (rivalry.groups.size() > names.size())
      names.push_back(fmt::format("{} more", rivalry.groups.size() - names.size()));
    rivalry.names = joined(names);
  }
  return all;
}

/// The other writers of the first place, then where each further place is written.
void relateRivals(const Facts& facts, const Rivalry& rivalry, Finding& finding) {
  const std::vector<const Access*>& firsts = rivalry.sharers.firsts;
  const auto blockName = [&](const Access& access) {
    return facts.program().pous[facts.blockOf(access.instruction)].name;
  };
  const std::string first = rivalry.groups.size() == 1 ? std::string(rivalry.isOne ? "it" : "them")
                                                       : nameOf(facts, rivalry.groups.front()).name;
  for (std::size_t i = 0; i < std::min(firsts.size(), mostPlaces + 1); ++i) {
    if (i == 1) continue;
    finding.related.push_back({facts.instruction(firsts[i]->instruction).span,
                               fmt::format("{} writes {} here", blockName(*firsts[i]), first)});
  }
  for (std::size_t g = 1; g < rivalry.groups.size() && g <= mostOthers; ++g) {
    const std::string name = nameOf(facts, rivalry.groups[g]).name;
    const Access& access = *Sharers(facts, rivalry.groups[g]).firsts[1];
    finding.related.push_back(
        {facts.instruction(access.instruction).span, fmt::format("{} writes {} here", blockName(access), name)});
  }
}

void checkOut006(const Facts& facts, FindingSink& sink) {
  for (const Rivalry& rivalry : rivalries(facts)) {
    const Access& second = *rivalry.sharers.firsts[1];
    std::vector<std::string> blocks;
    for (const std::uint32_t block : rivalry.sharers.blocks) blocks.push_back("in " + facts.program().pous[block].name);
    Finding& finding =
        sink.report(facts.instruction(second.instruction).operands[second.operand].span,
                    fmt::format("{} {} written {}{}", rivalry.names, rivalry.isOne ? "is" : "are", joined(blocks),
                                rivalry.isInterrupted ? "; the interrupt can come at any point of the scan" : ""));
    finding.address = rivalry.address;
    relateRivals(facts, rivalry, finding);
    finding.help = rivalry.groups.size() == 1 ? "let one block own the place, and give the others a request bit"
                                              : "let one block own each place, and give the others a request bit";
    if (rivalry.isInterrupted || rivalry.runTogether) finding.confirmation = Confirmation::NotNeeded;
  }
}

/// Whether writers of two blocks act on one of the places in one scan.
void askOut006(Asking& asking) {
  const Facts facts(asking.program(), asking.properties().externals);
  Graph& graph = asking.graph();
  for (const Rivalry& rivalry : rivalries(facts)) {
    if (rivalry.isInterrupted || rivalry.runTogether) continue;
    Graph::Bool two = graph.constant(false);
    for (const Contested::Group& group : rivalry.groups) {
      std::map<std::uint32_t, Graph::Bool> acts;  // by block
      for (const Access* access : group.writers) {
        const Asking::Runs* runs = asking.runsOf(facts.instruction(access->instruction));
        if (runs == nullptr) continue;
        const Graph::Bool act = access->conditional && runs->samples(0) ? runs->on[0] : runs->guard;
        Graph::Bool& known = acts.try_emplace(facts.blockOf(access->instruction), graph.constant(false)).first->second;
        known = graph.lor(known, act);
      }
      Graph::Bool some = graph.constant(false);
      for (const auto& [block, act] : acts) {
        two = graph.lor(two, graph.land(some, act));
        some = graph.lor(some, act);
      }
    }
    asking.ask({.name = fmt::format("two blocks write {} in one scan", rivalry.names),
                .message = fmt::format("two blocks write {} in one scan", rivalry.names),
                .address = rivalry.address,
                .place = &facts.instruction(rivalry.sharers.firsts[1]->instruction),
                .bad = two.node});
  }
}

}  // namespace

extern constexpr Rule out006_written_in_several_blocks = {
    .id = "OUT006",
    .title = "Written from several places of the program",
    .severity = Severity::Warning,
    .needs = Needs::FlowThenSolver,
    .detects =
        "one bit or word written in two blocks, or in a block of the scan and in an interrupt routine, unless the text "
        "lets only one of the blocks run at a time; one finding for all that the same blocks write, outputs apart from "
        "memory; a bit that an interrupt routine only sets and other blocks only reset, or the reverse, is a handshake "
        "and stays unreported, and so does what all blocks only set or only reset",
    .why = "the order of the calls decides which value stays, and interrupts come anywhere in the scan",
    .manual = "001:2084, 001:5434-5440",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nCALL SBR0\nNetwork 2\nLD I0.1\n= "
        "Q0.0\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.2\n= Q0.0\nEND_SUBROUTINE_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nCALL SBR0\nNetwork 2\nLD I0.1\nO M0.0\n= "
        "Q0.0\nEND_ORGANIZATION_BLOCK\n"
        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.2\n= M0.0\nEND_SUBROUTINE_BLOCK\n",
    .falsePositives = "blocks that exclude each other in a way that only the prover finds: lint --prove drops them",
    .peers = "SA0006; CP10; CP26; Frama-PLC common outputs of two tasks",
    .check = checkOut006,
    .ask = {.in = asked::Lint, .turn = 72, .cost = 2, .onlySettles = true, .program = askOut006},
};

}  // namespace rungproof
