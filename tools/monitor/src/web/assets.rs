//! Files of the page.

use std::borrow::Cow;

/// Media type of modules.
pub(crate) const SCRIPT: &str = "text/javascript; charset=utf-8";

/// Name and contents of each file of the page.
const FILES: &[(&str, &[u8])] = include!(concat!(env!("OUT_DIR"), "/page.rs"));

/// Returns a file of the page and its media type. Only names in the table exist, so no path leads out of the page's folder. A debug
/// build reads the file from disk, so that a change of the page needs no build.
pub(crate) fn file(name: &str) -> Option<(Cow<'static, [u8]>, &'static str)> {
    let (name, bytes) = FILES.iter().find(|(known, _)| *known == name)?;
    let media = media_type(name)?;
    if cfg!(debug_assertions) {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/page/");
        if let Ok(bytes) = std::fs::read(format!("{path}{name}")) {
            return Some((Cow::Owned(bytes), media));
        }
    }
    Some((Cow::Borrowed(bytes), media))
}

/// Modules that the page needs at its start. The modules of a panel are loaded when it is first opened.
const FIRST: &[&str] = include!(concat!(env!("OUT_DIR"), "/first.rs"));

/// Returns the page, with a preload link to each module of [`FIRST`]. Without these links a browser finds a module only when it has
/// read the importing one, level by level.
pub(crate) fn page() -> (String, &'static str) {
    let (bytes, media) = file("index.html").unwrap_or_default();
    let modules = FIRST.iter().chain(&["extensions.js"]);
    let links =
        modules.fold(String::new(), |links, name| links + "<link rel=\"modulepreload\" href=\"" + name + "\">\n");
    let text = String::from_utf8_lossy(&bytes);
    (text.replace("<script", &(links + "<script")), media)
}

fn media_type(name: &str) -> Option<&'static str> {
    Some(match name.rsplit_once('.')?.1 {
        "html" => "text/html; charset=utf-8",
        "js" => SCRIPT,
        "css" => "text/css; charset=utf-8",
        "svg" => "image/svg+xml",
        "txt" | "md" => "text/plain; charset=utf-8",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_file_has_a_media_type() {
        for (name, _) in FILES {
            assert!(file(name).is_some(), "{name}");
        }
    }

    #[test]
    fn editors_and_plots_are_not_loaded_with_the_page() {
        for name in
            ["vendor/codemirror.js", "vendor/three.js", "vendor/uplot.js", "panels/vicode.js", "motion/panel.js"]
        {
            assert!(file(name).is_some() && !FIRST.contains(&name), "{name}");
        }
        assert!(
            ["lib/dom.js", "vendor/preact.js", "panels/tree.js"].iter().all(|name| FIRST.contains(name)),
            "{FIRST:?}"
        );
    }

    #[test]
    fn no_text_is_declared_below_11_px() {
        for (name, bytes) in FILES.iter().filter(|(name, _)| !name.starts_with("vendor/") && media_type(name).is_some())
        {
            for part in String::from_utf8_lossy(bytes).split("font").skip(1) {
                let Some((before, _)) = part.split_once("px") else { continue };
                let digits = before.trim_end_matches(|one: char| one.is_ascii_digit() || one == '.').len();
                // A size farther away belongs to something else.
                if !before.contains(';')
                    && before.len() < 24
                    && let Ok(size) = before[digits..].parse::<f32>()
                {
                    assert!(size >= 11.0, "{name}: font{before}px");
                }
            }
        }
    }

    #[test]
    fn modules_import_from_their_own_host_only() {
        for (name, bytes) in
            FILES.iter().filter(|(name, _)| media_type(name).is_some_and(|media| media.starts_with("text/javascript")))
        {
            let text = std::str::from_utf8(bytes).unwrap();
            for quote in ['"', '\''] {
                for part in text.split("from").skip(1) {
                    let Some(path) = part.trim_start_matches(' ').strip_prefix(quote) else { continue };
                    let path = path.split(quote).next().unwrap();
                    // Only possible paths of modules: messages contain the word `from`, too.
                    if path.len() < 80 && !path.contains([' ', ',', '(']) && !path.is_empty() {
                        assert!(path.starts_with("./") || path.starts_with("../"), "{name} imports `{path}`");
                    }
                }
            }
        }
    }
}
