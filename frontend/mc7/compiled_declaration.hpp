// The compiled declaration of a block: types and start values without names. As text it can be read like any other
// declaration, with names by section and position. Tested by tests/mc7/upload_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rungproof::mc7 {

/// Whose data a declaration describes.
enum class DeclarationKind : std::uint8_t { Code = 1, Data = 5, InstanceOfFb = 0x0A, InstanceOfSfb = 0x0B };

struct CompiledDeclaration {
  DeclarationKind kind = DeclarationKind::Code;
  std::uint16_t number = 0;  ///< of the FB or SFB of an instance
  std::string text;          ///< VAR_INPUT ... END_VAR, or STRUCT ... END_STRUCT ; of a data block
  std::string fault;         ///< why it cannot be read, with the byte; empty: it can
  /// Declarations of the FBs and SFBs whose instances are among the data, as they were when the block was compiled.
  struct Instance {
    bool isSystem = false;
    std::uint16_t number = 0;
    std::string text;  ///< VAR_INPUT ... END_VAR
  };
  std::vector<Instance> instances;
};

CompiledDeclaration readCompiledDeclaration(std::string_view bytes);
/// Its kind, the block of an instance, and its items: what makes the layout. Without start values.
std::string declaredItems(std::string_view bytes);

}  // namespace rungproof::mc7
