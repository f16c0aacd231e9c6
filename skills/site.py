"""Read a site file: YAML checked against ``skills.ports.site.Site``."""

from __future__ import annotations

from importlib import resources
from pathlib import Path
from typing import TypeVar

import yaml
from pydantic import BaseModel, ValidationError

from skills.ports.site import Site

Document = TypeVar("Document", bound=BaseModel)


class DocumentError(ValueError):
    """A file that can't be taken: says the file, the path in it, and what was expected."""


def describe(error: ValidationError) -> str:
    """Return pydantic's findings as lines "path: what was expected"."""
    lines = []
    for finding in error.errors(include_url=False):
        path = ".".join(str(part) for part in finding["loc"]) or "(the document)"
        lines.append(f"{path}: {finding['msg']}")
    return "\n".join(lines)


def parse(text: str, model: type[Document], source: str) -> Document:
    """Return the YAML text as a model.

    Raises:
        DocumentError: naming ``source``, the path in it, and what was expected.
    """
    try:
        data = yaml.safe_load(text)
    except yaml.YAMLError as error:
        raise DocumentError(f"{source}: YAML was expected: {error}") from None
    try:
        return model.model_validate(data)
    except ValidationError as error:
        raise DocumentError(f"{source}: {describe(error)}") from None


def names() -> tuple[str, ...]:
    """Return the names of the sites that come with the package."""
    folder = resources.files("skills") / "sites"
    return tuple(
        sorted(each.name.removesuffix(".yaml") for each in folder.iterdir() if each.name.endswith(".yaml"))
    )


def load(name_or_path: str) -> Site:
    """Return a site by its name, or by the path of a file.

    Raises:
        DocumentError: when there is no such site, or when it is wrong.
    """
    path = Path(name_or_path)
    if path.suffix in {".yaml", ".yml"}:
        try:
            return parse(path.read_text(encoding="utf-8"), Site, str(path))
        except OSError as error:
            raise DocumentError(f"{path}: a readable site file was expected: {error.strerror}") from None
    if name_or_path not in names():
        raise DocumentError(
            f"no site {name_or_path!r}; there are {', '.join(names())}, or give a path to a .yaml"
        )
    return parse(
        (resources.files("skills") / "sites" / f"{name_or_path}.yaml").read_text("utf-8"), Site, name_or_path
    )
