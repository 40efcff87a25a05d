// Names of values from outside, one for each place of the program that asks for one.
#pragma once

#include <string>

#include "analysis/encoding/encoder.hpp"

namespace rungproof {

std::string siteName(const ExternalSite& site);

}  // namespace rungproof
