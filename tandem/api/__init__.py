"""What a package of your own may import: these modules, ``tandem.client`` and ``tandem.testing``.

``docs/api/`` lists each name. A name that stands there is removed or changed with a new ``VERSION`` only; all
other modules of Tandem may change at any time.
"""

from __future__ import annotations

from typing import Final

VERSION: Final = "0.1"
"""Of the surface: the first number changes when a name is removed or changed, the second when one is added.
While the first is 0, a name may change with the second, and the CHANGELOG says so."""

__all__ = ["VERSION"]
