"""The arithmetic of leases: epochs only rise, and of two holders at most one is obeyed."""

from __future__ import annotations

import random

import pytest

from tandem.skills.ports.hardware import BaseVelocity
from tandem.skills.ports.lease import (
    KEPT_UNSEEN,
    Claim,
    Fence,
    Lease,
    LeaseBook,
    LeaseRequest,
    claim_name,
    present_claims,
)

A, B = Claim("aa", 1, 10, "host"), Claim("bb", 1, 20, "host")
NOBODY: frozenset[str] = frozenset()


def asked(claim: Claim, role: str = "executive") -> LeaseRequest:
    return LeaseRequest(role=role, claim=claim.text)


def granted(book: LeaseBook, claim: Claim, present: frozenset[str] = NOBODY, now: float = 0.0) -> Lease:
    answer = book.ask(asked(claim), present, now)
    assert answer.lease is not None, answer.reason
    return answer.lease


def obeyed(book: LeaseBook, lease: Lease | None) -> bool:
    return book.refuse(BaseVelocity(linear=0.1, angular=0.0, lease=lease)) is None


def test_the_first_who_asks_has_it_and_the_second_hears_who_that_is() -> None:
    book = LeaseBook("boot")
    lease = granted(book, A)
    assert lease == Lease(role="executive", boot="boot", epoch=1)
    refused = book.ask(asked(B), frozenset({A.text}), 100.0)
    assert refused.lease is None
    assert refused.holder == A.text
    assert "process 10 on host" in refused.reason


def test_asking_again_returns_the_same_lease() -> None:
    book = LeaseBook("boot")
    assert granted(book, A) == granted(book, A, frozenset({A.text}), 5.0)


def test_a_holder_whose_name_is_gone_is_replaced_with_a_higher_epoch_and_obeyed_no_more() -> None:
    book = LeaseBook("boot")
    old = granted(book, A)
    new = granted(book, B, NOBODY, KEPT_UNSEEN + 0.1)
    assert new.epoch == old.epoch + 1
    assert obeyed(book, new)
    assert not obeyed(book, old)
    refusal = book.refuse(BaseVelocity(linear=0.1, angular=0.0, lease=old))
    assert refusal is not None
    assert refusal.over
    assert "process 20 on host" in refusal.reason


def test_a_name_that_has_not_been_heard_yet_is_not_gone() -> None:
    book = LeaseBook("boot")
    granted(book, A)
    assert book.ask(asked(B), NOBODY, KEPT_UNSEEN / 2).holder == A.text


def test_a_later_process_of_the_same_parent_need_not_wait_for_the_dead_ones_name() -> None:
    book, again = LeaseBook("boot"), Claim("aa", 2, 11, "host")
    old = granted(book, A)
    new = granted(book, again, frozenset({A.text}), 0.01)
    assert new.epoch == 2
    assert not obeyed(book, old)
    assert book.ask(asked(A), frozenset({A.text, again.text}), 0.02).lease is None


def test_leases_of_another_boot_are_worth_nothing() -> None:
    old = granted(LeaseBook("before"), A)
    book = LeaseBook("after")
    assert not obeyed(book, old)
    granted(book, B)
    assert not obeyed(book, old)


def test_without_a_lease_all_is_obeyed_until_anybody_holds_one() -> None:
    book = LeaseBook("boot")
    assert obeyed(book, None)
    granted(book, A)
    assert not obeyed(book, None)
    assert book.table().refused == 1


def test_an_epoch_that_was_never_granted_is_refused() -> None:
    book = LeaseBook("boot")
    lease = granted(book, A)
    assert not obeyed(book, lease.model_copy(update={"epoch": 7}))
    assert not obeyed(book, lease.model_copy(update={"role": "base"}))


def test_roles_do_not_share_a_lease() -> None:
    book = LeaseBook("boot")
    arm = book.ask(asked(A, "arm_left"), NOBODY, 0.0).lease
    both = book.ask(asked(B, "bimanual"), NOBODY, 0.0).lease
    assert obeyed(book, arm)
    assert obeyed(book, both)


