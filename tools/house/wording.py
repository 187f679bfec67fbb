"""Names, numbers and notes that do not belong in this house."""

import re

from house.source_tree import Finding, blank_comments, is_source, line_of

LINE_LIMIT = 300
TOP_LEVEL = {"CMakeLists.txt", "CMakePresets.json", "README.md", "LICENSE", "src", "shaders", "scenes", "tests", "tools"}

FILE_WORDS = {"manager", "helper", "helpers", "util", "utils", "common", "misc", "handler", "data", "info", "base",
              "process", "impl", "ex", "2"}
TYPE_WORDS = {"Manager", "Helper", "Helpers", "Util", "Utils", "Common", "Misc", "Handler", "Data", "Info", "Base",
              "Process", "Impl", "Ex", "2"}
FUNCTION_WORDS = {"manager", "helper", "helpers", "util", "utils", "misc", "handler", "impl"}

# Written in parts, so that these rules do not find themselves.
UNFINISHED = re.compile(r"\b(TO" + r"DO|FIX" + r"ME|XX" + r"X|HA" + r"CK)\b")
MACHINE_PATH = re.compile(r"(?<![\w./$}])/(ho" + r"me|wo" + r"rk|ro" + r"ot|Us" + r"ers)/\w|(?<![\w./$}])/t" + r"mp/\w")
TOLERANCE = re.compile(r"(?<![\w.])(\d+\.?\d*|\.\d+)[eE]-0?([3-9]|[1-9]\d)f?\b|(?<![\w.])0?\.000+\d+f?\b|"
                       r"\b0x[0-9a-fA-F.]+p-\d+f?\b")


def words_of(name: str) -> set[str]:
    """The words of a snake_case or UpperCamel name, a trailing digit apart."""
    return set(re.findall(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])|\d+", name))


def check_top_level(paths) -> list[Finding]:
    """Entries of the repository's root that the house does not have."""
    entries = {path.split("/")[0] for path in paths}
    return [Finding(entry, 1, "does not belong at the top level") for entry in sorted(entries)
            if entry not in TOP_LEVEL and not entry.startswith(".")]


def check_names(texts: dict[str, str]) -> list[Finding]:
    """Empty words in names of files, types and functions."""
    findings = []
    for path, text in texts.items():
        if not is_source(path):
            continue
        stem = path.split("/")[-1].split(".")[0]
        for word in sorted({word.lower() for word in words_of(stem)} & FILE_WORDS):
            findings.append(Finding(path, 1, f"the file name says '{word}': name what it holds"))
        if not path.endswith((".h", ".cpp", ".glsl", ".comp")):
            continue
        clean = blank_comments(text)
        for match in re.finditer(r"\b(?:class|struct|enum|union|namespace)\s+(\w+)\s*(?:final\s*)?[:{]", clean):
            for word in sorted(words_of(match.group(1)) & TYPE_WORDS):
                findings.append(Finding(path, line_of(clean, match.start(1)), f"{match.group(1)}: '{word}' says nothing"))
        for match in re.finditer(r"^[\w:<>&*, \t]*[\w>&*]\s+(\w+)\([^;{]*\)[\w\s]*\{", clean, flags=re.MULTILINE):
            for word in sorted(words_of(match.group(1)) & FUNCTION_WORDS):
                findings.append(Finding(path, line_of(clean, match.start(1)), f"{match.group(1)}: '{word}' says nothing"))
    return findings


def check_lines(texts: dict[str, str]) -> list[Finding]:
    """Files that are too long, unfinished notes, paths of one machine."""
    findings = []
    for path, text in texts.items():
        if is_source(path) and (length := text.count("\n")) > LINE_LIMIT:
            findings.append(Finding(path, LINE_LIMIT + 1, f"{length} lines; the limit is {LINE_LIMIT}: split by concept"))
        if path == "LICENSE":
            continue
        for number, line in enumerate(text.split("\n"), 1):
            if match := UNFINISHED.search(line):
                findings.append(Finding(path, number, f"{match.group(1)}: finish it or open an issue"))
            if match := MACHINE_PATH.search(line):
                findings.append(Finding(path, number, f"{match.group(0)}...: a path of one machine"))
    return findings


def check_tolerances(texts: dict[str, str]) -> list[Finding]:
    """Small numbers in shaders without a comment on their line or right above."""
    findings = []
    for path, text in texts.items():
        if not path.startswith("shaders/") or path.endswith(".md"):
            continue
        code = blank_comments(text).split("\n")
        lines = text.split("\n")
        for number, line in enumerate(code, 1):
            if (match := TOLERANCE.search(line)) and "//" not in lines[number - 1] and \
                    not (number > 1 and lines[number - 2].strip().startswith("//")):
                findings.append(Finding(path, number, f"{match.group(0)} stands there without a reason"))
    return findings


def check_effects(texts: dict[str, str]) -> list[Finding]:
    """Effect ids that are not one bit each from 0 up, or that no file of src/effects knows."""
    path = "shaders/shared/effects.h"
    if path not in texts:
        return [Finding(path, 1, "is missing")]
    text = texts[path]
    effects = re.findall(r"^#define\s+(EFFECT_\w+)\s+\(1u << (\d+)\)", text, flags=re.MULTILINE)
    count = re.search(r"^#define\s+EFFECT_COUNT\s+(\d+)u", text, flags=re.MULTILINE)
    findings = []
    if [int(bit) for _, bit in effects] != list(range(len(effects))):
        findings.append(Finding(path, 1, "the bits do not count up from 0"))
    if not count or int(count.group(1)) != len(effects):
        findings.append(Finding(path, 1, f"EFFECT_COUNT is not {len(effects)}"))
    knowing = "\n".join(text for name, text in texts.items() if re.match(r"src/effects/.*\.(h|cpp)$", name))
    for name, _ in effects:
        if not re.search(rf"\b{name}\b", knowing):
            line = line_of(text, text.index(name))
            findings.append(Finding(path, line, f"{name} has no row and no rule in src/effects"))
    return findings
