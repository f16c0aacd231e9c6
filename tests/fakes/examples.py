"""The files of ``examples/`` as modules."""

from __future__ import annotations

import importlib.util
import sys
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Final

EXAMPLES: Final = Path(__file__).parents[2] / "examples"
CART: Final = EXAMPLES / "cart.py"


def example(name: str) -> ModuleType:
    """Return a module, loaded anew."""
    spec = importlib.util.spec_from_file_location(f"example_{name}", EXAMPLES / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # annotations are looked up there
    spec.loader.exec_module(module)
    return module


@cache
def example_cart() -> ModuleType:
    """Return the robot with an arm of five joints, made from the public surface; loaded once."""
    return example("cart")
