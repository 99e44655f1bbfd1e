"""Describes what is linked into the programs, `parts.py TARGET FOLDER`:

FOLDER/LICENSES-OF-OTHERS.txt   each part, with its licence and what its authors want to be handed on
FOLDER/parts.cdx.json           the same list for programs, in CycloneDX 1.5
"""

import json
import os
import subprocess
import sys
import textwrap
import uuid
from collections.abc import Iterator
from datetime import datetime, timezone
from pathlib import Path
from typing import NamedTuple

PROGRAMS = ["-p", "dobot-cli", "-p", "dobot-ros2", "-p", "dobot-arm-python"]
FEATURES = ["--features", "dobot-cli/fleet,dobot-arm-python/full"]
LICENCE_FILES = ("LICENSE", "LICENCE", "COPYING", "NOTICE", "UNLICENSE", "COPYRIGHT")


class Part(NamedTuple):
    """Something that others made."""

    kind: str
    """Of its package URL: cargo or npm."""
    name: str
    version: str
    licence: str
    texts: list[Path]


def cargo(*arguments: str) -> str:
    return subprocess.run(["cargo", *arguments, "--locked"], check=True, stdout=subprocess.PIPE, text=True).stdout


def licence_files(folder: Path) -> list[Path]:
    return sorted(path for path in folder.iterdir() if path.is_file() and path.name.upper().startswith(LICENCE_FILES))


def crates(target: str) -> Iterator[Part]:
    tree = ("--edges", "normal", "--prefix", "none", "--format", "{p}")
    lines = cargo("tree", *PROGRAMS, *FEATURES, "--target", target, *tree).splitlines()
    # `name v1.2.3`, and a note in brackets behind some.
    linked = {tuple(line.split()[:2]) for line in lines if line}
    packages = json.loads(cargo("metadata", "--format-version", "1", "--all-features"))["packages"]
    for package in packages:
        name, version = package["name"], package["version"]
        if package["source"] and (name, f"v{version}") in linked:
            folder = Path(package["manifest_path"]).parent
            licence = (package["license"] or package["license_file"]).replace(" / ", "/").replace("/", " OR ")
            yield Part("cargo", name, version, licence, licence_files(folder))


def vendored() -> Iterator[Part]:
    """The libraries of the web page."""
    packages = json.loads(Path("page/package-lock.json").read_text())["packages"]
    for folder in sorted(Path("page/files/vendor").iterdir()):
        package = packages[f"node_modules/{folder.name}"]
        yield Part("npm", folder.name, package["version"], package["license"], licence_files(folder))


def fonts() -> Iterator[Part]:
    for path, licence in (
        ("crates/import/src/text/fonts/LICENSE-OFL", "OFL-1.1"),
        ("crates/lettering/src/hershey/LICENSE-HERSHEY", "LicenseRef-Hershey"),
    ):
        yield Part("generic", f"fonts-{Path(path).parent.name}", "0", licence, [Path(path)])


def notices(parts: list[Part]) -> str:
    """The list of parts, then each text once, with the parts that it belongs to."""
    users: dict[str, list[str]] = {}
    for part in parts:
        for path in part.texts:
            text = "\n".join(line.rstrip() for line in path.read_text(errors="replace").strip().splitlines())
            users.setdefault(text, []).append(part.name)
    lines = ["The programs contain the standard library of Rust (MIT OR Apache-2.0), and these parts:", ""]
    lines += [f"{part.name} {part.version}: {part.licence}" for part in parts]
    for text, names in users.items():
        lines += ["", "=" * 100, *textwrap.wrap("For " + ", ".join(dict.fromkeys(names)), 100), "", text]
    return "\n".join(lines) + "\n"


def component(part: Part) -> dict[str, object]:
    return {
        "type": "library",
        "bom-ref": f"pkg:{part.kind}/{part.name}@{part.version}",
        "name": part.name,
        "version": part.version,
        "licenses": [{"expression": part.licence}],
        "purl": f"pkg:{part.kind}/{part.name}@{part.version}",
    }


def bill(parts: list[Part], version: str) -> dict[str, object]:
    components = [component(part) for part in parts]
    date = datetime.fromtimestamp(int(os.environ["SOURCE_DATE_EPOCH"]), timezone.utc)
    return {
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "serialNumber": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, json.dumps(components))}",
        "version": 1,
        "metadata": {
            "timestamp": date.strftime("%Y-%m-%dT%H:%M:%SZ"),
            "component": {"type": "application", "name": "dobot", "version": version},
        },
        "components": components,
    }


target, folder = sys.argv[1], Path(sys.argv[2])
parts = [*sorted(crates(target)), *vendored(), *fonts()]
silent = [part.name for part in parts if not part.licence]
if silent:
    sys.exit(f"which licence have {', '.join(silent)}?")
folder.joinpath("LICENSES-OF-OTHERS.txt").write_text(notices(parts))
version = next(line.split('"')[1] for line in Path("Cargo.toml").read_text().splitlines() if line.startswith("version"))
folder.joinpath("parts.cdx.json").write_text(json.dumps(bill(parts, version), indent=1) + "\n")
