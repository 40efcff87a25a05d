// The configuration file rungproof.toml: keys of the option table, [choices] for the points that the manual leaves
// open, [rules.ID] for options of rules. Found beside the first file or in a folder above it.
#pragma once

#include <filesystem>
#include <optional>

#include "frontend/files/failure.hpp"
#include "frontend/settings/options.hpp"

namespace rungproof {

/// The configuration file that counts for files in that folder, or an empty path.
std::filesystem::path findConfig(const std::filesystem::path& folder);
/// Reads it into the settings; origins become "NAME:LINE". The failure names the place.
std::optional<Failure> readConfig(const std::filesystem::path& file, Settings& settings);

}  // namespace rungproof
