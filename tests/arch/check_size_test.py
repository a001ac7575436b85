#!/usr/bin/env python3
"""Shows that check_size.py sees each kind of broken limit, and lets pass what keeps them."""
import pathlib
import tempfile

import check_size

LINES = "  work();\n"
MEMBERS = "".join(f"  std::map<int, int> member_{i}_{{{i}}};\n" for i in range(11))
BROKEN = {
    **{f"src/core/full/f{i}.h": "" for i in range(26)},
    "src/core/mesh/long.cpp": "namespace a {\nint f(int x = 3) {\n" + LINES * 59 + "}\n}\n",
    "src/core/mesh/wide.h": "class Wide final : public Base {\n public:\n  void f() const;\n private:\n" + MEMBERS
    + "  int a = 1, b = 2, c;\n" + MEMBERS.replace("member", "other") + "};\n",
    "src/core/base/one.h": '#include "core/base/two.h"\n',
    "src/core/base/two.h": "",
    "src/core/base/two.cpp": '#include "core/base/one.h"\n',
}
FINE = {
    **{f"src/core/few/f{i}.h": "" for i in range(25)},
    "src/core/mesh/long.cpp": "int f() {\n" + LINES * 58 + "}\nconst char* text = \"{\";  // {\nint g() {\n" + LINES * 58 + "}\n",
    "src/core/mesh/value.h": "struct Value {\n" + MEMBERS * 2 + "};\n",
    "src/core/base/one.h": '#include "core/base/two.h"\n',
    "src/core/base/two.h": "struct One;\n",
    "src/core/base/three.h": "",
    "src/core/base/three_impl.h": '#include "core/base/three.h"\n',
    "src/core/base/three.cpp": '#include "core/base/three_impl.h"\n',
}


def complaints(files, offenders=""):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {**files, "tests/arch/offenders.txt": offenders}.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return list(check_size.complaints(folder))


def expect(found, wanted):
    assert found == wanted, f"{found} instead of {wanted}"


expect(complaints(BROKEN), ["folder src/core/full: 26, a new offender", "function src/core/mesh/long.cpp f: 61, a new offender",
                            "members src/core/mesh/wide.h Wide: 25, a new offender", "circle core/base/one: 2, a new offender"])
expect(complaints(FINE), [])
known = ("folder src/core/full 27\nfunction src/core/mesh/long.cpp f 61\nmembers src/core/mesh/wide.h Wide 24\n"
         "circle core/base/one 2\nfolder src/gone 30\n")
expect(complaints(BROKEN, known), ["members src/core/mesh/wide.h Wide: 25, was 24",
                                   "folder src/core/full: 26, offenders.txt says 27: lower it there",
                                   "folder src/gone: none, offenders.txt says 30: lower it there"])
print("every broken limit is seen")
