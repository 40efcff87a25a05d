// Collects calls and attachments; depth and cycles by one depth-first search.
#include "analysis/flow/call_graph.hpp"

#include <algorithm>
#include <map>

#include "ir/s7300/organization_block.hpp"

namespace rungproof {

namespace {

/// Strongly connected components of the call graph by Tarjan's algorithm, without recursion so that a chain of any
/// length is no danger: the number of the component of each block, and the blocks with callees before callers.
class Components {
 public:
  Components(std::span<const CallSite> sites, const std::vector<std::vector<std::uint32_t>>& callsIn)
      : sites_(sites),
        callsIn_(callsIn),
        order_(callsIn.size(), 0),
        low_(callsIn.size(), 0),
        component_(callsIn.size(), 0) {
    for (std::uint32_t b = 0; b < callsIn.size(); ++b) {
      if (order_[b] == 0) visit(b);
    }
  }
  std::uint32_t of(std::uint32_t block) const { return component_[block]; }
  std::span<const std::uint32_t> calleesFirst() const { return finished_; }

 private:
  struct Frame {
    std::uint32_t block;
    std::size_t next = 0;  ///< call to follow next
  };

  void visit(std::uint32_t root) {
    std::vector<Frame> path;
    const auto enter = [&](std::uint32_t block) {
      order_[block] = low_[block] = ++clock_;
      open_.push_back(block);
      path.push_back({block});
    };
    enter(root);
    while (!path.empty()) {
      Frame& frame = path.back();
      const std::uint32_t block = frame.block;
      if (frame.next < callsIn_[block].size()) {
        const std::uint32_t callee = sites_[callsIn_[block][frame.next++]].callee;
        if (callee == noBlock) continue;
        if (order_[callee] == 0) {
          enter(callee);
        } else if (component_[callee] == 0) {
          low_[block] = std::min(low_[block], order_[callee]);
        }
        continue;
      }
      if (low_[block] == order_[block]) close(block);
      finished_.push_back(block);
      path.pop_back();
      if (!path.empty()) low_[path.back().block] = std::min(low_[path.back().block], low_[block]);
    }
  }

  void close(std::uint32_t block) {
    ++components_;
    std::uint32_t member = noBlock;
    do {
      member = open_.back();
      open_.pop_back();
      component_[member] = components_;
    } while (member != block);
  }

