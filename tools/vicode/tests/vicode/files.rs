//! Access to files: atomic, only below the folder, without overwriting changes of others.

use std::fs;

use bica_test_data::process::Folder as Scratch;
use bica_vicode::{FileError, Folder, Layout, Note, Position};

#[test]
fn changed_file_is_never_overwritten() {
    let path = Scratch::new("files");
    fs::write(path.file("a.rs"), "one").unwrap();
    let folder = Folder::open(path.path()).unwrap();
    let read = folder.read("a.rs").unwrap();
    folder.save("a.rs", &read, "two").unwrap();
    assert_eq!(folder.read("a.rs").unwrap(), "two");
    assert!(matches!(folder.save("a.rs", "one", "three"), Err(FileError::Changed(now)) if now == "two"));
    assert_eq!(folder.read("a.rs").unwrap(), "two");
    assert_eq!(path.names(), ["a.rs"], "no temporary file is left");
    fs::remove_file(path.file("a.rs")).unwrap();
    assert!(matches!(folder.save("a.rs", "two", "three"), Err(FileError::Missing(_))));
    assert_eq!(path.names(), Vec::<String>::new());
}

#[cfg(unix)]
#[test]
fn permissions_and_read_only_files_stay() {
    use std::os::unix::fs::PermissionsExt;
    let path = Scratch::new("files");
    let file = path.file("a.rs");
    fs::write(&file, "one").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    let folder = Folder::open(path.path()).unwrap();
    folder.save("a.rs", "one", "two").unwrap();
    assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o640);
    fs::set_permissions(&file, fs::Permissions::from_mode(0o440)).unwrap();
    assert!(matches!(folder.save("a.rs", "two", "three"), Err(FileError::ReadOnly(_))));
    assert_eq!(folder.read("a.rs").unwrap(), "two");
}

#[test]
fn no_name_leads_outside_the_folder() {
    let path = Scratch::new("files");
    fs::create_dir(path.file("in")).unwrap();
    fs::write(path.file("out.rs"), "secret").unwrap();
    fs::write(path.file("in/a.txt"), "text").unwrap();
    fs::write(path.file("in/bytes.rs"), [0xff, 0xfe]).unwrap();
    let folder = Folder::open(&path.0.join("in")).unwrap();
    let absolute = path.file("out.rs");
    for name in ["../out.rs", "./../out.rs", "a/../../out.rs", &absolute, "", ".", "a\0.rs", "..\\out.rs", "x\n.rs"] {
        let error = folder.read(name).unwrap_err();
        assert!(matches!(error, FileError::Outside(_) | FileError::Missing(_)), "{name:?} {error}");
        assert!(folder.create(name, "x").is_err() && folder.save(name, "secret", "x").is_err(), "{name:?}");
    }
    assert!(matches!(folder.read("a.txt"), Err(FileError::NoSource(_))));
    assert!(matches!(folder.read("bytes.rs"), Err(FileError::NoSource(_))));
    assert_eq!(fs::read_to_string(path.file("out.rs")).unwrap(), "secret");
}

#[cfg(unix)]
#[test]
fn no_link_leads_outside_the_folder() {
    use std::os::unix::fs::symlink;
    let path = Scratch::new("files");
    fs::create_dir_all(path.file("in")).unwrap();
    fs::create_dir_all(path.file("other")).unwrap();
    fs::write(path.file("other/out.rs"), "secret").unwrap();
    symlink(path.file("other/out.rs"), path.file("in/link.rs")).unwrap();
    symlink(path.file("other"), path.file("in/folder")).unwrap();
    let folder = Folder::open(&path.0.join("in")).unwrap();
    for name in ["link.rs", "folder/out.rs"] {
        assert!(matches!(folder.read(name), Err(FileError::Outside(_))), "{name}");
        assert!(matches!(folder.save(name, "secret", "x"), Err(FileError::Outside(_))), "{name}");
    }
    assert!(matches!(folder.create("folder/new.rs", "x"), Err(FileError::Outside(_))));
    assert!(matches!(folder.create("link.rs", "x"), Err(FileError::Exists(_))));
    assert_eq!(fs::read_to_string(path.file("other/out.rs")).unwrap(), "secret");
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
