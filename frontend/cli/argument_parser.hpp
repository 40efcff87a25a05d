// Words of a command line -> values of a command's own arguments and of the common options. The splitting into options
// and arguments is CLI11's; what wrong arguments are told is ours (tests/golden/errors).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "frontend/command.hpp"

namespace rungproof {

/// What stood on the command line besides the command's own arguments, which have gone into their variables.
struct ParsedLine {
  struct CommonOption {
    const OptionInfo* info;
    std::vector<std::string> texts;  ///< one for each time it was given; empty for a flag
  };
  bool helpWanted = false;
  std::vector<std::string> arguments;  ///< those that are no options, in order
  std::vector<CommonOption> options;
  std::vector<std::string> inputs;    ///< those of them that are programs
  const Argument* lacking = nullptr;  ///< the programs, if none is given
  std::optional<Failure> failure;     ///< why the line cannot be understood

  const CommonOption* option(Opt id) const;
};

/// Parses the words after the command's name.
ParsedLine parseArguments(const Command& command, const ArgumentTable& table, std::vector<std::string> words);

}  // namespace rungproof
