// Surroundings: what is known of a machine beside its program, from options and the configuration file: the tags of
// its operator panel, and the CPU that the program is to be ported to. Rules find it in Facts. Tag lists are read by
// frontend/input/tag_list.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ir/operand.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

/// What a panel takes the value at an address for.
enum class TagType : std::uint8_t { Unknown, Bool, Byte, Unsigned16, Signed16, Unsigned32, Signed32, Real, Text };

/// Whether the panel writes the value of a tag.
enum class TagAccess : std::uint8_t { Unknown, Reads, Sets };

/// A row of the tag list of an operator panel.
struct PanelTag {
  std::string name;
  Operand address;  ///< direct; a bit, byte, word or double word, or a timer or counter
  TagType type = TagType::Unknown;
  std::string typeText{};  ///< as the list names it
  TagAccess access = TagAccess::Unknown;
  Span span{};  ///< the address in the list
};

struct Surroundings {
  std::vector<PanelTag> tags{};
  std::optional<Target> portTo{};  ///< nothing: the program stays where it is
};

}  // namespace rungproof
