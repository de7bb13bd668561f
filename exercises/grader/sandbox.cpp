// Starts a program that nobody has read, with limits:
//
//   sandbox CPU_SECONDS MEMORY_MIB PROGRAM [ARGUMENT ...]
//
// Everywhere: processor time, memory, no files written, no core dump. On Linux (x86_64, aarch64)
// the kernel also refuses what an answer never needs: new processes and programs, signals to
// others, the network, every change of a file. Threads are allowed. This stops accidents and the
// usual tricks; a class that attacks its grader on purpose needs a container around `gradebook`.
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace {

/// Sets a resource limit where the system knows it: first a signal, `margin` later the end.
template <class Resource> void limit(Resource what, rlim_t value, rlim_t margin = 0) {
  rlimit old{};
  getrlimit(what, &old);
  const rlim_t most = value + margin < old.rlim_max ? value + margin : old.rlim_max;
  const rlimit now{value < most ? value : most, most};
  setrlimit(what, &now);
}

}  // namespace

#if defined(__linux__) && (defined(__x86_64__) || defined(__aarch64__))
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/syscall.h>

#include <cstddef>
#include <vector>

namespace {

#ifdef __x86_64__
constexpr unsigned architecture = AUDIT_ARCH_X86_64;
#else
constexpr unsigned architecture = AUDIT_ARCH_AARCH64;
#endif
constexpr int other_abi = 0x40000000;  // x86_64: system calls with numbers of a second set

/// System calls that are refused. Not all of them exist everywhere.
const int forbidden[] = {
#ifdef SYS_fork
    SYS_fork, SYS_vfork, SYS_creat, SYS_rename, SYS_unlink, SYS_rmdir, SYS_mkdir, SYS_link,
    SYS_symlink, SYS_mknod, SYS_chmod, SYS_chown, SYS_lchown,
#endif
    SYS_execve, SYS_setpgid, SYS_setsid, SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev,
    SYS_tkill, SYS_rt_sigqueueinfo, SYS_rt_tgsigqueueinfo, SYS_socket, SYS_socketpair,
    SYS_renameat2, SYS_unlinkat, SYS_mkdirat, SYS_linkat, SYS_symlinkat, SYS_mknodat, SYS_truncate,
    SYS_ftruncate, SYS_fchmod, SYS_fchmodat, SYS_fchown, SYS_fchownat, SYS_utimensat, SYS_setrlimit,
    SYS_mount, SYS_chroot, SYS_setxattr, SYS_fallocate,
#ifdef SYS_renameat
    SYS_renameat,
#endif
#ifdef SYS_pidfd_open
    SYS_pidfd_open, SYS_pidfd_send_signal,
#endif
};
/// These are said not to exist: the C library then takes an older one, which is examined.
const int missing[] = {
#ifdef SYS_clone3
    SYS_clone3,
#endif
#ifdef SYS_openat2
    SYS_openat2,
#endif
#ifdef SYS_io_uring_setup
    SYS_io_uring_setup,
#endif
};

/// A Berkeley packet filter: what the kernel does for each system call.
struct Filter {
  std::vector<sock_filter> code{};

  static constexpr unsigned load = BPF_LD | BPF_W | BPF_ABS, end = BPF_RET | BPF_K;
  static constexpr unsigned equal = BPF_JMP | BPF_JEQ | BPF_K, bits = BPF_JMP | BPF_JSET | BPF_K;
  static constexpr unsigned no = SECCOMP_RET_ERRNO | EPERM;

  void add(unsigned what, unsigned constant, int if_true = 0, int if_false = 0) {
    using Byte = unsigned char;
    code.push_back({static_cast<unsigned short>(what), static_cast<Byte>(if_true),
                    static_cast<Byte>(if_false), constant});
  }
  void always(int call, unsigned verdict) {
    add(load, offsetof(seccomp_data, nr)), add(equal, static_cast<unsigned>(call), 0, 1);
    add(end, verdict);
  }
  /// Compares argument k of a call (its low half): allowed if the test says `allowed`.
  void argument(int call, int k, unsigned test, unsigned constant, bool allowed) {
    add(load, offsetof(seccomp_data, nr)), add(equal, static_cast<unsigned>(call), 0, 4);
    add(load, static_cast<unsigned>(offsetof(seccomp_data, args)) + 8 * static_cast<unsigned>(k));
    add(test, constant, allowed ? 1 : 0, allowed ? 0 : 1);
    add(end, no), add(end, SECCOMP_RET_ALLOW);
  }
};

Filter make_filter() {
  const unsigned writing = O_WRONLY | O_RDWR | O_CREAT | O_TRUNC;
  Filter f;
  f.add(Filter::load, offsetof(seccomp_data, arch)), f.add(Filter::equal, architecture, 1, 0);
  f.add(Filter::end, SECCOMP_RET_KILL_PROCESS);
  f.add(Filter::load, offsetof(seccomp_data, nr));
  f.add(BPF_JMP | BPF_JGE | BPF_K, other_abi, 0, 1), f.add(Filter::end, SECCOMP_RET_KILL_PROCESS);
  for (const int call : forbidden) f.always(call, Filter::no);
  for (const int call : missing) f.always(call, SECCOMP_RET_ERRNO | ENOSYS);
  const auto self = static_cast<unsigned>(getpid());  // abort() sends a signal to itself
  f.argument(SYS_kill, 0, Filter::equal, self, true);
  f.argument(SYS_tgkill, 0, Filter::equal, self, true);
#ifdef SYS_open
  f.argument(SYS_open, 1, Filter::bits, writing, false);
#endif
  f.argument(SYS_openat, 2, Filter::bits, writing, false);
  f.argument(SYS_clone, 0, Filter::bits, CLONE_THREAD, true);
  f.argument(SYS_prlimit64, 2, Filter::equal, 0, true);
  f.add(Filter::end, SECCOMP_RET_ALLOW);
  return f;
}

/// Installs the filter for the rest of this process; false where that is not possible.
bool refuse_system_calls() {
  Filter f = make_filter();
  sock_fprog program{static_cast<unsigned short>(f.code.size()), f.code.data()};
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // the program ends when the grader ends
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

/// Starts a program by its open file: the call that takes a path is gone.
void start(char** program) {
  const int file = open(program[0], O_RDONLY | O_CLOEXEC);
  if (refuse_system_calls()) fexecve(file, program, environ);
  else execv(program[0], program);
}

}  // namespace
#else
namespace {
void start(char** program) { execv(program[0], program); }
}  // namespace
#endif

int main(int count, char** a) {
  if (count < 4) return std::fputs("sandbox CPU_SECONDS MEMORY_MIB PROGRAM ...\n", stderr), 2;
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_NOFILE, 64);
  limit(RLIMIT_AS, static_cast<rlim_t>(std::atol(a[2])) << 20);
  limit(RLIMIT_CPU, static_cast<rlim_t>(std::atol(a[1])), 1);
  start(a + 3);
  std::perror(a[3]);
  return 127;
}
