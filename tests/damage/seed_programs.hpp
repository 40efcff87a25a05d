// The programs that the campaign damages, and how it damages them.
#pragma once

#include <random>
#include <string>
#include <vector>

namespace rungproof::test {

struct SeedProgram {
  std::string name;  ///< of its file, with the ending that decides how it is read
  std::string text;
  std::string symbols;  ///< a symbol table that belongs to it, or empty
  std::string cpu;
};

/// The bad and the good example of every rule.
std::vector<SeedProgram> ruleExamples();
/// Every program of the corpus.
std::vector<SeedProgram> corpusPrograms();

/// The text with one to three slips: in characters, operands, mnemonics, lines, the order of networks; in XML also in
/// attributes and elements.
std::string damaged(const SeedProgram& program, std::mt19937_64& random);

}  // namespace rungproof::test
