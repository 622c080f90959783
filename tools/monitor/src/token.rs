//! The token file: its secret admits pages on other computers.

use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::Path;

use crate::protocol::Failed;
use crate::{files, web};

/// Smallest length of a secret, characters.
const MIN_LENGTH: usize = 32;
const HELP: &str = "remove the file: a new one is made with a random secret";

/// Reads the secret, or creates the file with a new one. Returns the secret, and whether the file is new.
pub(crate) fn read(path: &Path) -> Result<(String, bool), Failed> {
    if !path.exists() {
        return make(path).map(|token| (token, true));
    }
    check_mode(path)?;
    let text = fs::read_to_string(path).map_err(|error| files::failed("read", path, &error, HELP))?;
    let token = text.trim();
    if token.len() < MIN_LENGTH || token.contains(|letter: char| !letter.is_ascii_graphic()) {
        let what = format!("`{}` contains no secret of at least {MIN_LENGTH} characters", path.display());
        return Err(Failed::new(what, HELP));
    }
    Ok((token.to_owned(), false))
}

fn make(path: &Path) -> Result<String, Failed> {
    let failure = |error: std::io::Error| files::failed("write", path, &error, "choose another place for it");
    let token = web::secret().map_err(failure)?;
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    let mut file = options.open(path).map_err(failure)?;
    writeln!(file, "{token}").map_err(failure)?;
    Ok(token)
}

/// Refuses a file that other users of the computer can read.
#[cfg(unix)]
fn check_mode(path: &Path) -> Result<(), Failed> {
    use std::os::unix::fs::PermissionsExt;
    let failure = |error| files::failed("read", path, &error, HELP);
    let mode = fs::metadata(path).map_err(failure)?.permissions().mode() & 0o777;
    if mode & 0o077 != 0 {
        let what = format!("other users can read `{}` (mode {mode:o})", path.display());
        return Err(Failed::new(what, format!("chmod 600 {}", path.display())));
    }
    Ok(())
}

#[cfg(not(unix))]
fn check_mode(_: &Path) -> Result<(), Failed> {
    Ok(())
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::fs::PermissionsExt;

    use bica_test_data::process::Folder;

    use super::*;

    #[test]
    fn a_new_file_is_for_its_owner_only_and_is_read_again() {
        let folder = Folder::new("token");
        let path = folder.path().join("token");
        let (token, new) = read(&path).unwrap();
        assert!(new && token.len() == 64);
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o600);
        assert_eq!(read(&path).unwrap(), (token, false));
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
        assert!(read(&path).is_err());
        fs::set_permissions(&path, fs::Permissions::from_mode(0o600)).unwrap();
        fs::write(&path, "short").unwrap();
        assert!(read(&path).is_err());
    }
}
