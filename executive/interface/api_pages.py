"""The pages of the public API, ``docs/api/``, made from the modules that a plug-in may import.

Run ``python -m tandem.executive.interface.api_pages docs/api``. A test compares the pages with the code.
"""

from __future__ import annotations

import importlib
import inspect
import re
import sys
from enum import EnumMeta
from pathlib import Path
from types import ModuleType
from typing import Annotated, Final, get_args, get_origin

from pydantic.fields import FieldInfo

from tandem.skills.ports.message import Message

MODULES: Final = (
    "tandem.client",
    "tandem.testing",
    "tandem.api",
    "tandem.api.actions",
    "tandem.api.detectors",
    "tandem.api.reflexes",
    "tandem.api.robots",
    "tandem.api.roles",
    "tandem.api.skills",
    "tandem.api.tasks",
)
"""The surface: each name in ``__all__`` of these."""
_OF_PY_TREES: Final = ("initialise", "update", "terminate")
"""Methods that every node has; the pages leave them out."""
_MIX_INS: Final = ("tandem.skills.testing.mock_servers",)
"""Modules with a part of a public class: nobody imports that part by itself."""
_INDEX: Final = """# API

A package of your own may import the names on these pages. Version {version} of this surface: a name that
stands here is removed or changed with a new version only, and the CHANGELOG says so.
All other modules of Tandem may change at any time. `tandem.api.VERSION` is the version of what is installed.

| module | what it holds |
| --- | --- |
{rows}

The pages are generated: `python -m tandem.executive.interface.api_pages docs/api`.
"""


def names() -> tuple[str, ...]:
    """Return the full names of the surface, sorted."""
    modules = [importlib.import_module(name) for name in MODULES]
    return tuple(sorted(f"{module.__name__}.{name}" for module in modules for name in module.__all__))


def pages() -> dict[str, str]:
    """Return each page's Markdown by its file name."""
    modules = [importlib.import_module(name) for name in MODULES]
    rows = "\n".join(f"| [`{each.__name__}`]({_file(each)}) | {_first_line(each)} |" for each in modules)
    version = importlib.import_module("tandem.api").VERSION
    index = _INDEX.format(version=version, rows=rows)
    return {"README.md": index, **{_file(each): _page(each) for each in modules}}


def _file(module: ModuleType) -> str:
    return f"{module.__name__.removeprefix('tandem.').replace('.', '-')}.md"


def _first_line(module: ModuleType) -> str:
    return _doc(module).splitlines()[0]


def _page(module: ModuleType) -> str:
    parts = [f"# {module.__name__}", _doc(module)]
    for name in sorted(module.__all__, key=str.lower):
        parts += [f"## {name}", *_entry(name, getattr(module, name))]
    return "\n\n".join(parts) + "\n"


def _entry(name: str, value: object) -> list[str]:
    if inspect.isclass(value) or inspect.isfunction(value):
        methods = _methods(value) if inspect.isclass(value) else []
        return [f"```text\n{_signature(name, value)}\n```", _doc(value), *methods]
    if get_origin(value) is Annotated:
        kind, *about = get_args(value)
        what = next((each.description for each in about if isinstance(each, FieldInfo)), "")
        return [f"```text\n{name} = Annotated[{kind.__name__}, ...]\n```", f"A field: {what}."]
    if get_origin(value) is not None:
        return [f"```text\n{name} = {_plain(str(value))}\n```"]
    said = next((getattr(value, each) for each in ("name", "key", "words") if hasattr(value, each)), value)
    return [f"```text\n{name}: {type(value).__name__} ({said})\n```"]


def _methods(cls: type) -> list[str]:
    """Return the public methods and properties of the class, each with its first line.

    Those that it inherits from a mix-in of ours are its own to who calls them.
    """
    lines = []
    declared = dict(vars(cls))
    for base in cls.__mro__[1:]:
        if base.__module__ in _MIX_INS:
            declared |= {name: value for name, value in vars(base).items() if name not in declared}
    for name, value in declared.items():
        documented = inspect.isfunction(value) or isinstance(value, property)
        if documented and not name.startswith("_") and name not in _OF_PY_TREES and inspect.getdoc(value):
            shown = _signature(name, value) if inspect.isfunction(value) else name
            lines.append(
                f"- `{shown.replace('(self, ', '(').replace('(self)', '()')}`: {_doc(value).splitlines()[0]}"
            )
    return ["\n".join(lines)] if lines else []


def _signature(name: str, value: object) -> str:
    if isinstance(value, EnumMeta):
        return f"{name}: {', '.join(value.__members__)}"
    if inspect.isclass(value) and issubclass(value, Message):
        fields = (each if info.is_required() else f"{each}=..." for each, info in value.model_fields.items())
        return f"{name}({', '.join(fields)})"
    assert callable(value), f"{name} is a class or a function"
    try:
        signature = str(inspect.signature(value))
    except ValueError:
        return name
    return _plain(f"{name}{signature}")


def _plain(text: str) -> str:
    """Return it without the quotes of annotations, the paths of modules, and addresses."""
    text = re.sub(r"\b(?:[a-z_]\w*\.)+([A-Z_]\w*)", r"\1", text)
    text = re.sub(r" at 0x[0-9a-f]+", "", text)
    return re.sub(r"(?<=[ :>\[(|,])'([A-Za-z_][^']*)'", r"\1", text)


def _doc(value: object) -> str:
    """Return a docstring as Markdown: without indentation, and with code in single backticks."""
    text = inspect.getdoc(value) or ""
    text = re.sub(r"^(Args|Raises|Returns):$", r"**\1**\n", text, flags=re.MULTILINE)
    text = re.sub(r"^    (\w+): ", r"- `\1`: ", text, flags=re.MULTILINE)
    text = re.sub(r"^        +(?=\S)", "  ", text, flags=re.MULTILINE)
    return text.replace("``", "`")


def main(argv: list[str]) -> int:
    """Write the pages into the folder named."""
    folder = Path(argv[0])
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in pages().items():
        (folder / name).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
