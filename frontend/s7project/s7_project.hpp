// A STEP 7 V5 project: its programs with blocks, symbols, sources and hardware. What is damaged is said, and the rest
// is there. Tested by tests/s7project.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontend/files/encoding.hpp"
#include "frontend/files/failure.hpp"
#include "frontend/mc7/stored_block.hpp"
#include "frontend/s7project/hardware.hpp"

namespace rungproof::s7project {

struct Symbol {
  std::string name, address, type, comment;  ///< UTF-8, without blanks around
};

/// A text in the project, which need not agree with the blocks.
struct TextSource {
  std::string name;
  bool isScl = false;
  std::string text;  ///< UTF-8
};

struct ProjectProgram {
  std::string name;       ///< "S7 Program(1)"; of blocks that belong to none: the name of their folder
  std::string path;       ///< unique in the project: "SIMATIC 300(1)/CPU 315-2 DP/S7 Program(1)"
  std::string container;  ///< folder of its blocks
  std::vector<mc7::StoredBlock> blocks;
  std::vector<Symbol> symbols;
  std::vector<TextSource> sources;
  std::size_t variableTables = 0;
  std::optional<CpuConfiguration> cpu;
};

/// Something that is wrong with a file of the project: "ombstx/offline/00000001/SUBBLK.DBF, record 5: ...".
struct ProjectFault {
  std::string program;  ///< path of the program concerned; empty: any
  std::string text;
  bool isLoss = false;  ///< blocks may be missing
};

struct S7Project {
  std::string file;  ///< as it was named: "Plant.s7p", "Plant.zip"
  unsigned codePage = 1252;
  bool isCodePageKnown = false;
  std::vector<ProjectProgram> programs;
  std::vector<ProjectFault> faults;
  std::optional<Failure> failure;  ///< why nothing of it is read
};

/// Reads a project file or an archive. `encoding`: instead of the project's code page; Auto: that counts.
S7Project readS7Project(const std::string& file, TextEncoding encoding);
/// The same, kept while the run lasts.
std::shared_ptr<const S7Project> s7ProjectOf(const std::string& file, TextEncoding encoding);

/// Bytes of a Windows code page as UTF-8.
std::string textOfCodePage(std::string_view bytes, unsigned page);

}  // namespace rungproof::s7project
