"""The project's own certificate authority: makes keys and certificates for mutual TLS, with ``cryptography``.

With ``links`` the only module that imports it. Keys are on the curve P-256. A client's certificate is for
clients only; the router's is for servers too, so that nobody else's passes for the router's.
"""

from __future__ import annotations

import datetime as dt
import ipaddress
import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from cryptography import x509
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec
from cryptography.x509.oid import ExtendedKeyUsageOID, NameOID

from tandem.executive.security.holders import (
    AUTHORITY,
    LIST,
    NAME,
    Holder,
    Holders,
    KeysError,
    common_name,
    read_holders,
    write_holders,
)
from tandem.executive.security.role import PARTS, Part, Role

LOOPBACK: Final = ("localhost", "127.0.0.1", "::1")
"""Names under which every router may be reached."""
DAYS: Final = 365
"""For which a holder's certificate is valid unless said otherwise; chosen: keys are made anew once a year."""
AUTHORITY_DAYS: Final = 3650
"""For which the authority's own is; chosen, as a new authority means new keys for every holder."""
BACKDATED: Final = dt.timedelta(minutes=5)
"""Clocks of two hosts may differ by this."""


@dataclass(frozen=True)
class Wanted:
    """A key that is asked for: who, for how many days, and for a router the hosts that it is reached at."""

    role: Role
    name: str
    days: int = DAYS
    hosts: tuple[str, ...] = ()


def begin(folder: Path, now: dt.datetime) -> None:
    """Make the authority and an empty list of holders.

    Raises:
        KeysError: when there is an authority in the folder already.
    """
    _refuse_existing([folder / f"{AUTHORITY}.key", folder / f"{AUTHORITY}.pem", folder / LIST])
    folder.mkdir(parents=True, exist_ok=True)
    key = ec.generate_private_key(ec.SECP256R1())
    subject = _named("tandem.ca")
    usage = x509.KeyUsage(
        digital_signature=False,
        content_commitment=False,
        key_encipherment=False,
        data_encipherment=False,
        key_agreement=False,
        key_cert_sign=True,
        crl_sign=True,
        encipher_only=False,
        decipher_only=False,
    )
    certificate = (
        _builder(subject, subject, key.public_key(), now, AUTHORITY_DAYS)
        .add_extension(x509.BasicConstraints(ca=True, path_length=0), critical=True)
        .add_extension(usage, critical=True)
        .sign(key, hashes.SHA256())
    )
    _write(folder, AUTHORITY, key, certificate)
    write_holders(folder, Holders())


def issue(folder: Path, wanted: Wanted, now: dt.datetime) -> tuple[Holder, ...]:
    """Make a key and a certificate, for a robot one for each of its parts; return who holds them.

    Raises:
        KeysError: for a name that is none or taken, for existing files, and without an authority.
    """
    if NAME.fullmatch(wanted.name) is None:
        raise KeysError(
            f"expected a name: up to 32 of a-z 0-9 _ -, first a letter or digit; found {wanted.name!r}"
        )
    if wanted.name == AUTHORITY:
        raise KeysError(f"{AUTHORITY!r} is the authority's own name; take another")
    if wanted.hosts and wanted.role != "robot":
        raise KeysError(f"only a robot's router is reached at a host; a {wanted.role} needs none")
    known = read_holders(folder)
    _refuse_taken(known, wanted.name, now)
    parts: tuple[Part | None, ...] = PARTS if wanted.role == "robot" else (None,)
    ca_key, ca_certificate = _authority(folder)
    made = [_issue_one(wanted, part, ca_key, ca_certificate, now) for part in parts]
    _refuse_existing(
        folder / f"{holder.stem}.{end}"
        for holder, _, _ in made
        for end in ("key", "pem")
        if not known.named(wanted.name)
    )
    for holder, key, certificate in made:
        _write(folder, holder.stem, key, certificate)
    holders = tuple(holder for holder, _, _ in made)
    kept = tuple(holder for holder in known.holders if holder.name != wanted.name)
    write_holders(folder, Holders(holders=(*kept, *holders)))
    return holders


def revoke(folder: Path, name: str) -> tuple[Holder, ...]:
    """Note that a name's keys no longer hold; return its entries.

    Raises:
        KeysError: naming those that there are, for a name that is none of them.
    """
    known = read_holders(folder)
    if not known.named(name):
        there = ", ".join(dict.fromkeys(holder.name for holder in known.holders)) or "none"
        raise KeysError(f"no key was made for {name!r} in {folder}; there are {there}")
    after = Holders(
        holders=tuple(
            holder.model_copy(update={"revoked": True}) if holder.name == name else holder
            for holder in known.holders
        )
    )
    write_holders(folder, after)
    return after.named(name)


