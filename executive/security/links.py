"""Log-ins to the page: a word that the holder of a key signs, good for one page, once, and for ten minutes.

The signature is made with the holder's own key, so that nobody else can make one, and no password is kept
anywhere. The page checks it with the public certificate of the authority, and by the list of holders.
"""

from __future__ import annotations

import base64
import datetime as dt
import secrets
from pathlib import Path
from typing import Final

from cryptography import x509
from cryptography.exceptions import InvalidSignature
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec
from cryptography.x509.oid import NameOID
from pydantic import ValidationError

from tandem.executive.security.holders import AUTHORITY, Holder, KeysError, read_holders, role_in
from tandem.executive.security.identity import Identity
from tandem.skills.ports.message import Message

LASTS: Final = 600.0
"""Seconds for which a word is good: to carry it to a browser."""
SKEW: Final = 60.0
"""Seconds by which the clocks of two hosts may differ."""
LONGEST: Final = 4096
"""Characters of a word."""


class LinkError(ValueError):
    """A word that does not open the page; says why, and what to do."""


class Pass(Message):
    """What is signed."""

    page: str
    """Origin of the page that it opens, such as ``https://robot.example:8447``."""
    made: float
    """UTC seconds."""
    nonce: str
    """Names this word."""


class _Word(Message):
    signed: str
    certificate: str
    signature: str


def make(identity: Identity, page: str, now: float) -> str:
    """Return a word that opens a page in the name of a key's holder.

    Raises:
        KeysError: naming the file that is missing, or may be read by others.
    """
    files = identity.client()
    signed = Pass(page=page, made=now, nonce=secrets.token_hex(16)).model_dump_json().encode()
    key = serialization.load_pem_private_key(files.key.read_bytes(), password=None)
    if not isinstance(key, ec.EllipticCurvePrivateKey):
        raise KeysError(f"{files.key}: expected a key of `tandem keys new`; found another kind")
    certificate = x509.load_pem_x509_certificate(files.certificate.read_bytes())
    word = _Word(
        signed=_text(signed),
        certificate=_text(certificate.public_bytes(serialization.Encoding.DER)),
        signature=_text(key.sign(signed, ec.ECDSA(hashes.SHA256()))),
    )
    return _text(word.model_dump_json().encode())


def check(word: str, folder: Path, page: str, now: float) -> tuple[Holder, Pass]:
    """Return whose word it is; whether it was used before is the page's to know.

    Args:
        word: as ``make`` made it.
        folder: of keys, with the authority's certificate and the list of holders.
        page: origin of the page that is to be opened.
        now: UTC seconds.

    Raises:
        LinkError: for any that does not open it.
        KeysError: when the folder is not as it must be.
    """
    try:
        parts = _Word.model_validate_json(_bytes(word[:LONGEST]))
        signed, certificate = _bytes(parts.signed), x509.load_der_x509_certificate(_bytes(parts.certificate))
        asked = Pass.model_validate_json(signed)
        authority = x509.load_pem_x509_certificate((folder / f"{AUTHORITY}.pem").read_bytes())
        certificate.verify_directly_issued_by(authority)
        key = certificate.public_key()
        if not isinstance(key, ec.EllipticCurvePublicKey):
            raise _wrong("it was not signed with a key of `tandem keys`")
        key.verify(_bytes(parts.signature), signed, ec.ECDSA(hashes.SHA256()))
    except (ValidationError, InvalidSignature, ValueError, TypeError) as error:
        raise _wrong("it is none, or not whole, or of another authority") from error
    if asked.page != page:
        raise _wrong(f"it is for {asked.page}, and this is {page}")
    if not -SKEW <= now - asked.made <= LASTS:
        raise _wrong(f"it is good for {LASTS / 60:.0f} minutes, and was made {now - asked.made:.0f} s ago")
    return _holder(certificate, folder, now), asked


def valid(holder: Holder, folder: Path, now: float) -> bool:
    """Say whether a holder's key is still good: neither expired, nor revoked, nor made anew."""
    known = next((each for each in read_holders(folder).holders if each.serial == holder.serial), None)
    return known is not None and not known.revoked and known.expires_at > now


def _holder(certificate: x509.Certificate, folder: Path, now: float) -> Holder:
    serial = f"{certificate.serial_number:x}"
    known = next((each for each in read_holders(folder).holders if each.serial == serial), None)
    common = str(certificate.subject.get_attributes_for_oid(NameOID.COMMON_NAME)[0].value)
    if known is None or known.common_name != common:
        raise _wrong("its key is not in the list of keys")
    if known.revoked or known.expires_at <= now or certificate.not_valid_after_utc.timestamp() <= now:
        raise _wrong(f"the key of {known.name} is {'revoked' if known.revoked else 'expired'}")
    if role_in(common) in {None, "robot"}:
        raise _wrong("a robot's key opens no page; use the key of a person")
    return known


def _wrong(why: str) -> LinkError:
    return LinkError(f"this log-in does not open the page: {why}; make another one with `tandem keys link`")


def _text(data: bytes) -> str:
    return base64.urlsafe_b64encode(data).decode().rstrip("=")


def _bytes(text: str) -> bytes:
    return base64.urlsafe_b64decode(text + "=" * (-len(text) % 4))


def utc() -> float:
    """Return the seconds of the host's calendar clock."""
    return dt.datetime.now(dt.UTC).timestamp()
