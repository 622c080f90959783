#!/usr/bin/env python3
"""Writes the JavaScript libraries of JManager's page: `python3 tools/monitor/vendor.py [--check]`.

Fetches the exact versions in vendor.json from npm, compares the SHA-512 of their packages, and writes them to page/vendor. There they
are ES modules that import each other by relative paths, so that the page needs neither an import map nor another host. esbuild joins
the packages of the editor CodeMirror, and what the page uses of three.js; the same versions give the same bytes. With --check it only
compares the folder. Needed only for a change of versions: the result is in the repository.
"""

import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile

HERE = pathlib.Path(__file__).resolve().parent
FOLDER = HERE / "page/vendor"
WORK = HERE.parents[1] / "target/vendor"
MODULES = {"preact/hooks": "hooks.js", "preact": "preact.js", "@preact/signals-core": "signals-core.js"}


def flat(package):
    return package.lstrip("@").replace("/", "-")


def unpack(library):
    """Fetches a package, compares its checksum, and returns its folder."""
    folder = WORK / flat(library["package"])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    name = f"{library['package']}@{library['version']}"
    command = ["npm", "pack", "--silent", "--pack-destination", str(folder), name]
    archive = folder / subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.strip()
    found = hashlib.sha512(archive.read_bytes()).hexdigest()
    if found != library["sha512"]:
        sys.exit(f"{name} has the SHA-512\n  {found}, expected\n  {library['sha512']}")
    with tarfile.open(archive) as packed:
        packed.extractall(folder)
    return folder / "package"


def relative(text):
    """Replaces names of modules by relative paths, and removes links to source maps."""
    for module, file in MODULES.items():
        text = re.sub(rf"from(['\"]){module}\1", rf"from\1./{file}\1", text)
    return "\n".join(line for line in text.splitlines() if not line.startswith("//# sourceMappingURL")) + "\n"


def licences_of(parts):
    return f"{parts['file'].removesuffix('.js')}.LICENSE.txt"


def bundle(esbuild, parts):
    """Returns the joined module and the licences of its packages."""
    modules = WORK / "bundle/node_modules"
    shutil.rmtree(modules.parent, ignore_errors=True)
    licences = ""
    for library in parts["packages"]:
        folder, place = unpack(library), modules / library["package"]
        licence = (folder / "LICENSE").read_text().rstrip()
        licences += f"{library['package']} {library['version']}\n\n{licence}\n\n"
        place.parent.mkdir(parents=True, exist_ok=True)
        folder.rename(place)
    entry, result = modules.parent / "entry.js", modules.parent / parts["file"]
    entry.write_text("\n".join(parts["entry"]) + "\n")
    options = "--bundle --format=esm --minify --charset=utf8 --legal-comments=none --log-level=warning".split()
    subprocess.run([esbuild, entry, *options, f"--outfile={result}"], check=True)
    return {parts["file"]: result.read_text(), licences_of(parts): licences}


def readme(versions):
    rows = []
    for library in versions["libraries"]:
        licence = "Apache-2.0" if library["package"] == "htm" else "MIT"
        rows.append((library, ", ".join(library["files"].values()), licence, f"{flat(library['package'])}.LICENSE.txt"))
    for parts in versions["bundles"]:
        rows += [(library, parts["file"], "MIT", licences_of(parts)) for library in parts["packages"]]
    joined = " and ".join(parts["file"] for parts in versions["bundles"])
    table = "".join(f"| {row['package']} | {row['version']} | {files} | {kind}, {licence} |\n" for row, files, kind, licence in rows)
    return (
        "# Libraries of the page\n\nWritten by `python3 tools/monitor/vendor.py`; do not edit. Module names in imports are replaced "
        f"by relative\npaths, links to source maps are removed, and esbuild joins the packages of {joined};\nnothing else "
        f"is changed.\n\n| package | version | files | licence |\n|---|---|---|---|\n{table}"
    )


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    versions = json.loads((HERE / "vendor.json").read_text())
    files = {"README.md": readme(versions)}
    for library in versions["libraries"]:
        folder = unpack(library)
        files[f"{flat(library['package'])}.LICENSE.txt"] = (folder / library["licence"]).read_text()
        files |= {to: relative((folder / source).read_text()) for source, to in library["files"].items()}
    esbuild = unpack(versions["esbuild"]) / "bin/esbuild"
    for parts in versions["bundles"]:
        files |= bundle(esbuild, parts)
    if sys.argv[1:]:
        present = {path.name: path.read_text() for path in FOLDER.iterdir()}
        wrong = sorted(name for name in files.keys() | present.keys() if files.get(name) != present.get(name))
        sys.exit(f"differs from the packages: {', '.join(wrong)}" if wrong else None)
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir()
    for name, text in files.items():
        (FOLDER / name).write_text(text)
        print(f"{len(text.encode()):>8} bytes  {name}")


if __name__ == "__main__":
    main()
