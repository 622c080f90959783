//! Pictures of a game, one for each change of the tree.

use std::path::{Path, PathBuf};

use bica::ComponentId;
use bica_app::Failure;
use bica_drawing::png;
use bica_evaluation::pictures::make_folder;
use bica_evaluation::polar::describe;

use crate::game::observer::GameObserver;
use crate::game::pictures::sheet::{Sheet, Snapshot};
use crate::game::scene::{GRAPH, Scene};

/// Observer that writes a picture of each change of the tree into a folder.
#[derive(Debug)]
pub(crate) struct Album {
    folder: PathBuf,
    sheet: Sheet,
    count: usize,
}

impl Album {
    /// Creates an empty album and its folder.
    pub(crate) fn new(folder: &Path) -> Result<Self, Failure> {
        make_folder(folder)?;
        Ok(Self { folder: folder.to_owned(), sheet: Sheet::new(), count: 0 })
    }

    /// Number of pictures.
    pub(crate) const fn count(&self) -> usize {
        self.count
    }
}

impl GameObserver for Album {
    fn tree_changed(&mut self, scene: &Scene<'_>) -> Result<(), Failure> {
        let tree = scene.tree();
        let state = tree.state(tree.tree.root).unwrap_or("-");
        let (ball, goal) = scene.positions();
        let named = |list: &[ComponentId], sign| {
            let names: Vec<_> = list.iter().map(|id| format!("{sign}{}", GRAPH.nodes[id.index()].name)).collect();
            names.join(" ")
        };
        let changes = [named(&scene.meter.started, '+'), named(&scene.meter.stopped, '-')].join(" ");
        let picture = self.sheet.draw(&Snapshot {
            title: &format!("{:.2} s   {state}   ball {}   goal {}", scene.t, describe(ball), describe(goal)),
            subtitle: &format!("seed {}   {changes}", scene.seed),
            image: scene.image(),
            marks: &scene.marks(),
            estimates: &scene.estimates(),
            truth: &scene.truth(),
            tree: &tree,
        });
        self.count += 1;
        let path = self.folder.join(format!("{:04}_{:07.2}s_{state}.png", self.count, scene.t));
        let help = "is the disk full, or the folder write-protected?";
        png::write(&path, &picture).map_err(|error| Failure::of_path("write", &path, &error, help))
    }
}
