// What a page that is signed tells beside the verdicts: which files were read, with their SHA-256, for which CPU, under
// which options and choices, what the addresses are called, how the networks look, and what lint finds in them. Filled
// only where a page is asked for, because drawings and hashes take time. Tested by tests/page/acceptance_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rungproof {

/// A file as it was read.
struct FileRead {
  std::string name;
  std::string kind;  ///< "program", "property file", "symbols and data", "configuration"
  std::size_t bytes = 0;
  std::string sha256;
};

/// A point that the manual leaves open, and what holds for it in this run.
struct ChoiceInForce {
  std::string key, value;
  std::string origin;   ///< "command line", "rungproof.toml:3"; empty: nobody chose, proofs cover every reading
  bool isFact = false;  ///< of the plant: proofs take one value of it as well
  std::string why;
};

/// An option that somebody set.
struct OptionInForce {
  std::string name, value, origin;
};

struct NamedAddress {
  std::string address, symbol, comment;
};

struct NetworkPicture {
  std::string pou;
  int number = 0;
  std::string heading;  ///< "MAIN, Network 3  Star contactor"
  std::string svg;      ///< an element for a page that brings svgStyle(); drawn as it was read: FBD or ladder
};

/// One program of the run.
struct ProgramRecord {
  std::string name;          ///< its first file
  std::string title;         ///< of its main block, or empty
  std::string cpu, edition;  ///< cpu: empty where the program is for none (IEC 61131-3)
  std::vector<FileRead> files;
  std::vector<OptionInForce> options;
  std::vector<ChoiceInForce> choices;
  std::vector<NamedAddress> symbols;
  std::vector<NetworkPicture> networks;
};

/// What the page shows of one property beside its row.
struct PropertyEvidence {
  std::string requirement;  ///< the comment above it in its file, or empty
  std::string wave;         ///< the witness as timing diagram, an SVG document
  std::string stimulus;     ///< the whole witness as CSV, which `sim` takes
  std::string certificateSha256;
  std::vector<std::pair<std::string, int>> networks;  ///< blocks and networks that a proof rests on
};

}  // namespace rungproof
