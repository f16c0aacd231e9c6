"""``examples/cart.py`` as a module: a robot with an arm of five joints, made from the public surface."""

from __future__ import annotations

import importlib.util
import sys
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Final

CART: Final = Path(__file__).parents[2] / "examples" / "cart.py"


@cache
def example_cart() -> ModuleType:
    """Return the module."""
    spec = importlib.util.spec_from_file_location("example_cart", CART)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # annotations are looked up there
    spec.loader.exec_module(module)
    return module
