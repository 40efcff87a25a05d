// Two programs given side by side on one command line, OLD and NEW: their files, the options that differ between them
// (old: and new: in front of a value), and the properties that constrain the pair. Tested by tests/equivalence.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "analysis/equivalence/product.hpp"
#include "frontend/compared_block.hpp"
#include "frontend/input/program_input.hpp"
#include "frontend/mc7/stored_block.hpp"

namespace rungproof {

/// What a command that compares programs is given; rows for its table.
struct SideArguments {
  std::string before, after;      ///< a file or a folder each
  std::vector<std::string> with;  ///< "old:FILE", "new:FILE"
  std::vector<std::string> properties;
  std::string map;
  std::vector<std::string> observed;
  std::string values = "own";
  bool asDownloaded = false;

  void declare(ArgumentTable& table);
};

/// The two programs as they were read; `unread` says what of each may not be run.
struct Sides {
  ProgramInput before, after;
  std::unique_ptr<UnreadCode> unreadBefore, unreadAfter;
  std::unique_ptr<Program> runBefore, runAfter;  ///< what of the programs may be run

  Side oldSide() const { return {runBefore.get(), before.properties, unreadBefore.get()}; }
  Side newSide() const { return {runAfter.get(), after.properties, unreadAfter.get()}; }
  std::vector<std::string> filesBefore, filesAfter;
  std::vector<mc7::StoredBlock> storedBefore, storedAfter;  ///< of a STEP 7 project, or read out of a CPU
  std::vector<std::string> leftOutBefore, leftOutAfter;     ///< networks that are not in the download
  std::vector<ComparedBlock> blocks;                        ///< which of them are the same; empty without stored ones
  AddressPairs pairs;
  Operands observed;                  ///< addresses of OLD
  std::vector<Property> assumptions;  ///< that speak of both programs
};

/// Reads both. Mistakes of arguments, the map and property files are failures; what is wrong in a program stands among
/// its findings.
Sides readSides(const Context& context, const SideArguments& arguments, std::vector<Failure>& failures);

}  // namespace rungproof
