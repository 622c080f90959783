//! Drawings that the page wants laid out.

use bica_drawing::layout::{Arrow, LOOKS, Link, Machine, Tree, add_queries, path};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::Failed;

/// Largest number of boxes and of links of a drawing; a layout takes a time that grows with their product.
const MAX_BOXES: usize = 1000;
const MAX_LINKS: usize = 5000;
/// Largest size of a box or a panel, px.
const MAX_SIZE: f64 = 1e5;

/// A drawing to lay out. The page measures its texts, so sizes come from it, px.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Arrange {
    /// An activation tree in a panel.
    Tree {
        /// Widths of the components.
        widths: Vec<f64>,
        /// Links: from, to, and the number of the trunk with which a link shares its lines.
        links: Vec<(usize, usize, usize)>,
        /// Queries: from, and of; their lines follow those of the links.
        #[serde(default)]
        queries: Vec<(usize, usize)>,
        /// Width and height of the panel.
        size: (f64, f64),
        /// Least and largest height of a component.
        heights: (f64, f64),
    },
    /// A state machine that nobody arranged.
    Machine {
        /// Width and height of each state, for each of [`LOOKS`].
        looks: [Vec<(f64, f64)>; LOOKS.len()],
        /// Index of the initial state.
        initial: usize,
        /// Transitions.
        arrows: Vec<Arrow>,
        /// Width by height of the panel.
        shape: f64,
    },
}

impl Arrange {
    /// Lays the drawing out: of a tree `{"boxes", "width", "height", "lines": paths}`, of a machine for each look `{"boxes",
    /// "area", "courses": list of {"d", "label", "start", "end", "owner"}}`.
    ///
    /// # Errors
    /// If it is too large, or an index or a size is wrong.
    pub fn answer(&self) -> Result<Value, Failed> {
        self.check()?;
        Ok(match self {
            Self::Tree { widths, links, queries, size, heights } => {
                let link =
                    |(from, to, trunk): &(usize, usize, usize)| Link { from: *from, to: *to, trunk: *trunk, side: 0.0 };
                let mut links: Vec<Link> = links.iter().map(link).collect();
                add_queries(&mut links, queries.iter().copied());
                let Tree { boxes, lines, width, height } = Tree::new(&links, widths, *size, *heights);
                let lines: Vec<String> = lines.iter().map(|line| path(line)).collect();
                json!({ "boxes": boxes, "width": width, "height": height, "lines": lines })
            }
            Self::Machine { looks, initial, arrows, shape } => {
                let looks = looks.iter().zip(&LOOKS);
                looks.map(|(sizes, look)| machine(&Machine::new(sizes, *initial, arrows, *shape, look))).collect()
            }
        })
    }

    fn check(&self) -> Result<(), Failed> {
        let is_size = |(width, height): &(f64, f64)| [width, height].iter().all(|one| **one > 0.0 && **one <= MAX_SIZE);
        let is_valid = match self {
            Self::Tree { widths, links, queries, size, heights } => {
                let count = widths.len();
                let are_links =
                    links.iter().all(|(from, to, trunk)| *from < count && *to < count && *trunk <= links.len());
                let are_queries = queries.iter().all(|(from, of)| *from < count && *of < count && from != of);
                let is_small = count <= MAX_BOXES && links.len() + queries.len() <= MAX_LINKS;
                is_small
                    && are_links
                    && are_queries
                    && widths.iter().all(|one| is_size(&(*one, 1.0)))
                    && is_size(size)
                    && is_size(heights)
            }
            Self::Machine { looks, initial, arrows, shape } => {
                let count = looks[0].len();
                let is_arrow = |arrow: &Arrow| {
                    arrow.to < count && arrow.from.is_none_or(|from| from < count) && is_size(&(arrow.width, 1.0))
                };
                let are_sizes = looks.iter().all(|sizes| sizes.len() == count && sizes.iter().all(is_size));
                let is_small = count <= MAX_BOXES && arrows.len() <= MAX_LINKS;
                is_small
                    && are_sizes
                    && *initial <= count
                    && arrows.iter().all(is_arrow)
                    && (0.01..100.0).contains(shape)
            }
        };
        let failed = || Failed::new("this drawing is too large, or not complete", "split the machine into several");
        if is_valid { Ok(()) } else { Err(failed()) }
    }
}

fn machine(Machine { boxes, courses, area }: &Machine) -> Value {
    let course = |of: &bica_drawing::layout::Course| {
        let d = path(&of.leader) + &path(&of.points);
        json!({ "d": d, "label": of.label, "start": of.points.first(), "end": of.points.last(), "owner": of.owner })
    };
    json!({ "boxes": boxes, "area": area, "courses": courses.iter().map(course).collect::<Vec<_>>() })
}
