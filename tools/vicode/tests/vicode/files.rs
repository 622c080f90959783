//! Files: whole, below the folder, never overwritten.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use bica_vicode::{FileError, Folder, Layout, Note, Position};

static COUNT: AtomicU64 = AtomicU64::new(0);

/// An empty folder of its own.
pub(crate) fn scratch() -> PathBuf {
    let name = format!("files-{}-{}", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(&path).unwrap();
    path
}

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn changed_file_is_never_overwritten() {
    let path = scratch();
    fs::write(path.join("a.rs"), "one").unwrap();
    let folder = Folder::open(&path).unwrap();
    let read = folder.read("a.rs").unwrap();
    folder.save("a.rs", &read, "two").unwrap();
    assert_eq!(folder.read("a.rs").unwrap(), "two");
    assert!(matches!(folder.save("a.rs", "one", "three"), Err(FileError::Changed(now)) if now == "two"));
    assert_eq!(folder.read("a.rs").unwrap(), "two");
    assert_eq!(names(&path), ["a.rs"], "no temporary file is left");
    fs::remove_file(path.join("a.rs")).unwrap();
    assert!(matches!(folder.save("a.rs", "two", "three"), Err(FileError::Missing(_))));
    assert_eq!(names(&path), Vec::<String>::new());
    fs::remove_dir_all(path).unwrap();
}

#[cfg(unix)]
#[test]
fn permissions_and_read_only_files_stay() {
    use std::os::unix::fs::PermissionsExt;
    let path = scratch();
    let file = path.join("a.rs");
    fs::write(&file, "one").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    let folder = Folder::open(&path).unwrap();
    folder.save("a.rs", "one", "two").unwrap();
    assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o640);
    fs::set_permissions(&file, fs::Permissions::from_mode(0o440)).unwrap();
    assert!(matches!(folder.save("a.rs", "two", "three"), Err(FileError::ReadOnly(_))));
    assert_eq!(folder.read("a.rs").unwrap(), "two");
    fs::remove_dir_all(path).unwrap();
}

#[test]
fn no_name_leads_outside_the_folder() {
    let path = scratch();
    fs::create_dir(path.join("in")).unwrap();
    fs::write(path.join("out.rs"), "secret").unwrap();
    fs::write(path.join("in/a.txt"), "text").unwrap();
    fs::write(path.join("in/bytes.rs"), [0xff, 0xfe]).unwrap();
    let folder = Folder::open(&path.join("in")).unwrap();
    let absolute = path.join("out.rs").display().to_string();
    for name in ["../out.rs", "./../out.rs", "a/../../out.rs", &absolute, "", ".", "a\0.rs", "..\\out.rs", "x\n.rs"] {
        let error = folder.read(name).unwrap_err();
        assert!(matches!(error, FileError::Outside(_) | FileError::Missing(_)), "{name:?} {error}");
        assert!(folder.create(name, "x").is_err() && folder.save(name, "secret", "x").is_err(), "{name:?}");
    }
    assert!(matches!(folder.read("a.txt"), Err(FileError::NoSource(_))));
    assert!(matches!(folder.read("bytes.rs"), Err(FileError::NoSource(_))));
    assert_eq!(fs::read_to_string(path.join("out.rs")).unwrap(), "secret");
    fs::remove_dir_all(path).unwrap();
}

#[cfg(unix)]
#[test]
fn no_link_leads_outside_the_folder() {
    use std::os::unix::fs::symlink;
    let path = scratch();
    fs::create_dir_all(path.join("in")).unwrap();
    fs::create_dir_all(path.join("other")).unwrap();
    fs::write(path.join("other/out.rs"), "secret").unwrap();
    symlink(path.join("other/out.rs"), path.join("in/link.rs")).unwrap();
    symlink(path.join("other"), path.join("in/folder")).unwrap();
    let folder = Folder::open(&path.join("in")).unwrap();
    for name in ["link.rs", "folder/out.rs"] {
        assert!(matches!(folder.read(name), Err(FileError::Outside(_))), "{name}");
        assert!(matches!(folder.save(name, "secret", "x"), Err(FileError::Outside(_))), "{name}");
    }
    assert!(matches!(folder.create("folder/new.rs", "x"), Err(FileError::Outside(_))));
    assert!(matches!(folder.create("link.rs", "x"), Err(FileError::Exists(_))));
    assert_eq!(fs::read_to_string(path.join("other/out.rs")).unwrap(), "secret");
    fs::remove_dir_all(path).unwrap();
}

#[test]
fn layout_lines_are_sorted_and_read_back() {
    let mut layout = Layout::default();
    layout.set("Player", "walk", Position { x: 3, y: -4 });
    layout.set("Eye<320, 240>", "look", Position { x: 1, y: 2 });
    layout.set("Player", "kick", Position { x: 5, y: 6 });
    assert_eq!(layout.to_string(), "Eye look 1 2\nPlayer kick 5 6\nPlayer walk 3 -4\n");
    assert_eq!(Layout::parse(&layout.to_string()), Ok(layout.clone()));
    layout.remove("Eye<1, 2>", "look");
    let note = |at, text: &str| Note { at, text: text.to_owned() };
    layout.add_note("Player", note(Some(Position { x: -1, y: 2 }), "two\n\"lines\""));
    layout.add_note("Player", note(None, "Other * 1 2"));
    let text =
        "Player * - - \"Other * 1 2\"\nPlayer * -1 2 \"two\\n\\\"lines\\\"\"\nPlayer kick 5 6\nPlayer walk 3 -4\n";
    assert_eq!(layout.to_string(), text);
    assert_eq!(Layout::parse(text), Ok(layout));
    assert_eq!(Layout::parse("A * 1 2 no string\n").unwrap_err().line, 1);
    let error = Layout::parse("A b 1 2\n<<<<<<< HEAD\n").unwrap_err();
    assert_eq!((error.line, &*error.found), (2, "<<<<<<< HEAD"));
}
