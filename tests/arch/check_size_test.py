#!/usr/bin/env python3
"""Shows that check_size.py detects each kind of broken limit, and accepts code within the limits."""
import pathlib
import tempfile

import check_size

LINES = "  work();\n"
MEMBERS = "".join(f"  std::map<int, int> member_{i}_{{{i}}};\n" for i in range(11))
METHODS = "".join(f"  void declared_{i}(int x = 3);\n  int defined_{i}() const {{ return {i}; }}\n" for i in range(12))
OTHERS = ("  Many(const Many&) = delete;\n  ~Many() = default;\n  void (*call)(int) = nullptr;\n  std::function<void()> done;\n"
          "  int value = twice(3);\n  friend void swap(Many& a, Many& b);\n  using Made = int(int);\n")
BROKEN = {
    **{f"src/core/full/f{i}.h": "" for i in range(41)},
    "src/core/mesh/long.cpp": "namespace a {\nint f(int x = 3) {\n" + LINES * 59 + "}\n}\n",
    "src/core/mesh/wide.h": "class Wide final : public Base {\n public:\n  void f() const;\n private:\n" + MEMBERS
    + "  int a = 1, b = 2, c;\n" + MEMBERS.replace("member", "other") + "};\n",
    "src/core/mesh/many.h": "class Many {\n public:\n  explicit Many(int x) : value(x) {}\n" + METHODS
    + "  bool operator<(const Many& other) const;\n" + OTHERS + "};\n",
    "src/core/base/one.h": '#include "core/base/two.h"\n',
    "src/core/base/two.h": "",
    "src/core/base/two.cpp": '#include "core/base/one.h"\n',
    "src/core/base/tested.h": "",
    "src/core/base/used.cpp": '#include "core/base/tested.h"\n#include "core/base/shared.h"\n',
    "src/core/base/shared.h": "",
    "src/core/base/other.cpp": '#include "core/base/shared.h"\n',
    "tests/unit/base/tested_test.cpp": '#include "core/base/tested.h"\n',
    "src/ui/probe_state.h": "struct ProbeState {\n  std::function<void()> done;\n  std::mutex mutex;\n  const Mesh* mesh = nullptr;\n"
                            "  std::shared_ptr<Mesh> owned;\n  ImVec2 corner;\n  std::chrono::seconds since{0};\n};\n",
    "src/app/run.cpp": "void f() {\n  if (by_clock_) settle(done);\n  std::this_thread::sleep_for(1ms);\n}\n",
    "src/core/base/counter.cpp": "std::atomic<int> calls{0};\nint next() {\n  static int last = 0;\n  return ++last;\n}\n",
}
FINE = {
    **{f"src/core/few/f{i}.h": "" for i in range(40)},
    "src/core/mesh/long.cpp": "int f() {\n" + LINES * 58 + "}\nconst char* text = \"{\";  // {\nint g() {\n" + LINES * 58 + "}\n",
    "src/core/mesh/many.h": "struct Many {\n  explicit Many(int x) : value(x) {}\n" + METHODS + OTHERS + "};\n",
    "src/core/mesh/value.h": "struct Value {\n" + MEMBERS * 2 + "};\n",
    "src/core/base/one.h": '#include "core/base/two.h"\n',
    "src/core/base/two.h": "struct One;\n",
    "src/core/base/four.cpp": '#include "core/base/two.h"\n',
    "src/core/base/three.h": "",
    "src/core/base/three_impl.h": '#include "core/base/three.h"\n',
    "src/core/base/three.cpp": '#include "core/base/three_impl.h"\n',
    "src/ui/probe_state.h": "struct ProbeState {\n  std::optional<dvec3> at;\n  std::shared_ptr<const Mesh> mesh;\n  double depth = 2 * kStep;\n"
                            "  bool operator==(const ProbeState*) const;\n};\n",
    "src/app/probe_tool.h": "struct ProbeView {\n  const Mesh* mesh = nullptr;\n};\n",
    "src/app/run.cpp": "// by_clock\nvoid f() {\n  resettle(done);\n}\n",
    "src/core/base/counter.cpp": "static const int kFirst = 1;\nconstexpr double kStep = 2;\nstatic int next();\nusing Number = int;\n",
    "src/core/hydro/hydro_body.cpp": "Cache& cache() {\n  static Cache only;\n  return only;\n}\n",
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


expect(complaints(BROKEN), ["folder src/core/full: 41, a new offender", "function src/core/mesh/long.cpp f: 61, a new offender",
                            "methods src/core/mesh/many.h Many: 26, a new offender", "members src/core/mesh/wide.h Wide: 25, a new offender", "circle core/base/one: 2, a new offender",
                            "headers with one user: 2, a new offender", "impure src/ui/probe_state.h: 6, a new offender",
                            "wait src/app/run.cpp by_clock: 1, a new offender", "wait src/app/run.cpp sleep_for: 1, a new offender",
                            "wait src/app/run.cpp settle: 1, a new offender",
                            "mutable src/core/base/counter.cpp: 2, a new offender"])
expect(complaints(FINE), [])
offenders = ("folder src/core/full 42\nfunction src/core/mesh/long.cpp f 61\nmethods src/core/mesh/many.h Many 26\nmembers src/core/mesh/wide.h Wide 24\n"
             "circle core/base/one 2\nheaders with one user 2\nimpure src/ui/probe_state.h 6\nwait src/app/run.cpp by_clock 1\nwait src/app/run.cpp sleep_for 1\n"
             "wait src/app/run.cpp settle 1\nmutable src/core/base/counter.cpp 2\nfolder src/gone 30\n")
expect(complaints(BROKEN, offenders), ["members src/core/mesh/wide.h Wide: 25, was 24",
                                       "folder src/core/full: 41, offenders.txt says 42: lower it there",
                                       "folder src/gone: none, offenders.txt says 30: lower it there"])
print("every broken limit is seen")
