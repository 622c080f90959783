//! Pictures of a game: one at every change of the tree.

use std::path::{Path, PathBuf};

use bica::ComponentId;

use super::scene::{GRAPH, Scene};
use crate::observer::Observer;
use bica_console::{Failure, make_folder};
use bica_drawing::png;
use bica_drawing::polar::words;
use bica_drawing::sheet::{Moment, Sheet};

/// Draws each change of the tree into a folder.
pub struct Album {
    folder: PathBuf,
    sheet: Sheet,
    /// Pictures drawn so far.
    pub count: usize,
}

impl Album {
    /// An empty album; makes the folder.
    pub fn new(folder: &Path) -> Result<Self, Failure> {
        make_folder(folder)?;
        Ok(Self { folder: folder.to_owned(), sheet: Sheet::new(&GRAPH), count: 0 })
    }
}

impl Observer for Album {
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
