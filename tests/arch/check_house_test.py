#!/usr/bin/env python3
"""Shows that check_house.py detects each kind of broken rule."""
import pathlib
import tempfile

import check_house

BROKEN = {
    "core/mesh/a.cpp": '#include "core/hydro/clip.h"\n',
    "core/base/b.cpp": '#include "ui/theme.h"\n',
    "core/layout/c.cpp": "#include <nlohmann/json.hpp>\n",
    "core/hydro/d.cpp": "#include <mujoco/mujoco.h>\n",
    "core/sensor/e.cpp": "#include <iostream>\n",
    "core/layout/f.cpp": "#include <OpenMesh/Core/IO/MeshIO.hh>\n",
    "ui/g.cpp": '#include "core/sim/simulator.h"\n',
    "ui/widgets/h.cpp": "#include <fstream>\n",
    "ui/scene/l.cpp": '#include "app/studio/frame/ui_state.h"\n',
    "app/studio/nouns/probe/probe_tool.cpp": '#include "core/base/files.h"\n',
    "app/studio/nouns/probe/probe_job.cpp": "#include <imgui.h>\n",
    "app/studio/frame/feature.cpp": '#include "app/studio/nouns/probe/probe_state.h"\n',
    "app/studio/host/session.cpp": '#include "app/studio/shell/studio.h"\n',
    "app/cli/i.cpp": "#include <imgui.h>\n",
    "app/cli/commands/l.cpp": "#include <CLI/CLI.hpp>\n",
    "core/layout/sampling/j.cpp": "const double x = std::sin(1.0);\n",
    "core/base/rng.h": "std::normal_distribution<> normal;\n",
    "core/run/history/m.cpp": "#include <sys/mman.h>\n",
    "app/cli/n.cpp": "#include <csignal>\n",
    "app/studio/host/document/o.cpp": "#include <unistd.h>\n",
    "app/studio/frame/p.cpp": 'const char* home = std::getenv("HOME");\n',
    "core/sim/q.cpp": "#ifdef __linux__\n",
    "app/studio/host/document/s.cpp": "state.problem = error.what();\n",
    "ui/gl/window.cpp": "#include <epoxy/egl.h>\n",
    "core/base/os/r.cpp": "#include <portable_file_dialogs.h>\n",
    "core/mesh/long.cpp": "// line\n" * 601,
    "core/hydro/kernel/far.h": "",
}
SOURCES_OF_KERNEL = {
    "core/hydro/near.h": '#include "core/hydro/kernel/far.h"\n',
    **{f"core/hydro/u{i}.cpp": '#include "core/hydro/near.h"\n' for i in range(check_house.MAX_KERNEL_SOURCES + 1)},
}
FINE = {
    "core/base/os/process.cpp": "#include <spawn.h>\n#include <sys/wait.h>\nextern char** environ;\n",
    "ui/gl/offscreen_context.cpp": "#include <epoxy/egl.h>\n",
    "core/base/os/file_chooser.cpp": "#include <portable_file_dialogs.h>\n",
    "core/mesh/topology/half_edges.cpp": '#include <OpenMesh/Core/IO/MeshIO.hh>\n#include "core/base/error.h"\n',
    "core/layout/file/layout_json.cpp": "#include <nlohmann/json.hpp>\n",
    "core/layout/sampling/k.cpp": "const double x = std::sqrt(2.0);  // not std::sin\n",
    "core/layout/check/layout_check.cpp": "const double x = std::sin(1.0);\n",
    "core/sim/simulator.cpp": '#include <mujoco/mujoco.h>\n#include "core/hydro/traction.h"\n',
    "ui/scene/scene.cpp": '#include <epoxy/gl.h>\n#include "core/run/frame.h"\n',
    "app/cli/command_line.cpp": "#include <CLI/CLI.hpp>\n",
    "app/studio/nouns/probe/probe_overlay.cpp": '#include "app/studio/nouns/probe/probe_state.h"\n',
    "app/studio/features.cpp": '#include "app/studio/nouns/explain/explain_panel.h"\n',
    **{f"core/hydro/v{i}.cpp": '#include "core/hydro/kernel/near.h"\n' for i in range(check_house.MAX_KERNEL_SOURCES)},
    "app/studio/main.cpp": "#include <GLFW/glfw3.h>\n#include <imgui.h>\n",
    "app/studio/host/document/t.cpp": "state.problem = shown_message(error);  // not error.what()\n",
}


def broken_files(files):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = pathlib.Path(folder) / "src" / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return sorted({line.split(":")[0].removeprefix("src/") for line in check_house.complaints(folder)})


found = broken_files(BROKEN | SOURCES_OF_KERNEL)
assert found == sorted(BROKEN), f"not seen: {sorted(set(BROKEN) - set(found))}"
found = broken_files(FINE)
assert not found, f"wrongly blamed: {found}"
print("every broken rule is seen")
