// Blocks in their order; in each its head, declarations, networks.
#include "frontend/step7/source_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "frontend/stl/syntax_sink.hpp"
#include "frontend/text/excerpt.hpp"

namespace rungproof::step7 {

namespace {

using s7300::SourceFault;
using s7300::TypeKind;

constexpr int longestLabel = 4, longestName = 24;

class SourceCheck {
 public:
  SourceCheck(const SourceSyntax& source, std::string_view text, std::vector<SourceFault>& faults)
      : source_(source), text_(text), faults_(faults) {}

  void check() {
    for (std::size_t i = 0; i < source_.blocks.size(); ++i) placeOf_.emplace(keyOf(source_.blocks[i].name), i);
    for (at_ = 0; at_ < source_.blocks.size(); ++at_) block(source_.blocks[at_]);
  }

 private:
  static std::string keyOf(const BlockName& name) {
    return name.kind ? toString(name) : "\"" + s7300::foldedName(name.symbol);
  }

  void fault(Span span, std::string reason) {
    const BlockName& name = source_.blocks[at_].name;
    faults_.push_back({name.kind ? fmt::format("{}{}", blockKindName(*name.kind), name.number) : name.symbol, network_,
                       span, std::move(reason)});
  }
  /// Of that kind the first one in the network.
  void faultOnce(std::string_view kind, Span span, std::string reason) {
    if (said_.emplace(kind, network_).second) fault(span, std::move(reason));
  }

  void block(const BlockSyntax& block) {
    network_ = 0;
    said_.clear();
    if (!block.framed) return fault(block.span, "statements stand outside of a block: a source begins with its head");
    isLong(block.name.symbol, block.name.span);
    type(block.type);
    declarations(block.declarations);
    for (const NetworkSyntax& network : block.networks) {
      network_ = network.number;
      for (const Statement& each : network.statements) statement(each);
    }
  }

  void isLong(std::string_view name, Span span) {
    if (displayWidth(name) > longestName)
      fault(span, fmt::format("the name {} has more than {} characters", excerpt(name), longestName));
  }

  void declarations(const std::vector<DeclarationSyntax>& all) {
    for (const DeclarationSyntax& each : all) {
      isLong(each.name.text, each.name.span);
      if (each.section == Section::Temp && !each.initial.empty())
        fault(each.initial.front().span, fmt::format("{} in VAR_TEMP has a start value", excerpt(each.name.text)));
      const TypeSyntax* leaf = each.type.get();
      while (leaf != nullptr && leaf->element != nullptr) leaf = leaf->element.get();
      const bool isReal = leaf != nullptr && leaf->elementary.kind == TypeKind::Real;
      const auto whole = std::ranges::find(each.initial, s7300::ConstantKind::Integer, &Constant::kind);
      if (isReal && whole != each.initial.end())
        fault(whole->span, fmt::format("the start value of {} is a whole number: a REAL has a point, such as 5.0",
                                       excerpt(each.name.text)));
      type(each.type);
    }
  }
  void type(const std::shared_ptr<const TypeSyntax>& of) {
    if (of == nullptr) return;
    if (of->named) stands(*of->named, of->named->span);
    type(of->element);
    declarations(of->fields);
  }

  void statement(const Statement& statement) {
    if (!statement.fault.empty()) return;
    label(statement.label);
    if (statement.mnemonic.text.empty()) return;
    const std::size_t end = statement.span.offset + statement.span.length;
    const std::size_t next = std::min(text_.find_first_not_of(" \t", end), text_.size());
    if (next == text_.size() || text_[next] != ';')
      faultOnce("semicolon", statement.span,
                fmt::format("no semicolon ends {}", excerpt(text_.substr(statement.mnemonic.span.offset,
                                                                         end - statement.mnemonic.span.offset))));
    callee(statement.operand);
  }

  void label(const Name& label) {
    if (label.text.empty()) return;
    const unsigned char first = static_cast<unsigned char>(label.text.front());
    if (displayWidth(label.text) > longestLabel)
      faultOnce("label", label.span,
                fmt::format("the label {} has more than {} characters", excerpt(label.text), longestLabel));
    else if (first >= '0' && first <= '9')
      faultOnce("label", label.span, fmt::format("the label {} begins with a digit", excerpt(label.text)));
  }

  /// Of a call: FC 5, "Valve".
  void callee(const Operand& operand) {
    if (operand.form == OperandForm::Block && operand.block) stands(*operand.block, operand.span);
    if (operand.form == OperandForm::Symbol && operand.path.empty())
      stands({std::nullopt, 0, operand.name, operand.span}, operand.span);
  }

  /// A block that this file holds stands in front of its use.
  void stands(const BlockName& name, Span use) {
    const auto found = placeOf_.find(keyOf(name));
    if (found == placeOf_.end() || found->second <= at_) return;
    const BlockSyntax& used = source_.blocks[found->second];
    if (used.kind == BlockKind::Db) return;
    faultOnce(found->first, use, fmt::format("{} stands below: a source holds a block before its use", toString(name)));
  }

  const SourceSyntax& source_;
  std::string_view text_;
  std::vector<SourceFault>& faults_;
  std::map<std::string, std::size_t> placeOf_;  ///< index among the blocks of the file
  std::set<std::pair<std::string, int>> said_;  ///< kinds of faults in networks of the block
  std::size_t at_ = 0;
  int network_ = 0;
};

}  // namespace

void checkSource(const SourceSyntax& source, std::string_view text, std::vector<SourceFault>& faults) {
  SourceCheck(source, text, faults).check();
}

}  // namespace rungproof::step7
