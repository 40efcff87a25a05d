// What an address of the S7-300/400 is: its area, how it is read, and how far the area of the CPU goes.
// Tested by tests/step7/explain_test.cpp.
#pragma once

#include "frontend/explain/address_page.hpp"

namespace rungproof {

/// In either set of mnemonics; nothing if the word is no address, or one in a data block that only a program opens.
std::optional<AddressPage> step7AddressPage(const Target& target, const std::string& word, const Paint& paint);

}  // namespace rungproof
