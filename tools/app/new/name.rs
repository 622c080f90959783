//! Names of crates.

use bica_app::Failure;

/// Keywords of Rust, names of its own libraries, and names of cargo's folders.
const RESERVED: &str = "abstract alloc as async await become box break build const continue core crate deps do dyn else enum \
    examples extern false final fn for gen if impl in incremental let loop macro match mod move mut override priv proc_macro \
    pub ref return self static std struct super test trait true try type typeof unsafe unsized use virtual where while yield";

/// Checks the name of a crate with this manifest.
///
/// # Errors
/// If cargo or Rust rejects it, or it is the name of a dependency.
pub(crate) fn check(name: &str, manifest: &str) -> Result<(), Failure> {
    let is_letter = |letter: char| letter.is_ascii_lowercase();
    let fits = name.chars().all(|c| is_letter(c) || c.is_ascii_digit() || c == '-' || c == '_');
    if !fits || !name.starts_with(is_letter) {
        let help = "use the letters a to z, digits, `-` and `_`, first a letter";
        return Err(Failure::new(format!("`{name}` is not the name of a crate"), help));
    }
    let in_code = name.replace('-', "_");
    if RESERVED.split_whitespace().any(|word| word == in_code) {
        return Err(Failure::new(format!("Rust keeps the name `{name}` for itself"), "choose another name"));
    }
    let keys = manifest.lines().filter_map(|line| Some(line.split_once(" = {")?.0.replace('-', "_")));
    if keys.chain(["bica".to_owned()]).any(|key| key == in_code) {
        return Err(Failure::new(format!("the new crate needs the crate `{name}`"), "choose another name"));
    }
    Ok(())
}
