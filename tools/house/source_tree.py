"""The files of the repository as the house rules see them."""

import dataclasses
import pathlib
import re
import subprocess

SOURCE_SUFFIXES = {".h", ".cpp", ".glsl", ".comp", ".py"}
TEXT_SUFFIXES = SOURCE_SUFFIXES | {".md", ".txt", ".json", ".cmake", ".obj", ".mtl", ".gltf", ".html", ""}


@dataclasses.dataclass(frozen=True)
class Finding:
    """One broken rule: file relative to the repository, line counted from 1, what is wrong."""

    path: str
    line: int
    what: str

    def __str__(self):
        return f"{self.path}:{self.line}: {self.what}"


def list_files(root: pathlib.Path) -> list[str]:
    """Paths relative to `root` of all files that git has or would add; without git all but build/ and dot folders."""
    listing = subprocess.run(
        ["git", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        capture_output=True, text=True, check=False)
    if listing.returncode == 0:
        names = [name for name in listing.stdout.split("\0") if name]
    else:
        names = [str(path.relative_to(root)) for path in root.rglob("*")
                 if path.is_file() and not path.relative_to(root).parts[0] in {"build", ".git"}]
    return sorted(name for name in names if (root / name).is_file())


def read_texts(root: pathlib.Path) -> dict[str, str]:
    """Contents of all text files by relative path. Bytes that are not UTF-8 become U+FFFD."""
    return {name: (root / name).read_text(encoding="utf-8", errors="replace")
            for name in list_files(root) if pathlib.PurePath(name).suffix in TEXT_SUFFIXES}


def is_source(path: str) -> bool:
    """Whether the rules of style apply: code, build files and tools, not documents, scenes or licences."""
    name = pathlib.PurePath(path)
    return name.suffix in SOURCE_SUFFIXES or name.name == "CMakeLists.txt" or (
        name.parts[0] in {"tools", ".ci"} and name.suffix == "")


def line_of(text: str, offset: int) -> int:
    """The line, counted from 1, that `offset` of `text` lies on."""
    return text.count("\n", 0, offset) + 1


def blank_comments(text: str) -> str:
    """`text` of C++ or GLSL with comments, string contents and preprocessor lines as spaces; offsets stay."""
    def spaces(match):
        token = match.group(0)
        if token[0] in "\"'":
            return token[0] + " " * (len(token) - 2) + token[-1]
        return re.sub(r"[^\n]", " ", token)
    text = re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|(?<![0-9a-fA-F])\'(?:\\.|[^\'\\\n])+\'', spaces, text,
                  flags=re.DOTALL)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", spaces, text, flags=re.MULTILINE)
