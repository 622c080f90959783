//! Pictures and films of games.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use crate::process::{Folder, run};

fn size(path: &Path) -> (u32, u32) {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).unwrap())).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut bytes).unwrap();
    let colours: std::collections::HashSet<&[u8]> = bytes.chunks(3).collect();
    assert!(colours.len() > 50, "{} is nearly empty", path.display());
    (reader.info().width, reader.info().height)
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_every_change_of_the_tree_has_a_picture() {
    let folder = Folder::new("pictures");
    let printed = run(&["--seconds", "2", "--json", "--pictures", folder.text()]).json();
    let names = folder.names();
    assert_eq!(names.len() as u64, printed["tree_changes"].as_u64().unwrap());
    assert_eq!(names[0], "0001_0000.00s_look_for_ball.png");
    for name in &names {
        assert_eq!(size(&folder.path().join(name)), (1340, 1046));
    }
}

#[test]
fn each_game_of_a_series_has_a_folder() {
    let folder = Folder::new("albums");
    run(&["--seed", "8", "--games", "2", "--seconds", "0.1", "--size", "160x120", "--pictures", folder.text()]);
    assert_eq!(folder.names(), ["seed-8", "seed-9"]);
    size(&folder.path().join("seed-8/0001_0000.00s_look_for_ball.png"));
}

/// Returns width (px), height (px) and duration (hundredths of a second) of the pictures of a film.
fn film(path: &Path) -> Vec<(u16, u16, u16)> {
    let mut film = gif::Decoder::new(BufReader::new(File::open(path).unwrap())).unwrap();
    assert_eq!((film.width(), film.height()), (800, 360));
    let mut pictures = Vec::new();
    while let Some(picture) = film.read_next_frame().unwrap() {
        let colours: std::collections::HashSet<&u8> = picture.buffer.iter().collect();
        assert!(!pictures.is_empty() || colours.len() > 30, "{} is nearly empty", path.display());
        pictures.push((picture.width, picture.height, picture.delay));
    }
    pictures
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_film_does_not_change_the_game() {
    let folder = Folder::new("film");
    let path = folder.path().join("game.gif");
    let game = ["--seconds", "2", "--json", "--size", "160x120"];
    let filmed = run(&[&game[..], &["--film", path.to_str().unwrap()]].concat()).json();
    let pictures = film(&path);
    assert_eq!(pictures.len(), 29);
    assert_eq!(pictures[0], (800, 360, 7));
    assert!(pictures[1..28].iter().all(|picture| picture.2 == 7) && pictures[28].2 > 100);
    assert_eq!(filmed["fingerprint"], run(&game).json()["fingerprint"]);
}
