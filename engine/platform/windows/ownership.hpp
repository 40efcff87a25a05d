// Whose a file is, and who may write it.
#pragma once

namespace rungproof {

struct Ownership {
  bool isOurs = false;
  bool isOpenToAll = true;
};
/// `file`: a handle with READ_CONTROL.
Ownership ownershipOf(void* file);

}  // namespace rungproof
