"""Checks that state headers hold plain values, that scripts never wait, and that few variables outlive a function."""
import pathlib
import re

from cpp_text import bare, scopes

CODE = (".h", ".cpp")

# A state of the window is compared, copied and written to a file, so it holds plain values and shared constant values.
STATE_FOLDERS = ("src/ui", "src/app")
STATE_NAME = re.compile(r".*_state\.h|features\.h|app\.h")
IMPURE = {
    "a function": re.compile(r"\bstd::(?:move_only_)?function\b"),
    "a thread": re.compile(r"\bstd::(?:jthread|thread|mutex|shared_mutex|atomic|condition_variable|future|promise)\b"),
    "a raw pointer": re.compile(r"\*\s*(?:const\s*)?\w+\s*(?:,|$)"),
    "a shared value that can change": re.compile(r"\b(?:std::)?(?:shared_ptr<(?!\s*const\b)|unique_ptr<|weak_ptr<)"),
    "ImGui": re.compile(r"\bIm(?:Gui|Vec[24]|Draw|Plot|Rect|Font)\w*"),
    "a clock": re.compile(r"\bstd::chrono\b|\bClock\b"),
}

# Word -> folders in which the word is forbidden. A script runs without waiting, so no other code depends on the clock.
WAITS = {"by_clock": ("src", "tests", "bench"), "sleep_for": ("src", "tests", "bench"), "settle(": ("src/app", "src/core/sim")}

# The mutable variables that may live as long as the program, each with the reason.
MUTABLE_STATICS = {
    "src/core/hydro/hydro_body.cpp": "keyed by content, so that no result depends on it",
    "src/core/base/output.cpp": "the files to delete when a signal ends the program",
    "src/core/sensor/stored_samples.cpp": "whether programs keep samples on disk, on which no result depends",
    "src/core/sim/plugin/side_by_side.h": "counts the simulations that compute now; no result depends on it",
    "src/app/plugin/register.cpp": "the functions of the loaded MuJoCo, which gives a plugin's init no data of its own",
    "src/core/sim/plugin/plugin_table.cpp": "MuJoCo's plugin_data has room for a number only",
    "src/core/sim/plugin/shared/shared_parts.cpp": "keyed by content, so that no result depends on it",
    "src/app/cli/signals.cpp": "a signal handler sees nothing else",
    "src/app/studio/shell/studio.cpp": "a signal handler sees nothing else",
}
STATIC = re.compile(r"\b(?:static|thread_local)\b(?! const\b| constexpr\b| inline const)[^;{(=]*[;{=]")
AT_NAMESPACE = re.compile(
    r"^(?!(?:using|return|struct|class|friend|typedef|namespace|extern|template|concept|enum|public|private)\b)"
    r"(?:inline\s+)?[a-zA-Z][\w:<>, *]*[\s*]\w+(?:\s*=[^;(]*|\{[^;]*\})?;$", re.M)


def files(root, folder):
    return [path for path in sorted((pathlib.Path(root) / folder).rglob("*")) if path.suffix in CODE]


def members(text):
    """Yields the data members of all types of a header, as they are declared."""
    for scope in scopes(text):
        if scope.kind == "type":
            for statement in scope.statements:
                plain = re.sub(r"<[^<>]*>", "<>", re.sub(r"<[^<>]*>", "", statement))
                is_method = "(" in re.split(r"[={]", plain)[0] or "operator" in plain
                if not is_method and not re.match(r"(using|friend|static)\b", statement):
                    yield re.split(r"[={]", statement)[0]


def impure_members(text):
    """Yields messages about the members of a state header that are not plain values."""
    for member in members(text):
        for what, pattern in IMPURE.items():
            if pattern.search(member):
                yield f"{what}: {' '.join(member.split())}"


def impure_states(root):
    """Yields pairs of the offender and its figure, as in check_size.py, like the two functions below."""
    for folder in STATE_FOLDERS:
        for path in files(root, folder):
            if STATE_NAME.fullmatch(path.name):
                count = len(list(impure_members(path.read_text())))
                if count:
                    yield f"impure {path.relative_to(root).as_posix()}", count


def waits(root):
    for word, folders in WAITS.items():
        pattern = re.compile(r"(?<![a-zA-Z])" + re.escape(word))
        for path in (path for folder in folders for path in files(root, folder)):
            count = len(pattern.findall(bare(path.read_text())))
            if count:
                yield f"wait {path.relative_to(root).as_posix()} {word.rstrip('(')}", count


def mutable_statics(root):
    for path in files(root, "src"):
        name, text = path.relative_to(root).as_posix(), bare(path.read_text())
        found = STATIC.findall(text)
        found += [m for m in AT_NAMESPACE.findall(text) if not re.search(r"\bconst(?:expr|init)?\b", m)]
        if found and name not in MUTABLE_STATICS:
            yield f"mutable {name}", len(found)
