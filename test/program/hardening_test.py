#!/usr/bin/env python3
"""The program is hardened as cmake/hardening.cmake says: read from its ELF file.

TAUT_PROGRAM names the program.
"""
import os
import pathlib
import struct
import unittest

PROGRAM = pathlib.Path(os.environ["TAUT_PROGRAM"])
SANITIZED = bool(os.environ.get("TAUT_FEWER"))

ET_DYN = 3
PT_DYNAMIC, PT_INTERP, PT_GNU_STACK, PT_GNU_RELRO = 2, 3, 0x6474E551, 0x6474E552
DT_STRTAB, DT_SYMTAB, DT_STRSZ, DT_BIND_NOW, DT_FLAGS, DT_FLAGS_1 = 5, 6, 10, 24, 30, 0x6FFFFFFB
DF_BIND_NOW, DF_1_NOW, DF_1_PIE = 8, 1, 0x08000000
EXECUTABLE = 1


class Elf:
    """What the loader sees of a 64-bit little-endian ELF file."""

    def __init__(self, data):
        self.data = data
        if data[:6] != b"\x7fELF\x02\x01":
            raise unittest.SkipTest("no 64-bit little-endian ELF file")
        self.type = struct.unpack_from("<H", data, 16)[0]
        start, = struct.unpack_from("<Q", data, 32)
        size, count = struct.unpack_from("<HH", data, 54)
        # type, flags, offset, address, physical address, size in the file, size in memory, alignment
        self.segments = [struct.unpack_from("<IIQQQQQQ", data, start + i * size) for i in range(count)]
        self.dynamic = {}
        for tag, value in self.pairs(self.segment(PT_DYNAMIC)):
            self.dynamic.setdefault(tag, value)

    def segment(self, kind):
        return next((s for s in self.segments if s[0] == kind), None)

    def pairs(self, segment):
        for i in range(segment[2], segment[2] + segment[5], 16):
            tag, value = struct.unpack_from("<QQ", self.data, i)
            if tag == 0:
                return
            yield tag, value

    def offset(self, address):
        for s in self.segments:
            if s[0] == 1 and s[3] <= address < s[3] + s[5]:
                return address - s[3] + s[2]
        raise ValueError(hex(address))

    def imported(self):
        """Names of the dynamic symbols: those that the program takes from shared libraries are among them."""
        begin = self.offset(self.dynamic[DT_STRTAB])
        return set(self.data[begin:begin + self.dynamic[DT_STRSZ]].decode(errors="replace").split("\0"))


@unittest.skipIf(SANITIZED, "the sanitizers' build is not hardened: they check the same and more")
class Hardening(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.elf = Elf(PROGRAM.read_bytes())

    def test_it_is_position_independent(self):
        self.assertEqual(self.elf.type, ET_DYN)
        self.assertIsNotNone(self.elf.segment(PT_INTERP), "a program, not a library")
        self.assertTrue(self.elf.dynamic.get(DT_FLAGS_1, 0) & DF_1_PIE)

    def test_its_tables_are_read_only(self):
        self.assertIsNotNone(self.elf.segment(PT_GNU_RELRO))
        now = DT_BIND_NOW in self.elf.dynamic or self.elf.dynamic.get(DT_FLAGS, 0) & DF_BIND_NOW or \
            self.elf.dynamic.get(DT_FLAGS_1, 0) & DF_1_NOW
        self.assertTrue(now)

    def test_its_stack_holds_no_code(self):
        self.assertFalse(self.elf.segment(PT_GNU_STACK)[1] & EXECUTABLE)

    def test_its_bounds_are_checked(self):
        names = self.elf.imported()
        self.assertIn("__stack_chk_fail", names)
        self.assertTrue(any(name.endswith("_chk") for name in names), "no function of FORTIFY")
        self.assertTrue(any("__glibcxx_assert_fail" in name for name in names), "no assertion of the standard library")

    def test_our_own_code_checks_its_bounds(self):
        """The archives of others that are linked in do so anyway; ours holds the names that its objects ask for."""
        archive = PROGRAM.parent.parent / "libtaut.a"
        if not archive.exists():
            self.skipTest("no archive beside the program")
        data = archive.read_bytes()
        for name in (b"\0__stack_chk_fail\0", b"__memcpy_chk\0", b"__glibcxx_assert_fail"):
            self.assertTrue(name in data, name)


if __name__ == "__main__":
    unittest.main()
