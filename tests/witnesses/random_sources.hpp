// Random programs of each family as texts with random properties in random surroundings, of which nothing is refused: a
// line that the readers or the editor refuse is taken out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ir/target.hpp"

namespace rungproof::test {

/// A program, and the options under which all commands read it.
struct RandomText {
  std::string name;  ///< of its file
  std::string text;
  std::vector<std::string> options;
};

RandomText randomS7200Text(std::uint64_t seed, Target target);
RandomText randomStep7Text(std::uint64_t seed);
RandomText randomIecText(std::uint64_t seed);

/// Another version of a program of the first two: without one line that writes, an output if there is one.
RandomText otherVersion(const RandomText& source, std::uint64_t seed);

}  // namespace rungproof::test
