"""What the process of a role says of a mistake that is its user's, and of one that is the program's."""

from __future__ import annotations

import pytest

from tandem.executive.config.process_settings import REFUSED, RefusalError
from tandem.executive.system.worker import ended
from tandem.skills.ports.sources import DocumentError
from tandem.skills.ports.urdf_check import UrdfError


@pytest.mark.parametrize(
    ("error", "code", "trace"),
    [
        (RefusalError("another one has the role"), REFUSED, False),
        (DocumentError("lab.yaml: reflexes.0: no reflex 'avoyd'"), 1, False),
        (UrdfError("joint 'elbow': a revolute joint needs a <limit>"), 1, False),
        (RuntimeError("a mistake of ours"), 1, True),
    ],
    ids=lambda value: type(value).__name__,
)
def test_only_mistakes_of_the_program_leave_a_trace(
    error: Exception, code: int, *, trace: bool, caplog: pytest.LogCaptureFixture
) -> None:
    def work() -> None:
        raise error

    assert ended(work, "base") == code
    (record,) = caplog.records
    assert (record.exc_info is not None) == trace
    assert (str(error) in record.getMessage()) == (not trace)
