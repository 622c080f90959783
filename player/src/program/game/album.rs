//! Pictures of a game: one at every change of the tree.

use std::fs;
use std::path::{Path, PathBuf};

use bica::ComponentId;

use super::audience::Audience;
use super::scene::{GRAPH, Scene};
use super::sight::words;
use crate::program::ending::Failure;
use crate::program::picture::png;
use crate::program::picture::sheet::{Moment, Sheet};

/// Draws each change of the tree into a folder.
pub(crate) struct Album {
    folder: PathBuf,
    sheet: Sheet,
    /// Pictures drawn so far.
    pub(crate) count: usize,
}

impl Album {
    /// An empty album; makes the folder.
    pub(crate) fn new(folder: &Path) -> Result<Self, Failure> {
        make_folder(folder)?;
        Ok(Self { folder: folder.to_owned(), sheet: Sheet::new(&GRAPH), count: 0 })
    }
}

/// Makes a folder for pictures, with those above it.
pub(crate) fn make_folder(folder: &Path) -> Result<(), Failure> {
    let mend = "name a folder that can be made, or written to, with --pictures";
    fs::create_dir_all(folder).map_err(|error| Failure::of_path("make the folder", folder, &error, mend))
}

impl Audience for Album {
    fn changed(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        let tree = scene.tree();
        let state = tree.state(tree.graph.root).unwrap_or("-");
        let (ball, goal) = scene.sights();
        let named = |list: &[ComponentId], sign| {
            let names: Vec<_> = list.iter().map(|id| format!("{sign}{}", GRAPH.nodes[id.index()].name)).collect();
            names.join(" ")
        };
        let changes = [named(&scene.meter.started, '+'), named(&scene.meter.stopped, '-')].join(" ");
        let picture = self.sheet.draw(&Moment {
            title: &format!("{:.2} s   {state}   ball {}   goal {}", scene.t, words(ball), words(goal)),
            subtitle: &format!("seed {}   {changes}", scene.seed),
            image: scene.image(),
            marks: &scene.marks(),
            beliefs: &scene.beliefs(),
            truth: &scene.truth(),
            tree: &tree,
        });
        self.count += 1;
        let path = self.folder.join(format!("{:04}_{:07.2}s_{state}.png", self.count, scene.t));
        let mend = "is the disk full, or the folder write-protected?";
        png::write(&path, &picture).map_err(|error| Failure::of_path("write", &path, &error, mend))
    }
}
