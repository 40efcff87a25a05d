// Which parameters a call hands over by a pointer, and where these pointers stand (002:2181-2288): those of an FC
// behind the local data of the calling block, those of an FB in its instance. Tested by
// tests/step7/handed_pointer_test.cpp.
#pragma once

#include "ir/s7300/block.hpp"

namespace rungproof {

inline bool isPointerType(DataType type) { return type == DataType::Pointer || type == DataType::Any; }
/// DATE_AND_TIME, STRING, ARRAY, STRUCT.
inline bool isComplexType(DataType type) {
  return type == DataType::DateAndTime || type == DataType::String || type == DataType::Array ||
         type == DataType::Struct;
}
/// Bytes of the pointer by which a parameter of that type is handed over.
constexpr std::uint32_t pointerSize(DataType type) { return type == DataType::Any ? 10 : 6; }

inline bool isParameter(const LocalVariable& local) {
  return local.section != VarSection::Temp && local.section != VarSection::Static;
}
/// Whether pointers that are handed over stand in its instance. Of the instance of an SFB that no table describes
/// nothing is known.
inline bool keepsPointers(const Pou& pou) { return hasInstance(pou) && pou.instanceBytes > 0; }

/// Whether a call hands a pointer over for the parameter.
inline bool takesPointer(const LocalVariable& parameter) {
  const bool isReferred = parameter.address.reach != nullptr && parameter.address.reach->way == Way::Parameter;
  return isPointerType(parameter.type) || (isReferred && isComplexType(parameter.type));
}

/// Gives the pointers of all calls their places, once all blocks of the program are there.
void placeHandedPointers(Program& program);

}  // namespace rungproof
