// Where the bodies of an IEC 61131-3 program read, write and call their variables, as the text has it: rules about
// declarations and statements ask here. Drawings are statements too (ir/iec/syntax.hpp). Names that stand in several
// blocks are one row each; a row of a global variable holds the uses of all blocks that declare it external.
// Tested by tests/rules/iec_rules_test.cpp.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "ir/iec/walk.hpp"

namespace rungproof {
class FindingSink;  // analysis/rule.hpp
struct Finding;
}  // namespace rungproof

namespace rungproof::iec {

/// One place at which a variable stands.
struct VariableUse {
  const BlockSyntax* block = nullptr;  ///< nullptr: the configuration
  Span span;
  bool reads = false, writes = false, calls = false;
  bool isWhole = true;              ///< the variable itself, no element, field or bit of it
  const Expr* value = nullptr;      ///< that an assignment gives it
  const Statement* call = nullptr;  ///< of a call of an instance, as a statement
};

struct DeclaredVariable {
  const BlockSyntax* block = nullptr;  ///< nullptr: global
  const VariableSyntax* variable = nullptr;
  std::vector<VariableUse> uses;

  bool isRead() const;
  bool isWritten() const;
  bool isCalled() const;
};

/// A finding about the variable at one of its places.
Finding& reportOn(FindingSink& sink, const DeclaredVariable& row, Span span, std::string message);

class VariableUses {
 public:
  /// The project must outlive it.
  explicit VariableUses(const ProjectSyntax& project);

  /// In the order of the files: of each block that was read whole and is not of the standard, then the globals.
  const std::vector<DeclaredVariable>& all() const { return rows_; }
  /// The variable that the name means in that block, or nullptr.
  const DeclaredVariable* find(const BlockSyntax& block, std::string_view name) const;
  /// The block, or nullptr.
  const BlockSyntax* blockNamed(std::string_view name) const;
  /// The block of which the variable is an instance, or nullptr.
  const BlockSyntax* blockOf(const VariableSyntax& variable) const;
  /// The declared type behind a name, through names of types; nullptr: an elementary or unknown one.
  const TypeSyntax* typeBehind(const TypeSyntax& type) const;
  /// The name of the elementary type of a path's value, in capitals; empty: it has none, or it is not known.
  std::string elementaryTypeOf(const BlockSyntax& block, const Expr& path) const;
  /// Whether a property or another directive names it.
  bool isAskedFor(const VariableSyntax& variable) const;
  const ProjectSyntax& project() const { return project_; }

 private:
  class Walk;
  using Key = std::pair<const BlockSyntax*, std::string>;
  struct KeyHash {
    std::size_t operator()(const Key& key) const {
      return std::hash<std::string>()(key.second) ^ std::hash<const BlockSyntax*>()(key.first);
    }
  };

  const ProjectSyntax& project_;
  std::vector<DeclaredVariable> rows_;
  std::unordered_map<Key, std::size_t, KeyHash> byName_;
  std::map<std::string, const BlockSyntax*> blocks_;
  std::map<std::string, const NamedType*> types_;
};

}  // namespace rungproof::iec
