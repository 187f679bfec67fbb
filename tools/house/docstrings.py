"""Every function that a header declares says what it does, in a comment right above it."""

import re

from house.source_tree import Finding, blank_comments

# Nothing to say: what the compiler writes itself, and members that only hand a field on or store their arguments.
# An override means what the class above it documents.
SILENT = re.compile(r"=\s*(default|delete)\s*$|^\s*(virtual\s+)?~|\boverride\b")
NO_FUNCTION = re.compile(r"^\s*(using|typedef|static_assert|friend|return|layout|extern\s+template)\b")


def without_angles(head: str) -> str:
    """`head` without balanced <...>, so that std::function<void(int)> has no parenthesis left."""
    head = re.sub(r"operator\s*(<=>|<<|>>|<=|>=|<|>|->)", "operator_", head)
    previous = None
    while previous != head:
        previous = head
        head = re.sub(r"<[^<>]*>", "", head)
    return head


def function_name(head: str) -> str | None:
    """The function that the declaration `head` declares, None where it declares something else."""
    head = re.sub(r"\[\[.*?\]\]|\b(alignas|decltype)\s*\([^)]*\)", " ", without_angles(head))
    if NO_FUNCTION.match(head) or "(" not in head:
        return None
    before = head[:head.index("(")]
    if "=" in before and "operator" not in before:
        return None
    name = re.search(r"(operator\s*[^\s(]*|~?\w+)\s*$", before)
    return name.group(1) if name else None


def declarations(text: str):
    """Yields (line counted from 1, head, body) of what stands at namespace or public type scope; body None without one."""
    clean = blank_comments(text)
    scopes, start, index, line = [], None, 0, 1
    hidden = set()  # depths whose last label is private
    while index < len(clean):
        character = clean[index]
        if character == "\n":
            line += 1
        open_scope = not scopes or scopes[-1] == "open"
        if open_scope and start is None and not character.isspace() and character not in "};":
            start, start_line = index, line
        if character == "{":
            head = clean[start:index] if start is not None else ""
            is_open = open_scope and re.search(r"\b(namespace|struct|class|union|extern)\b", without_angles(head)) \
                and not re.search(r"\benum\b", head) and function_name(head) is None
            if open_scope and function_name(head):
                end = matching_brace(clean, index)
                # A constructor's initialisers may be braced: then the body follows.
                while re.match(r"\s*(,|\{)", clean[end + 1:]) and re.search(r"\)\s*:", clean[start:index]):
                    index = clean.index("{", end + 1)
                    end = matching_brace(clean, index)
                if not hidden:
                    yield start_line, head, clean[index:end + 1]
                line += clean.count("\n", index, end + 1)
                index, start = end + 1, None
                continue
            scopes.append("open" if is_open else "closed")
            if is_open:
                if re.match(r"\s*(template\s*)?class\b", without_angles(head)):
                    hidden.add(len(scopes))
                start = None
        elif character == "}":
            if scopes:
                hidden.discard(len(scopes))
                scopes.pop()
        elif character == ";" and open_scope:
            if start is not None and not hidden:
                yield start_line, clean[start:index], None
            start = None
        elif character == ":" and open_scope and start is not None and \
                re.fullmatch(r"\s*(public|private|protected)\s*", clean[start:index]):
            if "private" in clean[start:index]:
                hidden.add(len(scopes))
            else:
                hidden.discard(len(scopes))
            start = None
        index += 1


def matching_brace(text: str, opening: int) -> int:
    """The offset of the brace that closes the one at `opening`, or the last offset where none does."""
    depth = 0
    for index in range(opening, len(text)):
        depth += {"{": 1, "}": -1}.get(text[index], 0)
        if depth == 0:
            return index
    return len(text) - 1


def is_obvious(head: str, body: str | None) -> bool:
    """An accessor of one return, a constructor that only stores, or what the compiler writes."""
    if SILENT.search(head):
        return True
    if body is None:
        return False
    return bool(re.fullmatch(r"\{\s*(return\s+\*?\w+;)?\s*\}", body)) or \
        bool(re.search(r"\)\s*(noexcept)?\s*:", head) and re.fullmatch(r"\{\s*\}", body))


def is_called_elsewhere(name: str, path: str, texts: dict[str, str]) -> bool:
    """Whether another shader file than `path` names the function."""
    return any(re.search(rf"\b{re.escape(name)}\b", text) for other, text in texts.items()
               if other != path and other.startswith("shaders/") and other.endswith((".glsl", ".comp", ".h")))


def check_docstrings(texts: dict[str, str]) -> list[Finding]:
    """Functions without a comment above them: `///` in headers of src/; `//` in shaders, for what another file calls."""
    findings = []
    for path, text in texts.items():
        in_shaders = path.startswith("shaders/") and path.endswith((".glsl", ".h"))
        if not in_shaders and not (path.startswith("src/") and path.endswith(".h")):
            continue
        marker = "//" if in_shaders else "///"
        lines = text.split("\n")
        documented = set()
        for line, head, body in declarations(text):
            name = function_name(head)
            if name is None or is_obvious(head, body):
                continue
            # A shader has no headers: what counts is what another file calls and cannot read at a glance.
            if in_shaders and ("\n" not in (body or "") or not is_called_elsewhere(name, path, texts)):
                continue
            above = lines[line - 2].strip() if line > 1 else ""
            if above.startswith(marker) or "///<" in lines[line - 1]:
                documented.add(name)
            elif name not in documented:
                findings.append(Finding(path, line, f"{name}() has no {marker} comment above it"))
    return findings
