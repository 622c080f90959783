//! Files below one opened folder.

mod folder;
mod layout;
mod save;

pub use self::folder::{FileError, Folder};
pub use self::layout::{Layout, LayoutError, Note, Position};
pub use self::save::save;
