// The table of stated cases, tests/data/s7300_cases.tsv: read, written out as sources of blocks, and compared with what
// a machine holds at the end. Its head explains the columns.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace naive7 {

struct Case {
  std::string row, number, text;  ///< instruction, ordinal, the program as the table has it
  bool is400 = false;
  std::string status;                                        ///< before: nine characters
  std::map<std::string, std::uint32_t> regs;                 ///< before: "1".."4", "AR1", "AR2", "DB", "DI"
  std::vector<std::pair<std::string, std::uint32_t>> bytes;  ///< before: "MW10", "DB1.DBX0.0"
  std::string statusAfter;                                   ///< . as before, ? not stated
  std::map<std::string, std::uint32_t> regsAfter;
  std::vector<std::string> openRegs;  ///< not stated after
  std::vector<std::pair<std::string, std::uint32_t>> bytesAfter;
  int stop = 0;  ///< the error that stops the CPU, or 0

  std::vector<std::string> scans;  ///< statements of each scan, with ;
  std::vector<int> pauses;         ///< ms before the second, third ... scan
  std::string blocks;              ///< sources of DB1, DB2 and the blocks that the program defines

  std::string name() const { return row + " " + number + ": " + text; }
};

/// The cases of the file; a line that cannot be read is an empty row with the line as its text.
std::vector<Case> readCases(const std::string& path);

/// "ORGANIZATION_BLOCK OB 1 ... END_ORGANIZATION_BLOCK" around statements.
std::string organizationBlock(const std::string& statements);

}  // namespace naive7
