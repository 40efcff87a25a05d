// Owner and access list of a file, beside the user of this process.
#include "engine/platform/windows/ownership.hpp"

#include <aclapi.h>
#include <windows.h>

#include <array>
#include <cstdint>
#include <vector>

namespace rungproof {

namespace {

/// The user of this process and the owner of what it makes: administrators, where it runs as one of them.
bool isOneOfUs(PSID owner) {
  HANDLE token = nullptr;
  if (::OpenProcessToken(::GetCurrentProcess(), TOKEN_QUERY, &token) == 0) return false;
  bool isOurs = false;
  for (const TOKEN_INFORMATION_CLASS which : {TokenUser, TokenOwner}) {
    DWORD size = 0;
    ::GetTokenInformation(token, which, nullptr, 0, &size);
    std::vector<std::uint64_t> room(size / sizeof(std::uint64_t) + 1);
    if (::GetTokenInformation(token, which, room.data(), size, &size) == 0) continue;
    const PSID sid = which == TokenUser ? reinterpret_cast<TOKEN_USER*>(room.data())->User.Sid
                                        : reinterpret_cast<TOKEN_OWNER*>(room.data())->Owner;
    isOurs = isOurs || ::EqualSid(owner, sid) != 0;
  }
  ::CloseHandle(token);
  return isOurs;
}

bool letsEverybodyWrite(PACL list) {
  if (list == nullptr) return true;
  std::array<std::uint64_t, SECURITY_MAX_SID_SIZE / sizeof(std::uint64_t) + 1> everybody{};
  DWORD size = sizeof everybody;
  if (::CreateWellKnownSid(WinWorldSid, nullptr, everybody.data(), &size) == 0) return true;
  constexpr DWORD writing = FILE_WRITE_DATA | FILE_APPEND_DATA | GENERIC_WRITE | GENERIC_ALL;
  for (DWORD i = 0; i < list->AceCount; ++i) {
    void* entry = nullptr;
    if (::GetAce(list, i, &entry) == 0) return true;
    const auto& allowed = *static_cast<ACCESS_ALLOWED_ACE*>(entry);
    if (allowed.Header.AceType != ACCESS_ALLOWED_ACE_TYPE || (allowed.Mask & writing) == 0) continue;
    if (::EqualSid(everybody.data(), const_cast<DWORD*>(&allowed.SidStart)) != 0) return true;
  }
  return false;
}

}  // namespace

Ownership ownershipOf(void* file) {
  PSID owner = nullptr;
  PACL list = nullptr;
  PSECURITY_DESCRIPTOR descriptor = nullptr;
  const DWORD error = ::GetSecurityInfo(file, SE_FILE_OBJECT, OWNER_SECURITY_INFORMATION | DACL_SECURITY_INFORMATION,
                                        &owner, nullptr, &list, nullptr, &descriptor);
  if (error != ERROR_SUCCESS) return {};
  const Ownership result{isOneOfUs(owner), letsEverybodyWrite(list)};
  ::LocalFree(descriptor);
  return result;
}

}  // namespace rungproof
