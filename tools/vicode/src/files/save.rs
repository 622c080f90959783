//! Atomic saving.

use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process;
use std::sync::atomic::{AtomicU64, Ordering};

/// Counter for the names of temporary files of this process.
static COUNT: AtomicU64 = AtomicU64::new(0);

/// Replaces the content of a file atomically, by renaming a temporary file beside it.
///
/// # Errors
/// If the disk is full, or the system does not allow it. The file is unchanged then, and the temporary one is removed.
pub fn save(path: &Path, content: &[u8], permissions: Option<Permissions>) -> io::Result<()> {
    let temporary = temporary(path);
    let written = write(&temporary, content, permissions).and_then(|()| fs::rename(&temporary, path));
    if written.is_err() {
        // The first error is returned. Removal fails if the temporary file was never created.
        let _ = fs::remove_file(&temporary);
        return written;
    }
    // The rename is durable only after the folder is synchronised; some systems cannot open folders.
    if let Some(folder) = path.parent().and_then(|folder| File::open(folder).ok()) {
        let _ = folder.sync_all();
    }
    Ok(())
}

/// Returns a temporary name beside the file, without the ending `.rs`, so that no build reads it.
fn temporary(path: &Path) -> PathBuf {
    let mut name = std::ffi::OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}-{}.vicode-tmp", process::id(), COUNT.fetch_add(1, Ordering::Relaxed)));
    path.with_file_name(name)
}

fn write(path: &Path, content: &[u8], permissions: Option<Permissions>) -> io::Result<()> {
    let mut file = OpenOptions::new().write(true).create_new(true).open(path)?;
    if let Some(permissions) = permissions {
        file.set_permissions(permissions)?;
    }
    file.write_all(content)?;
    file.sync_all()
}
