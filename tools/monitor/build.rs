//! Tables of the page's files, which the server contains, and of the modules that it loads first.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let folder = Path::new(&env::var("CARGO_MANIFEST_DIR").map_err(io::Error::other)?).join("page");
    println!("cargo:rerun-if-changed={}", folder.display());
    let mut files = Vec::new();
    list(&folder, &mut files)?;
    files.sort();
    let mut table = "&[\n".to_owned();
    for file in &files {
        let name = file.strip_prefix(&folder).map_err(io::Error::other)?.to_string_lossy().replace('\\', "/");
        writeln!(table, "    ({name:?}, include_bytes!({:?})),", file.display().to_string())
            .map_err(io::Error::other)?;
    }
    table.push(']');
    let target = PathBuf::from(env::var("OUT_DIR").map_err(io::Error::other)?).join("page.rs");
    fs::write(&target, table)?;
    fs::write(target.with_file_name("first.rs"), format!("&{:?}", first(&folder)?))
}

/// The modules that `app.js` imports, directly or through others; what is imported by a call is loaded later.
fn first(folder: &Path) -> io::Result<Vec<String>> {
    let mut found = vec!["app.js".to_owned()];
    let mut at = 0;
    while let Some(name) = found.get(at).cloned() {
        at += 1;
        let text = fs::read_to_string(folder.join(&name))?;
        for part in ["from", "import"].iter().flat_map(|word| text.split(word).skip(1)) {
            let mut quoted = part.trim_start_matches(' ').splitn(3, ['\'', '"']);
            let (Some(""), Some(path)) = (quoted.next(), quoted.next()) else { continue };
            let mut whole: Vec<&str> = name.split('/').collect();
            whole.pop();
            for step in path.split('/') {
                match step {
                    "." => {}
                    ".." => drop(whole.pop()),
                    step => whole.push(step),
                }
            }
            let other = whole.join("/");
            if path.starts_with('.') && !found.contains(&other) && folder.join(&other).is_file() {
                found.push(other);
            }
        }
    }
    Ok(found)
}

fn list(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    println!("cargo:rerun-if-changed={}", folder.display());
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            list(&path, files)?;
        } else {
            files.push(path);
        }
    }
    Ok(())
}
