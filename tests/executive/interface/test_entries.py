"""The keys of the interface are listed from the modules that declare them."""

from __future__ import annotations

import re
from collections import Counter

from tandem.executive.interface.entries import all_entries

PLACEHOLDER = re.compile(r"<[^>]*>")


def test_each_key_is_listed_once() -> None:
    keys = Counter((type(each), PLACEHOLDER.sub("<>", each.key)) for each in all_entries())
    assert [key for key, times in keys.items() if times > 1] == []
