// Writes STEP 7 projects: folders, tables with deleted rows, memo files, links, symbols, hardware.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "frontend/mc7/stored_block.hpp"

namespace rungproof::test {

/// A dBase table with its memo file.
class TableWriter {
 public:
  struct Column {
    std::string name;
    char type;
    std::size_t length;
  };
  explicit TableWriter(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// Fields by name; the others are blank.
  void add(const std::map<std::string, std::string>& fields, bool isDeleted = false);
  /// The number of a memo with that contents; "" of an empty one.
  std::string memo(const std::string& contents);
  std::string table() const;
  std::string memos() const;
  std::size_t rows() const { return rows_.size(); }

 private:
  std::vector<Column> columns_;
  std::vector<std::string> rows_;
  std::string memos_ = std::string(512, '\0');
};

struct ProjectPart {
  std::string name = "S7 Program(1)";
  std::vector<mc7::StoredBlock> blocks;
  std::vector<mc7::StoredBlock> deleted;  ///< old versions, in deleted rows
  struct Symbol {
    std::string name, address, type, comment;
  };
  std::vector<Symbol> symbols;
  std::map<std::string, std::string> sources;  ///< texts by name, as statement lists
  std::map<unsigned, std::string> dataSets;    ///< of the CPU's parameters
  std::string cpu;                             ///< empty: no hardware
  std::string orderNumber;
};

/// The files of a project by their paths. `page`: code page, in which the texts of the blocks are given already.
std::map<std::string, std::string> writeProject(const std::vector<ProjectPart>& programs, unsigned page,
                                                const std::string& name = "Plant");
/// The same files as an archive without compression, in one top folder.
std::string zipOf(const std::map<std::string, std::string>& files, const std::string& folder);

}  // namespace rungproof::test
