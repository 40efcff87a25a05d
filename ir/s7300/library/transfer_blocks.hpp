// Blocks of memory, process images and rows of outputs. One struct for each block.
#pragma once

#include <fmt/format.h>

#include <string>

#include "ir/machine/instruction_group.hpp"
#include "ir/s7300/block_transfer.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof::s7300::library {

/// The inputs of the image get what the modules have at that moment (002:2355).
inline std::string updateOfInputs(std::uint32_t imageBytes) {
  std::string text;
  for (std::uint32_t byte = 0; byte < imageBytes; byte += 4) text += fmt::format("L PID {0}; T ID {0};\n", byte);
  return text;
}

// N bits from SA on, of the outputs, get the result in front of it (002:2355).
inline constexpr std::string_view bitArray = R"(
      L P##SA; LAR1; L D[AR1,P#2.0];
      L DW#16#7FFFF; AD; L DW#16#82000000; OD; LAR1;
      L #N; L 0; <=I; JC none;
      L #N;
next: T #left; {0}; = [AR1,P#0.0]; +AR1 P#0.1; L #left; LOOP next;
none: NOP 0;)";
inline std::string setBits(std::uint32_t) { return fmt::format(bitArray, "SET"); }
inline std::string resetBits(std::uint32_t) { return fmt::format(bitArray, "CLR"); }

struct Sfc15 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 15,
                                         .name = "DPWR_DAT",
                                         .parameters = "LADDR:WORD RECORD:ANY|RET_VAL:INT",
                                         .isContract = true,
                                         .outside = "what it sends to a DP slave is no output of the program"};
};

struct Sfc20 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 20,
                                         .name = "BLKMOV",
                                         .parameters = "SRCBLK:ANY|RET_VAL:INT DSTBLK:ANY",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    BlockTransfer<D>(a).run(0, 1, 2, false);
  }
};

struct Sfc21 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 21,
                                         .name = "FILL",
                                         .parameters = "BVAL:ANY|RET_VAL:INT BLK:ANY",
                                         .isBuiltIn = true};
  template <class D>
  static void run(SystemArgs<D>& a) {
    BlockTransfer<D>(a).run(0, 1, 2, true);
  }
};

struct Sfc26 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfc,
      .number = 26,
      .name = "UPDAT_PI",
      .parameters = "PART:BYTE|RET_VAL:INT FLADDR:WORD",
      .isContract = true,
      .begin = updateOfInputs,
      .outside = "every input of the image may change where it is called, whatever PART says"};
};

struct Sfc27 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfc,
      .number = 27,
      .name = "UPDAT_PO",
      .parameters = "PART:BYTE|RET_VAL:INT FLADDR:WORD",
      .isContract = true,
      .outside = "outputs are looked at where the scan ends, not where it writes them"};
};

struct Sfc79 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfc,
      .number = 79,
      .name = "SET",
      .parameters = "N:INT SA:POINTER|RET_VAL:INT",
      .isContract = true,
      .begin = setBits,
      .outside = "it writes the image of the outputs, and the modules get that where the scan ends"};
};

struct Sfc80 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfc,
      .number = 80,
      .name = "RSET",
      .parameters = "N:INT SA:POINTER|RET_VAL:INT",
      .isContract = true,
      .begin = resetBits,
      .outside = "it writes the image of the outputs, and the modules get that where the scan ends"};
};

using TransferGroup = isa::Group<Sfc15, Sfc20, Sfc21, Sfc26, Sfc27, Sfc79, Sfc80>;

}  // namespace rungproof::s7300::library