def common_name_of(certificate: Path) -> str:
    """Return the common name that a certificate's file tells.

    Raises:
        KeysError: when it is no certificate.
    """
    found = _load(certificate).subject.get_attributes_for_oid(NameOID.COMMON_NAME)
    return str(found[0].value) if found else ""


def hosts_of(certificate: Path) -> frozenset[str]:
    """Return the hosts that a router's certificate is for."""
    try:
        names = _load(certificate).extensions.get_extension_for_class(x509.SubjectAlternativeName).value
    except x509.ExtensionNotFound:
        return frozenset()
    found = (*names.get_values_for_type(x509.DNSName), *names.get_values_for_type(x509.IPAddress))
    return frozenset(str(each) for each in found)


def _issue_one(
    wanted: Wanted,
    part: Part | None,
    ca_key: ec.EllipticCurvePrivateKey,
    ca_certificate: x509.Certificate,
    now: dt.datetime,
) -> tuple[Holder, ec.EllipticCurvePrivateKey, x509.Certificate]:
    key = ec.generate_private_key(ec.SECP256R1())
    common = common_name(wanted.role, wanted.name, part)
    uses = [ExtendedKeyUsageOID.CLIENT_AUTH]
    if part == "router":
        uses.append(ExtendedKeyUsageOID.SERVER_AUTH)
    builder = (
        _builder(_named(common), ca_certificate.subject, key.public_key(), now, wanted.days)
        .add_extension(x509.BasicConstraints(ca=False, path_length=None), critical=True)
        .add_extension(x509.ExtendedKeyUsage(uses), critical=False)
    )
    if part == "router":
        hosts = dict.fromkeys((*LOOPBACK, *wanted.hosts))
        builder = builder.add_extension(
            x509.SubjectAlternativeName([_host(each) for each in hosts]), critical=False
        )
    certificate = builder.sign(ca_key, hashes.SHA256())
    holder = Holder(
        name=wanted.name,
        role=wanted.role,
        part=part,
        serial=f"{certificate.serial_number:x}",
        expires_at=certificate.not_valid_after_utc.timestamp(),
    )
    return holder, key, certificate


def _builder(
    subject: x509.Name, issuer: x509.Name, key: ec.EllipticCurvePublicKey, now: dt.datetime, days: int
) -> x509.CertificateBuilder:
    return (
        x509.CertificateBuilder()
        .subject_name(subject)
        .issuer_name(issuer)
        .public_key(key)
        .serial_number(x509.random_serial_number())
        .not_valid_before(now - BACKDATED)
        .not_valid_after(now + dt.timedelta(days=days))
    )


def _named(common: str) -> x509.Name:
    return x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, common)])


def _host(host: str) -> x509.GeneralName:
    try:
        return x509.IPAddress(ipaddress.ip_address(host))
    except ValueError:
        return x509.DNSName(host)


def _refuse_taken(known: Holders, name: str, now: dt.datetime) -> None:
    for holder in known.named(name):
        if holder.revoked:
            raise KeysError(
                f"{name!r} was revoked: a new key of this name would make the old one hold again; "
                "take another name"
            )
        if holder.expires_at > now.timestamp():
            raise KeysError(f"{name!r} has a key already, as {holder.role}; take another name")


def _refuse_existing(files: Iterable[Path]) -> None:
    for file in files:
        if file.exists():
            raise KeysError(f"{file} exists already, and is not overwritten; move it, or take another folder")


def _authority(folder: Path) -> tuple[ec.EllipticCurvePrivateKey, x509.Certificate]:
    path = folder / f"{AUTHORITY}.key"
    try:
        key = serialization.load_pem_private_key(path.read_bytes(), password=None)
    except FileNotFoundError:
        raise KeysError(f"{path}: no such file; keys are made where `tandem keys init` was called") from None
    except ValueError as error:
        raise KeysError(f"{path}: not a private key: {error}") from error
    if not isinstance(key, ec.EllipticCurvePrivateKey):
        raise KeysError(f"{path}: expected a key on an elliptic curve")
    return key, _load(folder / f"{AUTHORITY}.pem")


def _load(certificate: Path) -> x509.Certificate:
    try:
        return x509.load_pem_x509_certificate(certificate.read_bytes())
    except FileNotFoundError:
        raise KeysError(f"{certificate}: no such file; `tandem keys new` makes it") from None
    except ValueError as error:
        raise KeysError(f"{certificate}: not a certificate: {error}") from error


def _write(folder: Path, stem: str, key: ec.EllipticCurvePrivateKey, certificate: x509.Certificate) -> None:
    private = key.private_bytes(
        serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
    )
    path = folder / f"{stem}.key"
    path.unlink(missing_ok=True)  # of an expired certificate; a file that exists keeps its mode
    with os.fdopen(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "wb") as file:
        file.write(private)
    (folder / f"{stem}.pem").write_bytes(certificate.public_bytes(serialization.Encoding.PEM))
