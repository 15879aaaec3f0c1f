"""Processor time of the programs that a test runs. A test never looks at the clock on the wall: other programs may keep
the machine busy for minutes. What hangs is ended by ctest, after an hour."""
import os
import resource
import time

TICKS = os.sysconf("SC_CLK_TCK")


def of_ended():
    """Seconds of processor time of all programs that this one has started and that have ended."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def of_running(process):
    """Seconds of processor time of a program that runs, in steps of 10 ms."""
    with open(f"/proc/{process.pid}/stat", encoding="ascii", errors="replace") as file:
        fields = file.read().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def wait(process, seconds):
    """Until the program has used so much processor time, or has ended."""
    while process.poll() is None and of_running(process) < seconds:
        time.sleep(0.005)