@pytest.mark.parametrize("seed", range(50))
def test_never_two_whose_commands_are_obeyed(seed: int) -> None:
    """Processes of three parents start, die, hang, come back and ask, in any order; the hardware restarts."""
    draw = random.Random(seed)  # noqa: S311 - no secret hangs on it
    boots, now = 0, 0.0
    book, fence = LeaseBook("boot0"), Fence("executive")
    leases: dict[Claim, Lease] = {}
    present: set[str] = set()
    generations = dict.fromkeys("abc", 0)
    last = 0
    for _ in range(300):
        now += draw.random()
        what = draw.choice(["start", "ask", "vanish", "return", "restart", "tell"])
        if what == "start":
            lineage = draw.choice("abc")
            generations[lineage] += 1
            claim = Claim(lineage, generations[lineage], 1, "h")
            present.add(claim.text)
            leases.pop(claim, None)
            answer = book.ask(asked(claim), frozenset(present), now)
            if answer.lease is not None:
                assert answer.lease.epoch > last
                leases[claim], last = answer.lease, answer.lease.epoch
        elif what == "ask" and leases:
            claim = draw.choice(sorted(leases, key=lambda each: each.text))
            answer = book.ask(asked(claim), frozenset(present), now)
            if answer.lease is not None:
                assert answer.lease.epoch >= last
                leases[claim], last = answer.lease, answer.lease.epoch
        elif what == "vanish" and present:
            present.remove(draw.choice(sorted(present)))
        elif what == "return" and leases:
            present.add(draw.choice(sorted(leases, key=lambda each: each.text)).text)
        elif what == "restart" and draw.random() < 0.1:
            boots, last = boots + 1, 0
            book = LeaseBook(f"boot{boots}")
        elif what == "tell":
            fence.learn(book.table())
        assert sum(obeyed(book, lease) for lease in leases.values()) <= 1
        fence.learn(book.table())
        assert sum(fence.refuse(lease) is None for lease in leases.values()) <= 1


def test_a_fence_learns_from_the_table_and_from_commands() -> None:
    book, fence = LeaseBook("boot"), Fence("executive")
    old = granted(book, A)
    assert fence.refuse(None) is None
    assert fence.refuse(old) is None
    assert fence.refuse(None) is not None
    new = granted(book, B, NOBODY, 9.0)
    assert not fence.is_over(old)
    fence.learn(book.table())
    assert fence.is_over(old)
    refusal = fence.refuse(old)
    assert refusal is not None
    assert refusal.over
    assert fence.refuse(new) is None


def test_a_fence_that_missed_the_table_believes_a_higher_epoch_and_no_older_table() -> None:
    book, fence = LeaseBook("boot"), Fence("executive")
    old = granted(book, A)
    table = book.table()
    new = granted(book, B, NOBODY, 9.0)
    assert fence.refuse(new) is None
    fence.learn(table)
    assert fence.refuse(old) is not None


def test_a_fence_follows_the_hardwares_boot() -> None:
    fence = Fence("executive")
    old = granted(LeaseBook("before"), A)
    assert fence.refuse(old) is None
    after = LeaseBook("after")
    fence.learn(after.table())
    refusal = fence.refuse(old)
    assert refusal is not None
    assert not refusal.over, "it may ask anew"
    assert fence.refuse(granted(after, A)) is None


def test_a_fence_takes_no_lease_of_another_role() -> None:
    lease = LeaseBook("boot").ask(asked(A, "base"), NOBODY, 0.0).lease
    assert Fence("executive").refuse(lease) is not None


def test_claims_survive_a_key_and_order_newcomers() -> None:
    assert Claim.read(A.text) == A
    assert Claim.read("what/ever") is None
    assert A.beats(B)
    assert not B.beats(A)
    later = Claim("aa", 2, 11, "host")
    assert later.beats(A)
    assert not A.beats(later)
    names = frozenset({claim_name("base", A), claim_name("executive", B), "process/base"})
    assert present_claims(names, "base") == {A.text}
