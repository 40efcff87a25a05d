// The statements of each box, compared instruction by instruction.
#include "ir/s7300/box_match.hpp"

#include <algorithm>

#include "ir/s7300/fbd_box.hpp"
#include "ir/s7300/isa.hpp"

namespace rungproof::s7300 {

namespace {

struct BoxPattern {
  const FbdBox* box = nullptr;
  std::vector<const Desc*> statements;
  Desc drawn;
};

BoxPattern patternOf(const FbdBox& box) {
  BoxPattern pattern;
  pattern.box = &box;
  pattern.drawn.stl = box.name;
  pattern.drawn.meaning = box.title;
  pattern.drawn.eno = true;
  pattern.drawn.execution = Execution::Always;
  pattern.drawn.manual = box.manual;
  for (std::string_view rest = box.statements; !rest.empty();) {
    const std::string_view statement = rest.substr(0, rest.find("; "));
    rest.remove_prefix(std::min(rest.size(), statement.size() + 2));
    const std::size_t blank = statement.find(' ');
    pattern.statements.push_back(s7300Instructions().named(statement.substr(0, blank)));
    if (blank == std::string_view::npos) continue;
    const std::string_view pin = statement.substr(blank + 2);  // behind the $
    const Direction direction = pin == "OUT" ? Direction::Out : Direction::In;
    pattern.drawn.operands[pattern.drawn.operandCount++] = operandDesc(pin, direction, rungproof::Type::Value, 0);
  }
  return pattern;
}

/// The box of a timer whose reset is open.
Desc timerBoxOf(const FbdBox& box) {
  Desc desc;
  desc.stl = box.name;
  desc.meaning = box.title;
  desc.flowPins = {"S"};
  desc.drawingOnly = true;
  desc.execution = Execution::Always;
  desc.manual = box.manual;
  return withOperands(
      desc, {inout("T", rungproof::Type::Timer, 0), in("TV", rungproof::Type::Value, 0),
             optional(out("BI", rungproof::Type::Value, 0)), optional(out("BCD", rungproof::Type::Value, 0))});
}

struct TimerPattern {
  std::string_view start;  ///< SD
  Desc drawn;
};

const std::vector<TimerPattern>& timerPatterns() {
  static const std::vector<TimerPattern> all = [] {
    std::vector<TimerPattern> list;
    for (const FbdBox& box : fbdBoxes()) {
      if (box.frame != BoxFrame::Timer) continue;
      const std::string_view start = box.statements.substr(box.statements.rfind("; ") + 2);
      list.push_back({start.substr(0, start.find(' ')), timerBoxOf(box)});
    }
    return list;
  }();
  return all;
}

const std::vector<BoxPattern>& patterns() {
  static const std::vector<BoxPattern> all = [] {
    std::vector<BoxPattern> list;
    for (const FbdBox& box : fbdBoxes()) {
      if (box.frame == BoxFrame::Enabled || box.frame == BoxFrame::Checked) list.push_back(patternOf(box));
    }
    return list;
  }();
  return all;
}

class BoxMatch {
 public:
  explicit BoxMatch(const Network& network) : network_(network) {}

  std::optional<MatchedBox> of(const BoxPattern& pattern, std::size_t begin) {
    at_ = begin;
    MatchedBox match;
    match.desc = &pattern.drawn;
    const Instruction* jump = take("JNB");
    if (jump == nullptr) return std::nullopt;
    for (const Desc* desc : pattern.statements) {
      const Instruction* statement = take(desc->stl);
      if (statement == nullptr) return std::nullopt;
      match.operands.insert(match.operands.end(), statement->operands.begin(), statement->operands.end());
    }
    if (match.operands.size() != pattern.drawn.operandCount) return std::nullopt;
    const bool keepsEno = ending(pattern.box->frame);
    const Instruction* label = take("LABEL");
    if (label == nullptr || label->operands[0].value != jump->operands[0].value) return std::nullopt;
    match.passesOn = keepsEno && scansBr();
    if (!match.passesOn && take("NOP 0") == nullptr) return std::nullopt;
    match.length = at_ - begin;
    return match;
  }

  std::optional<MatchedBox> of(const TimerPattern& pattern, std::size_t begin) {
    at_ = begin;
    MatchedBox match;
    match.desc = &pattern.drawn;
    const Instruction* value = take("L");
    const Instruction* start = value == nullptr ? nullptr : take(pattern.start);
    if (start == nullptr || take("NOP 0") == nullptr) return std::nullopt;
    const Operand& timer = start->operands[0];
    match.operands = {timer, value->operands[0]};
    for (const std::string_view load : {"L T", "LC T"}) {
      Operand& rest = match.operands.emplace_back();
      if (take("NOP 0") != nullptr) continue;
      const Instruction* loaded = take(load);
      const Instruction* stored = loaded == nullptr ? nullptr : take("T");
      if (stored == nullptr || !isSameNumber(loaded->operands[0], timer)) return std::nullopt;
      rest = stored->operands[0];
    }
    const std::size_t back = at_;
    const Instruction* scan = take("A");
    match.passesOn = scan != nullptr && isSameNumber(scan->operands[0], timer);
    if (!match.passesOn) at_ = back;
    if (!match.passesOn && take("NOP 0") == nullptr) return std::nullopt;
    match.length = at_ - begin;
    return match;
  }

 private:
  static bool isSameNumber(const Operand& a, const Operand& b) {
    return a.kind == OperandKind::Direct && b.kind == OperandKind::Direct && a.area == b.area && a.offset == b.offset;
  }

  const Instruction* take(std::string_view mnemonic) {
    const bool isHere = at_ < network_.instructions.size() && network_.instructions[at_].desc->stl == mnemonic;
    return isHere ? &network_.instructions[at_++] : nullptr;
  }
  /// A bit of the status word, by the name that stands there.
  bool scans(std::string_view mnemonic, std::string_view bit) {
    const std::size_t back = at_;
    const Instruction* scan = take(mnemonic);
    const bool isIt =
        scan != nullptr && scan->operands[0].kind == OperandKind::Constant && scan->operands[0].text == bit;
    if (!isIt) at_ = back;
    return isIt;
  }
  bool scansBr() { return scans("A", "BR"); }
  bool ending(BoxFrame frame) {
    const std::size_t back = at_;
    const bool begins = frame == BoxFrame::Checked ? scans("AN", "OV") : take("SET") != nullptr;
    if (begins && take("SAVE") != nullptr && take("CLR") != nullptr) return true;
    at_ = back;
    return false;
  }

  const Network& network_;
  std::size_t at_ = 0;
};

/// Whether another jump of the network goes where this one goes.
bool isLabelShared(const Network& network, std::size_t at) {
  const Instruction& jump = network.instructions[at];
  return std::ranges::any_of(network.instructions, [&](const Instruction& other) {
    const bool jumps = other.desc->control == Control::Branch || other.desc->control == Control::Distributor;
    return &other != &jump && jumps && other.operands[0].value == jump.operands[0].value;
  });
}

}  // namespace

std::optional<MatchedBox> boxAt(const Network& network, std::size_t at) {
  for (const BoxPattern& pattern : patterns()) {
    std::optional<MatchedBox> match = BoxMatch(network).of(pattern, at);
    if (match) return isLabelShared(network, at) ? std::nullopt : match;
  }
  for (const TimerPattern& pattern : timerPatterns()) {
    if (std::optional<MatchedBox> match = BoxMatch(network).of(pattern, at)) return match;
  }
  return std::nullopt;
}

}  // namespace rungproof::s7300
