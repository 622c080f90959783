//! JavaScript libraries of JManager's page.
//!
//! The libraries come from npm in exact versions, are compared with the SHA-512 of their packages, and are written to
//! tools/jmanager/page/vendor. There they are ES modules that import each other by relative paths, so that the page needs
//! neither an import map nor another host.

mod bundle;

use std::fs;
use std::path::{Path, PathBuf};

use crate::process::{output, root, run};

const FOLDER: &str = "tools/jmanager/page/vendor";

/// A package, its checksum, and its files: the path in the package, and the name in the folder.
struct Library {
    package: &'static str,
    version: &'static str,
    sha512: &'static str,
    licence: &'static str,
    files: &'static [(&'static str, &'static str)],
}

const LIBRARIES: &[Library] = &[
    Library {
        package: "preact",
        version: "10.29.8",
        sha512: "7a3d9a559faf67c58eeedbe541644cf4deb70342b317dab899625f0d41e061a2287d663d86eef841d9d0ae3a0f326662dbf9d9e603746c9090178f7142ac74f5",
        licence: "LICENSE",
        files: &[("dist/preact.mjs", "preact.js"), ("hooks/dist/hooks.mjs", "hooks.js")],
    },
    Library {
        package: "@preact/signals-core",
        version: "1.14.5",
        sha512: "bdc46fec8b72cf925599e895a8896e2c5cd3fcf0d2fc09611d4a70dff6945aa71552ce9b0c620f5c4ffa4520b87af04d598be79e2a338394b27e3df76a5de092",
        licence: "LICENSE",
        files: &[("dist/signals-core.mjs", "signals-core.js")],
    },
    Library {
        package: "@preact/signals",
        version: "2.11.4",
        sha512: "45bfb944fa3d81649a1edcc979aba11f1882f0a3ff205d8310f9073c43863a7bb2db09c9cd1ab278b45a9e450261de800eab714ba1a7586bfa21edf8dddf1a63",
        licence: "LICENSE",
        files: &[("dist/signals.mjs", "signals.js")],
    },
    Library {
        package: "htm",
        version: "3.1.1",
        sha512: "f7cdd5ca0f0dc1413b26467a3663aaa4267eb21d5b2afda2613954933956980e490f669c2a8c5de0a5716cc9b15fff399ad7dd9c399316834a720e43180bf135",
        licence: "LICENSE",
        files: &[("dist/htm.mjs", "htm.js")],
    },
    Library {
        package: "uplot",
        version: "1.6.32",
        sha512: "2883159c6ebccefbb95d751b0b82d010f9e1c0ec41b8bc96d401eda66e882935c89a46cb824332fa369b8cb8122cc6ac36e186cd09bf7a9ded3a4c93c6989023",
        licence: "LICENSE",
        files: &[("dist/uPlot.esm.js", "uplot.js"), ("dist/uPlot.min.css", "uplot.css")],
    },
    Library {
        package: "dockview-core",
        version: "8.6.0",
        sha512: "0538f498221d3f9aedb21021540f5bab2d7834e2989ecf9f04926f15b536c72daf90af5a88331ff2b402bdf786faa1750fe4c80dcf8e2d3f21f6696043a3c714",
        licence: "LICENCE.md",
        files: &[("dist/package/main.esm.min.mjs", "dockview.js")],
    },
    // The same library; this package contains its style sheet.
    Library {
        package: "dockview",
        version: "8.6.0",
        sha512: "f2f07bf6f88e8326127acf15ccf78729c9d9585b7cd615f789b3989dfdb205b7a0366f5282847c9d4de7df10c7dc29e4ab9b76c65e57e2194155165e239b3c1c",
        licence: "LICENCE.md",
        files: &[("dist/styles/dockview.css", "dockview.css")],
    },
];

/// Module names in import statements, and the files that they become.
const MODULES: [(&str, &str); 3] =
    [("preact/hooks", "./hooks.js"), ("preact", "./preact.js"), ("@preact/signals-core", "./signals-core.js")];

