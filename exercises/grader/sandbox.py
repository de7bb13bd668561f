"""Starts a program that nobody has read, with limits.

    python3 sandbox.py '{"cpu": 2, "memory": 1024}' PROGRAM [ARGUMENT ...]

Everywhere: processor time (cpu, seconds), memory (MiB), no files written, no core dump. On Linux
(x86_64, aarch64) the kernel also refuses what an answer never needs: new processes and programs,
signals to others, the network, and every change of a file. Threads are allowed. The limits stop
accidents and the usual tricks; for a class that attacks its grader on purpose, run `gradebook`
in a container.
"""
import ctypes
import errno
import json
import os
import platform
import resource
import signal
import struct
import sys

# System calls by number: x86_64, aarch64 (None: does not exist there).
FORBIDDEN = {
    "fork": (57, None), "vfork": (58, None), "execve": (59, 221), "setpgid": (109, 154),
    "setsid": (112, 157), "ptrace": (101, 117), "process_vm_readv": (310, 270),
    "process_vm_writev": (311, 271), "pidfd_open": (434, 434), "pidfd_send_signal": (424, 424),
    "tkill": (200, 130), "rt_sigqueueinfo": (129, 138), "socket": (41, 198),
    "socketpair": (53, 199), "creat": (85, None), "rename": (82, None), "renameat": (264, 38),
    "renameat2": (316, 276), "unlink": (87, None), "unlinkat": (263, 35), "rmdir": (84, None),
    "mkdir": (83, None), "mkdirat": (258, 34), "link": (86, None), "linkat": (265, 37),
    "symlink": (88, None), "symlinkat": (266, 36), "mknod": (133, None), "mknodat": (259, 33),
    "truncate": (76, 45), "ftruncate": (77, 46), "chmod": (90, None), "fchmod": (91, 52),
    "fchmodat": (268, 53), "chown": (92, None), "fchown": (93, 55), "fchownat": (260, 54),
    "utimensat": (280, 88), "setrlimit": (160, 164), "mount": (165, 40), "chroot": (161, 51),
}
MISSING = {"clone3": (435, 435), "openat2": (437, 437), "io_uring_setup": (425, 425)}
OWN_PROCESS_ONLY = {"kill": (62, 129), "tgkill": (234, 131)}  # abort() sends a signal to itself
NO_WRITING = {"open": (2, None, 1), "openat": (257, 56, 2)}  # with the argument that has the flags
CLONE, PRLIMIT = (56, 220), (302, 261)

# Berkeley packet filter: instructions (code, skip if true, skip if false, constant).
LOAD, EQUAL, ABOVE, ANY_BIT, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
ALLOW, REFUSE, KILL = 0x7FFF0000, 0x00050000, 0x80000000
ARCHITECTURE = {"x86_64": (0, 0xC000003E), "aarch64": (1, 0xC00000B7)}
THREAD = 0x00010000  # CLONE_THREAD
WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC


def argument(k):
    """Offset of the low word of argument k of a system call (little endian)."""
    return 16 + 8 * k


def rules(column):
    """The filter for one architecture: a list of (code, skip if true, skip if false, constant)."""
    no, absent = REFUSE | errno.EPERM, REFUSE | errno.ENOSYS
    code = []

    def rule(number, *inner):
        """When this system call is made, do `inner`, which ends in a RETURN."""
        if number is not None:
            code.extend([(LOAD, 0, 0, 0), (EQUAL, 0, len(inner), number), *inner])

    for numbers in FORBIDDEN.values():
        rule(numbers[column], (RETURN, 0, 0, no))
    for numbers in MISSING.values():
        rule(numbers[column], (RETURN, 0, 0, absent))
    for numbers in OWN_PROCESS_ONLY.values():
        rule(numbers[column], (LOAD, 0, 0, argument(0)), (EQUAL, 1, 0, os.getpid()),
             (RETURN, 0, 0, no), (RETURN, 0, 0, ALLOW))
    for *numbers, flags in NO_WRITING.values():
        rule(numbers[column], (LOAD, 0, 0, argument(flags)), (ANY_BIT, 0, 1, WRITING),
             (RETURN, 0, 0, no), (RETURN, 0, 0, ALLOW))
    rule(CLONE[column], (LOAD, 0, 0, argument(0)), (ANY_BIT, 1, 0, THREAD),
         (RETURN, 0, 0, no), (RETURN, 0, 0, ALLOW))
    rule(PRLIMIT[column], (LOAD, 0, 0, argument(2)), (EQUAL, 1, 0, 0),
         (RETURN, 0, 0, no), (RETURN, 0, 0, ALLOW))
    return code + [(RETURN, 0, 0, ALLOW)]


def refuse_system_calls():
    """Installs the filter for the rest of this process; False where that is not possible."""
    if sys.platform != "linux" or platform.machine() not in ARCHITECTURE:
        return False
    column, architecture = ARCHITECTURE[platform.machine()]
    code = [(LOAD, 0, 0, 4), (EQUAL, 1, 0, architecture), (RETURN, 0, 0, KILL)]
    if column == 0:  # the second set of numbers of x86_64
        code += [(LOAD, 0, 0, 0), (ABOVE, 0, 1, 0x40000000), (RETURN, 0, 0, KILL)]
    code += rules(column)
    packed = ctypes.create_string_buffer(b"".join(struct.pack("=HBBI", *line) for line in code))
    program = struct.pack("@HP", len(code), ctypes.addressof(packed))
    prctl = ctypes.CDLL(None, use_errno=True).prctl
    prctl(1, signal.SIGKILL, 0, 0, 0)  # PR_SET_PDEATHSIG: end when the grader ends
    no_new_privileges, set_filter = prctl(38, 1, 0, 0, 0), prctl(22, 2, program, 0, 0)
    return no_new_privileges == 0 and set_filter == 0


def limit(what, value, margin=0):
    """Sets a resource limit (soft: value), as far as this system knows it and allows it."""
    try:
        hard = resource.getrlimit(what)[1]
        top = value + margin if hard == resource.RLIM_INFINITY else min(value + margin, hard)
        resource.setrlimit(what, (min(value, top), top))
    except (ValueError, OSError):
        pass


def main():
    limits, program = json.loads(sys.argv[1]), sys.argv[2:]
    file = os.open(program[0], os.O_RDONLY | os.O_CLOEXEC)
    limit(resource.RLIMIT_CORE, 0)
    limit(resource.RLIMIT_FSIZE, 0)
    limit(resource.RLIMIT_NOFILE, 64)
    limit(resource.RLIMIT_AS, limits["memory"] << 20)
    limit(resource.RLIMIT_CPU, limits["cpu"], margin=1)  # first SIGXCPU, then SIGKILL
    for ignored in signal.SIGPIPE, signal.SIGXFSZ:  # by Python
        signal.signal(ignored, signal.SIG_DFL)
    if refuse_system_calls():
        os.execve(file, program, os.environ)  # by its open file: the call that takes a path is gone
    os.execv(program[0], program)


if __name__ == "__main__":
    main()