  std::span<const CallSite> sites_;
  const std::vector<std::vector<std::uint32_t>>& callsIn_;
  std::vector<std::uint32_t> order_, low_, component_;
  std::vector<std::uint32_t> open_, finished_;
  std::uint32_t clock_ = 0, components_ = 0;
};

int numberOf(const Instruction& instruction, std::size_t i) {
  const bool isConstant = i < instruction.operands.size() && instruction.operands[i].kind == OperandKind::Constant;
  return isConstant ? static_cast<int>(instruction.operands[i].value) : -1;
}

/// UC FC[MW10], or a block that a parameter names: any of them may be meant.
bool isCallByNumber(const Instruction& instruction) {
  return instruction.desc->control == Control::BlockCall && !instruction.operands.empty() &&
         instruction.operands[0].kind == OperandKind::Indirect;
}

}  // namespace

CallGraph::CallGraph(const Program& program, const Plan& plan) {
  const std::size_t blocks = program.pous.size();
  callsIn_.resize(blocks);
  callsOf_.resize(blocks);
  depth_.assign(blocks, -1);
  deepest_.assign(blocks, noBlock);
  recursion_.assign(blocks, noBlock);
  fromMain_.assign(blocks, 0);
  fromInterrupt_.assign(blocks, 0);
  attached_.assign(blocks, 0);
  fromStartUp_.assign(blocks, 0);
  fromOtherBlocks_.assign(blocks, 0);

  std::map<std::pair<PouKind, int>, std::uint32_t> byNumber;
  for (std::uint32_t b = 0; b < blocks; ++b)
    byNumber.emplace(std::pair(program.pous[b].kind, program.pous[b].number), b);
  const auto find = [&](PouKind kind, int number) {
    const auto found = byNumber.find({kind, number});
    return found == byNumber.end() ? noBlock : found->second;
  };

  bool callsByNumber = false;
  for (std::uint32_t b = 0; b < blocks; ++b) {
    for (const FlowStep& step : plan.flows[b].steps) {
      const Instruction& instruction = *step.instruction;
      callsByNumber = callsByNumber || isCallByNumber(instruction);
      if (instruction.desc->control == Control::Call || instruction.desc->control == Control::BlockCall) {
        const std::uint32_t callee = find(PouKind::Subroutine, numberOf(instruction, 0));
        const auto site = static_cast<std::uint32_t>(sites_.size());
        sites_.push_back({&instruction, b, callee});
        callsIn_[b].push_back(site);
        if (callee != noBlock) callsOf_[callee].push_back(site);
      } else if (roleOf(instruction) == Role::Atch) {
        const int number = numberOf(instruction, 0);
        attachments_.push_back({&instruction, b, find(PouKind::Interrupt, number), number, numberOf(instruction, 1)});
      }
    }
  }

  const Components components(sites_, callsIn_);
  for (std::uint32_t s = 0; s < sites_.size(); ++s) {
    const CallSite& site = sites_[s];
    if (site.callee == noBlock || components.of(site.caller) != components.of(site.callee)) continue;
    if (recursion_[site.caller] == noBlock) recursion_[site.caller] = s;
  }
  for (const std::uint32_t block : components.calleesFirst()) measure(block);
  for (const Attachment& a : attachments_) {
    if (a.routine == noBlock) continue;
    attached_[a.routine] = 1;
    mark(a.routine, fromInterrupt_);
  }
  for (std::uint32_t b = 0; b < blocks; ++b) {
    if (program.pous[b].type == BlockType::Ob)
      mark(b, s7300::isStartUpBlock(program.pous[b]) ? fromStartUp_ : fromOtherBlocks_);
    const bool isOb = program.pous[b].type == BlockType::Ob && s7300::mayStart(program, program.pous[b]);
    if (program.pous[b].kind == PouKind::Main || isOb) mark(b, fromMain_);
    if (callsByNumber && (program.pous[b].type == BlockType::Fc || program.pous[b].type == BlockType::Fb))
      mark(b, fromMain_);
  }
}

std::uint32_t CallGraph::calleeOf(std::uint32_t block, const Instruction& call) const {
  const std::span<const std::uint32_t> sites = callsIn(block);  // in the order of the text
  const auto idOf = [&](std::uint32_t site) { return sites_[site].instruction->id; };
  const auto found = std::ranges::lower_bound(sites, call.id, {}, idOf);
  return found == sites.end() || idOf(*found) != call.id ? noBlock : sites_[*found].callee;
}

/// Callees on a cycle that are not measured yet count as one level.
void CallGraph::measure(std::uint32_t block) {
  depth_[block] = 0;
  for (const std::uint32_t s : callsIn_[block]) {
    const std::uint32_t callee = sites_[s].callee;
    const int below = 1 + (callee == noBlock ? 0 : std::max(depth_[callee], 0));
    if (below <= depth_[block]) continue;
    depth_[block] = below;
    deepest_[block] = s;
  }
}

void CallGraph::mark(std::uint32_t root, std::vector<std::uint8_t>& marks) const {
  std::vector<std::uint32_t> open{root};
  while (!open.empty()) {
    const std::uint32_t block = open.back();
    open.pop_back();
    if (marks[block] != 0) continue;
    marks[block] = 1;
    for (const std::uint32_t s : callsIn_[block]) {
      if (sites_[s].callee != noBlock) open.push_back(sites_[s].callee);
    }
  }
}

std::optional<std::uint32_t> CallGraph::recursionThrough(std::uint32_t block) const {
  if (recursion_[block] == noBlock) return std::nullopt;
  return recursion_[block];
}

std::optional<std::uint32_t> CallGraph::deepestCall(std::uint32_t block) const {
  if (deepest_[block] == noBlock) return std::nullopt;
  return deepest_[block];
}

}  // namespace rungproof
