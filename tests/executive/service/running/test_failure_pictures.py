"""What went wrong is told with the camera's picture of that moment."""

from __future__ import annotations

import pytest
from surroundings import Surroundings

from tandem.executive.service.running.failure_pictures import KEPT, KEPT_OF_A_TASK, PICTURE_WITHIN, Album
from tandem.skills.ports.actions.perception import PICTURE
from tandem.skills.ports.bus import Desk
from tandem.skills.ports.failure import Failure, FailureKind
from tandem.skills.ports.tasks import TASK_LIST, TASK_PICTURE, AskPicture, Attempt
from tandem.skills.wire.clocks import SteppedClocks
from tandem.skills.wire.memory import MemoryHub

WAIT = {"task": "wait", "item": 29}


@pytest.fixture
def here() -> Surroundings:
    here = Surroundings()
    here.ask(WAIT)
    return here


@pytest.fixture
def camera(here: Surroundings) -> Desk:
    return here.bus.serve(PICTURE)


def go_wrong(here: Surroundings, message: str = "empty") -> Attempt:
    failure = Failure(kind=FailureKind.GRASP_EMPTY, message=message)
    attempt = Attempt(at=here.clocks.robot(), failure=failure)
    here.executive.running.context.failures.attempts.append(attempt)
    here.step()
    return attempt


def ask(here: Surroundings, picture: str) -> bytes | None:
    asked = AskPicture(task="wait-0001", picture=picture).model_dump_json().encode()
    pending = here.bus.query(TASK_PICTURE, asked)
    here.step()
    return pending.poll()


def test_an_attempt_is_told_at_once_and_its_picture_when_it_comes(here: Surroundings, camera: Desk) -> None:
    attempt = go_wrong(here)
    assert here.told()[-1].tried == (attempt,)
    camera.drain()[0].reply(b"jpeg")
    here.step()
    assert here.told()[-1].tried[0].picture == "1"
    assert ask(here, "1") == b"jpeg"
    assert ask(here, "2") == b""


def test_an_attempt_told_anew_with_its_recovery_keeps_its_picture(here: Surroundings, camera: Desk) -> None:
    attempt = go_wrong(here)
    camera.drain()[0].reply(b"jpeg")
    here.step()
    here.executive.running.context.failures.attempts[0] = attempt.model_copy(
        update={"recovery": "again", "times": 1}
    )
    here.step()
    (told,) = here.told()[-1].tried
    assert (told.recovery, told.picture) == ("again", "1")
    assert camera.drain() == []


def test_a_camera_that_does_not_answer_holds_nothing_up(here: Surroundings, camera: Desk) -> None:
    go_wrong(here)
    here.step(1, seconds=PICTURE_WITHIN + 1.0)
    camera.drain()[0].reply(b"too late")
    go_wrong(here, "again")
    here.step()
    assert [each.picture for each in here.told()[-1].tried] == ["", ""]
    camera.drain()[0].reply(b"in time")
    here.step()
    assert [each.picture for each in here.told()[-1].tried] == ["", "2"]


def test_a_picture_that_comes_after_the_end_is_in_the_list(here: Surroundings, camera: Desk) -> None:
    here.executive.running.context.failures.attempts.append(
        Attempt(at=None, failure=Failure(kind=FailureKind.GRASP_EMPTY, message="empty"))
    )
    here.world(2)
    here.step(3)
    assert len([each for each in here.told() if each.state.terminal]) == 1
    camera.drain()[0].reply(b"jpeg")
    here.step()
    assert here.told() == []
    pending = here.bus.query(TASK_LIST.key, b"{}")
    here.step()
    (listed,) = TASK_LIST.decode_answer(pending.poll()).tasks
    assert [each.picture for each in listed.tried] == ["1"]


def test_the_album_is_bounded() -> None:
    album = Album(MemoryHub().endpoint(), SteppedClocks())
    for task in range(KEPT):
        for number in range(KEPT_OF_A_TASK + 2):
            album.keep(str(task), str(number), b"jpeg")
    assert sum(album.has(str(task), str(number)) for task in range(KEPT) for number in range(20)) == KEPT
    assert not album.has(str(KEPT - 1), "1")
    assert album.has(str(KEPT - 1), "2")
