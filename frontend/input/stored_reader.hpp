// Stored blocks on their way into a program: sources of their own that the reader of STEP 7 sources reads, symbols, and
// what is to be said of the project. Tested by tests/s7project.
#pragma once

#include <string>
#include <vector>

#include "frontend/mc7/block_source.hpp"
#include "frontend/s7project/s7_project.hpp"
#include "frontend/step7/step7_project.hpp"

namespace rungproof {

class StoredReader {
 public:
  StoredReader(Program& program, step7::Step7Project& step7) : program_(program), step7_(step7) {}

  /// A program of a project by its path; an empty path means the only one. `name`: before the names of its blocks.
  void addProgram(const s7project::S7Project& project, std::string_view path, const std::string& name,
                  bool hidesProtected);
  /// Single blocks, which are one program together.
  void addUploads(const std::vector<mc7::StoredBlock>& blocks, bool hidesProtected);

 private:
  void addBlocks(std::vector<mc7::StoredBlock> blocks, std::vector<std::string> names, TextEncoding encoding,
                 bool hidesProtected);
  void addFrame(const mc7::StoredBlock& block, const std::string& name);
  void addSymbols(const std::vector<s7project::Symbol>& symbols, const std::string& name, TextEncoding encoding);
  void reportDamage(const mc7::StoredBlock& block, const mc7::BlockSource& source, std::uint32_t file);
  void reportConflicts(const std::vector<mc7::StoredBlock>& blocks, const std::vector<std::uint32_t>& files);

  Program& program_;
  step7::Step7Project& step7_;
};

}  // namespace rungproof
