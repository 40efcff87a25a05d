// Equal texts first, then the longest common subsequence of what is left in between.
#include "analysis/equivalence/network_match.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "ir/desc.hpp"
#include "ir/flow.hpp"

namespace rungproof {

namespace {

/// A network as the list of its instructions in the words of OLD.
struct NetworkShape {
  NetworkRef where;
  std::vector<std::string> lines;
  std::vector<std::uint32_t> ids;
  std::vector<bool> onlyReads;  ///< contacts and operations on the stack
  std::string key;              ///< block and lines
  bool isPaired = false;
};

std::string blockName(const Pou& pou) {
  return (pou.kind == PouKind::Main         ? "MAIN"
          : pou.kind == PouKind::Subroutine ? "SBR"
                                            : "INT") +
         std::to_string(pou.kind == PouKind::Main ? 0 : pou.number);
}

std::vector<NetworkShape> networkShapesOf(const Program& program, const AddressPairs& pairs) {
  std::vector<NetworkShape> shapes;
  for (std::size_t p = 0; p < program.pous.size(); ++p) {
    for (std::size_t n = 0; n < program.pous[p].networks.size(); ++n) {
      NetworkShape& shape = shapes.emplace_back();
      shape.where = {p, n};
      for (const Instruction& instruction : program.pous[p].networks[n].instructions) {
        shape.lines.push_back(textInOld(instruction, pairs));
        shape.ids.push_back(instruction.id);
        shape.onlyReads.push_back(isLogic(roleOf(instruction)));
        shape.key += shape.lines.back() + '\n';
      }
    }
  }
  return shapes;
}

/// Index pairs of a longest common subsequence.
template <class Same>
std::vector<std::pair<std::size_t, std::size_t>> commonSubsequence(std::size_t n, std::size_t m, Same&& same) {
  std::size_t head = 0;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  while (head < n && head < m && same(head, head)) {
    pairs.emplace_back(head, head);
    ++head;
  }
  const std::size_t rows = n - head, columns = m - head;
  std::vector<std::uint32_t> best((rows + 1) * (columns + 1), 0);
  const auto at = [&](std::size_t i, std::size_t j) -> std::uint32_t& { return best[i * (columns + 1) + j]; };
  for (std::size_t i = rows; i-- > 0;) {
    for (std::size_t j = columns; j-- > 0;)
      at(i, j) = same(head + i, head + j) ? at(i + 1, j + 1) + 1 : std::max(at(i + 1, j), at(i, j + 1));
  }
  for (std::size_t i = 0, j = 0; i < rows && j < columns;) {
    if (same(head + i, head + j)) {
      pairs.emplace_back(head + i++, head + j++);
    } else if (at(i + 1, j) >= at(i, j + 1)) {
      ++i;
    } else {
      ++j;
    }
  }
  return pairs;
}

class Matcher {
 public:
  Matcher(const Program& before, const Program& after, const AddressPairs& pairs)
      : before_(before), after_(after), old_(networkShapesOf(before, {})), new_(networkShapesOf(after, pairs)) {
    result_.beforeOf.assign(after.instructionCount(), noPartner);
    partner_.resize(new_.size());
  }

  ProgramMatch run() {
    pairEqual(true);
    pairEqual(false);
    for (const Likeness least : {Likeness::Half, Likeness::Result, Likeness::Title}) {
      for (std::size_t p = 0; p < after_.pous.size(); ++p) pairSimilar(p, least);
    }
    write();
    return std::move(result_);
  }

 private:
  /// Networks of equal text, the k-th with the k-th; `inBlock`: of the same block only.
  void pairEqual(bool inBlock) {
    std::map<std::string, std::vector<std::size_t>> open;
    for (std::size_t i = old_.size(); i-- > 0;) {
      if (!old_[i].isPaired) open[keyOf(before_, old_[i], inBlock)].push_back(i);
    }
    for (std::size_t j = 0; j < new_.size(); ++j) {
      if (new_[j].isPaired) continue;
      const auto found = open.find(keyOf(after_, new_[j], inBlock));
      if (found == open.end() || found->second.empty()) continue;
      pair(found->second.back(), j);
      found->second.pop_back();
    }
  }
  static std::string keyOf(const Program& program, const NetworkShape& shape, bool inBlock) {
    return inBlock ? blockName(program.pous[shape.where.pou]) + '\n' + shape.key : shape.key;
  }
  void pair(std::size_t i, std::size_t j) {
    old_[i].isPaired = new_[j].isPaired = true;
    partner_[j] = i;
    std::vector<std::pair<std::size_t, std::size_t>> pairs =
        commonSubsequence(old_[i].lines.size(), new_[j].lines.size(),
                          [&](std::size_t a, std::size_t b) { return old_[i].lines[a] == new_[j].lines[b]; });
    pairs.emplace_back(old_[i].lines.size(), new_[j].lines.size());
    std::size_t fromOld = 0,
                fromNew = 0;  // what lies between two pairs stands at the same places if it has the same names
    for (const auto& [a, b] : pairs) {
      bool isAlike = a - fromOld == b - fromNew;
      for (std::size_t k = 0; isAlike && fromOld + k < a; ++k)
        isAlike = nameIn(old_[i].lines[fromOld + k]) == nameIn(new_[j].lines[fromNew + k]);
      for (std::size_t k = 0; isAlike && fromOld + k < a; ++k)
        result_.beforeOf[new_[j].ids[fromNew + k]] = old_[i].ids[fromOld + k];
      if (a < old_[i].lines.size()) result_.beforeOf[new_[j].ids[b]] = old_[i].ids[a];
      fromOld = a + 1;
      fromNew = b + 1;
    }
  }
  static std::string nameIn(const std::string& line) { return line.substr(0, line.find(' ')); }

