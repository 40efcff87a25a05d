// The rows, in the order of README.
#include "ir/s7300/coverage.hpp"

#include <array>

namespace rungproof::s7300 {

namespace {

constexpr auto gapTable = std::to_array<GapRow>({
    {Gap::OrganizationBlock, "organization blocks other than", "what starts it is not modelled"},
    {Gap::PointerParameter,
     "numbers of blocks, pointers without a type and places that a pointer finds as actual parameters of type POINTER "
     "and ANY",
     "the pointer to it is not modelled"},
    {Gap::LibraryBlock, "of the blocks of the system", "what it does is not modelled"},
    {Gap::SystemInstance,
     "of other SFB than 0 to 5 pointers and variables of complex type as parameters, multi-instances, and what stands "
     "in "
     "their instances",
     "what stands there, and when, is not known"},
    {Gap::MissingBlock, "blocks that no file defines", "it is in no file"},
    {Gap::ProtectedBlock, "protected blocks", "its statements are in no file"},
    {Gap::HighDataBlock, "data blocks above DB8191", "its number is too high"},
    {Gap::Drawing,
     "networks of SimaticML and of `.s7dcl` with parts that are not known, and in other languages than ladder, FBD and "
     "STL, in `.s7dcl` also SCL; blocks in SCL with a statement that is not covered",
     "the network is not read"},
});

}  // namespace

std::span<const GapRow> gapRows() { return gapTable; }
std::string_view gapReason(Gap gap) { return gapTable[static_cast<std::size_t>(gap)].reason; }

}  // namespace rungproof::s7300
