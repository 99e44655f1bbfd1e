"""The certificate of a fleet, for a peer in Python."""

import json
from pathlib import Path

import zenoh


def tls_of(config: zenoh.Config, folder: Path, *sides: str) -> None:
    """Lets a peer connect, or listen, with the certificate in a folder that `dobot fleet certificates` has made."""
    files = {name: str((folder / f"{name}.pem").absolute()) for name in ("authority", "certificate", "key")}
    tls: dict[str, str | bool] = {"root_ca_certificate": files["authority"], "enable_mtls": True}
    for side in sides:
        tls |= {f"{side}_certificate": files["certificate"], f"{side}_private_key": files["key"]}
    for key, value in tls.items():
        config.insert_json5(f"transport/link/tls/{key}", json.dumps(value))