/// Writes the libraries, or compares them with what is in the folder.
///
/// # Errors
/// If a package cannot be fetched, has another checksum, or (with `check`) the folder has other contents.
pub(crate) fn vendor(check: bool) -> Result<(), String> {
    let folder = root().join(FOLDER);
    let mut files = vec![("README.md".to_owned(), readme().into_bytes())];
    for library in LIBRARIES {
        let package = unpack(library)?;
        let name = library.package.trim_start_matches('@').replace('/', "-");
        files.push((format!("{name}.LICENSE.txt"), read(&package.join(library.licence))?));
        for (from, to) in library.files {
            let text = String::from_utf8(read(&package.join(from))?).map_err(|_| format!("{from} is not UTF-8"))?;
            files.push(((*to).to_owned(), relative(&text).into_bytes()));
        }
    }
    files.extend(bundle::bundle()?);
    if check {
        return compare(&folder, &files);
    }
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).map_err(|error| format!("cannot make {FOLDER}: {error}"))?;
    for (name, bytes) in &files {
        fs::write(folder.join(name), bytes).map_err(|error| format!("cannot write {FOLDER}/{name}: {error}"))?;
        println!("{:>8} bytes  {FOLDER}/{name}", bytes.len());
    }
    Ok(())
}

/// Fetches and unpacks a package; returns its folder.
fn unpack(library: &Library) -> Result<PathBuf, String> {
    let Library { package, version, sha512, .. } = library;
    let folder = root().join("target/vendor").join(package.replace('/', "-"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).map_err(|error| format!("cannot make {}: {error}", folder.display()))?;
    let place = folder.to_string_lossy().into_owned();
    let archive =
        output("npm", &["pack", "--silent", "--pack-destination", &place, &format!("{package}@{version}")], &[])?;
    let archive = folder.join(archive.trim());
    let found = output("sha512sum", &[&archive.to_string_lossy()], &[])?;
    let found = found.split_whitespace().next().unwrap_or_default();
    if found != *sha512 {
        return Err(format!("{package} {version} has the SHA-512\n  {found}, expected\n  {sha512}"));
    }
    run("tar", &["-xzf", &archive.to_string_lossy(), "-C", &place], &[])?;
    Ok(folder.join("package"))
}

/// Replaces names of modules by relative paths, and removes links to source maps.
fn relative(text: &str) -> String {
    let mut text = text.to_owned();
    for (module, path) in MODULES {
        for quote in ['"', '\''] {
            text = text.replace(&format!("from{quote}{module}{quote}"), &format!("from{quote}{path}{quote}"));
        }
    }
    let kept: Vec<_> = text.lines().filter(|line| !line.starts_with("//# sourceMappingURL")).collect();
    kept.join("\n") + "\n"
}

fn readme() -> String {
    let row = |library: &Library| {
        let files: Vec<_> = library.files.iter().map(|(_, to)| *to).collect();
        let name = library.package.trim_start_matches('@').replace('/', "-");
        let licence = if library.package == "htm" { "Apache-2.0" } else { "MIT" };
        let Library { package, version, .. } = library;
        format!("| {package} | {version} | {} | {licence}, {name}.LICENSE.txt |\n", files.join(", "))
    };
    let rows: String = LIBRARIES.iter().map(row).collect();
    format!(
        "# Libraries of the page\n\nWritten by `cargo xtask vendor`; do not edit. Module names in imports are replaced by relative \
         paths, links to source maps are removed, and esbuild joins the packages of {}; nothing else is changed.\n\n\
         | package | version | files | licence |\n|---|---|---|---|\n{rows}{}",
        bundle::FILE,
        bundle::rows()
    )
}

fn compare(folder: &Path, files: &[(String, Vec<u8>)]) -> Result<(), String> {
    for (name, bytes) in files {
        if read(&folder.join(name))? != *bytes {
            return Err(format!("{FOLDER}/{name} differs from its package: run `cargo xtask vendor`"));
        }
    }
    let entries = fs::read_dir(folder).map_err(|error| format!("cannot read {FOLDER}: {error}"))?;
    if entries.count() != files.len() {
        return Err(format!("{FOLDER} contains files of no package: run `cargo xtask vendor`"));
    }
    println!("{FOLDER}: {} files as in their packages", files.len());
    Ok(())
}

fn read(path: &Path) -> Result<Vec<u8>, String> {
    fs::read(path).map_err(|error| format!("cannot read {}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn imports_become_relative_and_source_maps_go() {
        let text = "import{h}from\"preact\";import{x}from'preact/hooks';export{s}from\"@preact/signals-core\";\n//# sourceMappingURL=a.map\n";
        let expected = "import{h}from\"./preact.js\";import{x}from'./hooks.js';export{s}from\"./signals-core.js\";\n";
        assert_eq!(relative(text), expected);
    }
}
