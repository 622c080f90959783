//! VICODE: state machines of BICA, read from their Rust source and edited there.
//!
//! The Rust file is the only source. [`read()`] derives a [`Model`](model::Model) from any text, also from one with syntax errors. A
//! [`Document`] is an open file: it applies [`Edit`]s as [`Splice`]s of the text, undoes them, and merges changes of the file on disk.
//! Bytes outside the splices stay unchanged. The rules are those of the macros, checked by the macros' own code.
//!
//! ```
//! use bica_vicode::{Document, Edit};
//!
//! let mut document = Document::new("#[component]\nimpl Player {\n    #[state(initial)]\n    fn look(&mut self) {}\n}\n");
//! let edits: Vec<Edit> = serde_json::from_str(
//!     r#"[{"edit": "add_state", "component": "Player", "name": "walk"},
//!         {"edit": "add_transition", "component": "Player", "name": "seen", "from": ["look"], "to": "walk"}]"#,
//! )?;
//! document.apply(&edits)?;
//! assert!(document.text().contains("#[transition(look -> walk)]\n    fn seen(&self) -> bool {\n        false\n    }"));
//! document.undo();
//! assert!(!document.is_changed());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod cli;
pub mod compare;
pub mod coverage;
mod document;
pub mod draw;
mod edit;
mod files;
mod fix;
pub mod model;
mod read;
pub mod trial;

pub use self::document::{Change, Conflict, Document, External, Keep};
pub use self::edit::{
    DEFAULT_WIDTH, Edit, NewNumber, Refusal, Splice, Target, Use, applied, blank, declare, enlist, inverse, module_of,
    ordered, plan, reads, uses,
};
pub use self::files::{FileError, Folder, Layout, LayoutError, Note, Position, save};
pub use self::fix::{Fix, fixes};
pub use self::read::{TreeSource, read, trees};

#[cfg(doctest)]
#[doc = include_str!("../../../docs/vicode.md")]
struct Page;
