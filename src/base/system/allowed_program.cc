#include "base/system/allowed_program.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

namespace clevis {

// What becomes of the process has other pointers: its strings are elsewhere.
void allow_only(const char* program) noexcept {
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);
  constexpr auto kNumber = offsetof(seccomp_data, nr);
  constexpr auto kFile = offsetof(seccomp_data, args);
  constexpr auto kRefused = SECCOMP_RET_ERRNO | (EACCES & SECCOMP_RET_DATA);
  const auto pointer = reinterpret_cast<std::uintptr_t>(program);
  const auto low = static_cast<std::uint32_t>(pointer);
  const auto high =
      static_cast<std::uint32_t>(static_cast<std::uint64_t>(pointer) >> 32U);
  std::array<sock_filter, 9> rules = {{
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kNumber),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_execveat, 5, 0),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_execve, 0, 5),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kFile),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, low, 0, 2),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kFile + sizeof(std::uint32_t)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, high, 1, 0),
      BPF_STMT(BPF_RET | BPF_K, kRefused),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  }};
  sock_fprog filter{static_cast<unsigned short>(rules.size()), rules.data()};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0) {
    prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter);
  }
}

}  // namespace clevis