  /// Half of the instructions in common, or at least one that does more than read, or the title alone.
  enum class Likeness : std::uint8_t { Half, Result, Title };
  bool isSameTitle(const NetworkShape& old, const NetworkShape& other) const {
    const auto& title = before_.pous[old.where.pou].networks[old.where.network].title;
    return !title.empty() && title == after_.pous[other.where.pou].networks[other.where.network].title;
  }
  static bool shareResult(const NetworkShape& old, const NetworkShape& other) {
    for (std::size_t i = 0; i < old.lines.size(); ++i) {
      if (!old.onlyReads[i] && std::ranges::find(other.lines, old.lines[i]) != other.lines.end()) return true;
    }
    return false;
  }

  /// What is left of a block: a network of NEW with the network of OLD that drives the same; among several with the one
  /// that has the same title, and then with the one that it shares most instructions with.
  void pairSimilar(std::size_t pou, Likeness least) {
    using Nearness = std::tuple<bool, bool, std::size_t>;
    for (std::size_t j = 0; j < new_.size(); ++j) {
      if (new_[j].isPaired || new_[j].where.pou != pou) continue;
      Nearness most{false, false, 0};
      std::size_t found = old_.size();
      for (std::size_t i = 0; i < old_.size(); ++i) {
        if (old_[i].isPaired || blockName(before_.pous[old_[i].where.pou]) != blockName(after_.pous[pou])) continue;
        const std::size_t common =
            commonSubsequence(old_[i].lines.size(), new_[j].lines.size(), [&](std::size_t a, std::size_t b) {
              return old_[i].lines[a] == new_[j].lines[b];
            }).size();
        const bool hasResult = shareResult(old_[i], new_[j]), hasTitle = isSameTitle(old_[i], new_[j]);
        const bool isAlike = least == Likeness::Half
                                 ? common > 0 && 2 * common >= std::min(old_[i].lines.size(), new_[j].lines.size())
                             : least == Likeness::Result ? hasResult
                                                         : hasTitle;
        if (const Nearness nearness{hasResult, hasTitle, common}; isAlike && nearness > most) {
          most = nearness;
          found = i;
        }
      }
      if (found < old_.size()) pair(found, j);
    }
  }

  void write() {
    std::vector<std::vector<std::size_t>> removedBehind(old_.size() + 1);  // by 1 + index of what stood before in OLD
    std::size_t last = 0;
    for (std::size_t i = 0; i < old_.size(); ++i) {
      if (old_[i].isPaired)
        last = i + 1;
      else
        removedBehind[last].push_back(i);
    }
    const auto addRemoved = [&](std::size_t behind) {
      for (const std::size_t i : removedBehind[behind])
        result_.networks.push_back({old_[i].where, std::nullopt, false});
    };
    addRemoved(0);
    for (std::size_t j = 0; j < new_.size(); ++j) {
      NetworkPair& row = result_.networks.emplace_back();
      row.after = new_[j].where;
      if (!partner_[j]) continue;
      row.before = old_[*partner_[j]].where;
      row.isSame = old_[*partner_[j]].key == new_[j].key;
      addRemoved(*partner_[j] + 1);
    }
  }

  const Program& before_;
  const Program& after_;
  std::vector<NetworkShape> old_, new_;
  std::vector<std::optional<std::size_t>> partner_;  ///< by index in new_
  ProgramMatch result_;
};

}  // namespace

namespace {

/// Without the names that stood there: a place is what it is whatever a block calls it.
Operand withoutNames(Operand operand) {
  if (operand.reach == nullptr) return operand;
  operand.text = std::string_view();
  Reach reach = *operand.reach;
  reach.pointer = withoutNames(reach.pointer);
  operand.reach = Shared<Reach>(std::move(reach));
  return operand;
}

}  // namespace

std::string textInOld(const Instruction& after, const AddressPairs& pairs) {
  std::string text(after.desc->stl);
  std::string_view gap = " ";
  for (const Operand& operand : after.operands) {
    text += std::exchange(gap, ", ");
    if (operand.kind == OperandKind::Constant && operand.form != ConstantForm::Real) {
      text += std::to_string(operand.value);  // 16#10, +16 and 16 are one number
      continue;
    }
    if (pairs.empty() || operand.kind == OperandKind::Constant || operand.kind == OperandKind::Text) {
      text += toString(withoutNames(operand));
      continue;
    }
    Operand place = operand;
    place.kind = OperandKind::Direct;
    const std::optional<Operand> there = pairs.before(place);
    if (there) {
      place = *there;
      place.kind = operand.kind;
    }
    text += (there ? "" : "new ") + toString(there ? place : operand);
  }
  return text;
}

ProgramMatch matchPrograms(const Program& before, const Program& after, const AddressPairs& pairs) {
  return Matcher(before, after, pairs).run();
}

}  // namespace rungproof
